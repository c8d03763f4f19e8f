#pragma once
/// \file
/// Rules for the structure of the source tree: no cycles, small folders, tests beside what they test.
///
/// A folder that holds sources directly is a room. X.h and X.cpp of one folder are one unit.

#include "tests/repository/source_tree.h"

#include <string_view>
#include <vector>

namespace shellmatch::repository {

/// Most .h and .cpp files of one room.
inline constexpr std::size_t max_room_files = 24;

/// Units that include each other, directly or through others: one finding for each strongly connected set, at an
/// include directive of its shortest cycle through the first unit.
std::vector<Finding> check_unit_cycles(const SourceTree& tree);

/// Rooms with more than `most` sources.
std::vector<Finding> check_room_sizes(const SourceTree& tree, std::size_t most = max_room_files);

/// Sources, scripts and CMake files of more than `most` lines.
std::vector<Finding> check_lengths(const SourceTree& tree, std::size_t most = 400);

/// Rooms of one top folder that include each other, directly or through others. The rooms of `exceptions` (top
/// folders) and of tests/ are not looked at.
std::vector<Finding> check_room_cycles(const SourceTree& tree, const std::vector<std::string_view>& exceptions = {});

/// Folders tests/A/B for which there is no folder A/B. tests/install, tests/repository and tests/support test no
/// folder of sources.
std::vector<Finding> check_test_folders(const SourceTree& tree);

}  // namespace shellmatch::repository
