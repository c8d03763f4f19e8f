#pragma once
/// \file
/// Writes whole files, and reports failures to do so.

#include <filesystem>
#include <string>
#include <string_view>

namespace shellmatch {

/// Writes a whole file. \throws EnvironmentError naming the file: disk full, no permission.
void write_file(const std::string& path, std::string_view contents);

/// Waits until the contents of a file, or the entries of a folder, are on the disk. \throws EnvironmentError as
/// write_file
void synchronise_file(const std::string& path);

/// Throws EnvironmentError for the system's error number `error`.
[[noreturn]] void cannot_write(const std::string& path, int error);

/// Whether the folder is the root of a mounted file system, which can be filled but not renamed. False where it is not
/// there.
bool is_mount_point(const std::filesystem::path& folder);

}  // namespace shellmatch
