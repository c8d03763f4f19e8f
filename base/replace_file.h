#pragma once
/// \file
/// Replaces files so that a reader sees the old contents or the new, never a part, also after a power cut.

#include <functional>
#include <string>
#include <string_view>

namespace shellmatch {

/// Writes all bytes through a file descriptor. \return 0, or the system's error number
int write_bytes(int descriptor, std::string_view bytes);

/// Waits until the file's contents, or the folder's entries, are on the disk. File systems that cannot say so count as done.
/// \return 0, or the system's error number
int synchronise(const std::string& path);

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
