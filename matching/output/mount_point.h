#pragma once
/// \file
/// Folders that cannot be renamed.

#include <filesystem>

namespace shellmatch {

/// Whether the folder is the root of a mounted file system, which can be filled but not renamed. False where it is not
/// there.
bool is_mount_point(const std::filesystem::path& folder);

}  // namespace shellmatch
