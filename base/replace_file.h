#pragma once
/// \file
/// Replaces files so that a reader sees the old contents or the new, never a part.

#include <functional>
#include <string>
#include <string_view>

namespace shellmatch {

/// How the names of files that are being written begin. What a killed process has left is found by it.
inline constexpr std::string_view partial_file_prefix = ".partial-";

/// The name under which this process writes `path` before it renames it: `.partial-PID-NAME` in the same folder, so that
/// processes do not disturb each other and the extension is the same.
std::string partial_file_name(const std::string& path);

/// Calls `write` with that name and renames the file. \throws EnvironmentError if it cannot be renamed, and whatever
/// `write` throws; no partial file is left
void replace_file(const std::string& path, const std::function<void(const std::string&)>& write);

/// The same with these contents. \throws EnvironmentError naming `path`: disk full, no permission
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace shellmatch
