#pragma once
/// \file
/// Rules for the text of all files: length, no trace of one machine, documents that point to what is there.

#include "tests/repository/source_tree.h"

namespace shellmatch::repository {

/// Sources, scripts and CMake files of more than `most` lines.
std::vector<Finding> check_lengths(const SourceTree& tree, std::size_t most = 400);

/// Absolute paths of somebody's machine, and hosts of package registries.
std::vector<Finding> check_machine_paths(const SourceTree& tree);

/// Links of Markdown files to files and headings that are not there, and `folder/file.ext` between backticks
/// that names no file of the repository (a '*' may stand for part of a name).
std::vector<Finding> check_links(const SourceTree& tree);

/// Packages that cmake/Dependencies.cmake finds for the modules and that the installed package forgets.
std::vector<Finding> check_dependencies(const SourceTree& tree);

}  // namespace shellmatch::repository
