#pragma once
/// \file
/// A checksum at the end of a file, so that no damaged file reaches a library that trusts its input.

#include <string>

namespace shellmatch {

enum class FileChecksum {
  matches,
  differs,  ///< or is missing: the file is cut off, changed, or append_checksum() has never seen it
  earlier   ///< a checksum in the form of an earlier version (FNV-1a, to version 0.1.0), which is not verified
};

/// Appends a line with a checksum of all that is in the file, in the form of an XML comment that names its kind.
/// \throws EnvironmentError if the file cannot be read or written
void append_checksum(const std::string& path);

/// Does the file end with the checksum of its contents? \throws InputError if it cannot be read
FileChecksum verify_checksum(const std::string& path);

}  // namespace shellmatch
