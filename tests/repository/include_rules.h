#pragma once
/// \file
/// Which file may include what: docs/conventions.md, "Folders" and "Adapters".

#include "tests/repository/source_tree.h"

namespace shellmatch::repository {

/// The project's own includes: written from the repository root, of a file that is there, and along the one
/// direction in which the folders depend on each other.
std::vector<Finding> check_include_direction(const SourceTree& tree);

/// Includes of other libraries: only in the library's adapter, and in headers only the standard library and Eigen.
/// Headers that the sources of one adapter share (geometry/repair/cgal_repair_mesh.h) may be included by that adapter
/// only. Tests may include any library.
std::vector<Finding> check_adapters(const SourceTree& tree);

}  // namespace shellmatch::repository
