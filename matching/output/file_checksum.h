#pragma once
/// \file
/// A checksum at the end of a file, which keeps damaged files from libraries that do not check their input.

#include <string>

namespace shellmatch {

enum class FileChecksum {
  matches,
  differs,  ///< or is missing: the file was cut off or changed, or was not written by append_checksum()
  earlier   ///< written by an earlier version (FNV-1a, up to version 0.1.0), which is not verified
};

/// Appends a line with the checksum of the file's contents, as an XML comment that states the kind of checksum.
/// \throws EnvironmentError if the file cannot be read or written
void append_checksum(const std::string& path);

/// Compares the checksum at the end of the file with its contents. \throws InputError if the file cannot be read
FileChecksum verify_checksum(const std::string& path);

}  // namespace shellmatch
