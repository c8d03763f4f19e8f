#pragma once
/// \file
/// The rule for tests/mutations.txt: every error of the list can be made in the sources as they are.

#include "tests/repository/source_tree.h"

namespace shellmatch::repository {

/// Headings that name no file or a test program that no CMakeLists.txt makes, errors whose old text does not occur
/// in their file exactly once, and errors that change nothing. The format stands at the head of scripts/mutate.
std::vector<Finding> check_mutations(const SourceTree& tree);

}  // namespace shellmatch::repository
