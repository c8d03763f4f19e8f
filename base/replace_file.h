#pragma once
/// \file
/// Replaces files so that a reader sees the old contents or the new, never a part.

#include <functional>
#include <string>
#include <string_view>

namespace shellmatch {

/// Whether a file of this name has been left by a process that was killed while it wrote: `.partial-RANDOM.EXTENSION`.
bool is_partial_file_name(std::string_view name);

/// Creates an empty file of such a name in the folder of `path`, with a name that nothing had before: no link
/// is followed and no file is lost. Its extension is that of `path`. \throws EnvironmentError naming `path`
std::string create_partial_file(const std::string& path);

/// Calls `write` with the name of such a file and renames it to `path`. \throws EnvironmentError if it cannot be created
/// or renamed, and whatever `write` throws; no partial file is left
void replace_file(const std::string& path, const std::function<void(const std::string&)>& write);

/// The same with these contents. \throws EnvironmentError naming `path`: disk full, no permission
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace shellmatch
