#pragma once
/// \file
/// Folders that tests read from.

#include <filesystem>

namespace shellmatch::test {

/// The repository.
std::filesystem::path source_folder();

/// Shapes that the repository does not contain: SHELLMATCH_DATA, or ../shared/data beside the repository. It need not
/// exist: tests that need it skip then and say so.
std::filesystem::path data_folder();

}  // namespace shellmatch::test
