#pragma once
/// \file
/// Which file may include what: docs/conventions.md, "Folders" and "Doors".

#include "tests/repository/source_tree.h"

namespace shellmatch::repository {

/// The project's own includes: written from the repository root, of a file that is there, and along the one
/// direction in which the folders depend on each other.
std::vector<Finding> check_include_direction(const SourceTree& tree);

/// Includes of other libraries: only behind the library's door, and in headers only the standard library and
/// Eigen. Headers that the sources behind a door share (geometry/cgal_*.h) are read there only. Tests are
/// free.
std::vector<Finding> check_doors(const SourceTree& tree);

}  // namespace shellmatch::repository
