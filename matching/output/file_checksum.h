#pragma once
/// \file
/// A checksum at the end of a file, so that no damaged file reaches a library that trusts its input.

#include <string>

namespace shellmatch {

/// Appends a line with a checksum of all that is in the file, in the form of an XML comment.
/// \throws EnvironmentError if the file cannot be read or written
void seal_file(const std::string& path);

/// Does the file end with the seal of its contents? A file that is cut off or of which a byte was changed
/// does not; neither does one that seal_file() has never seen. \throws InputError if it cannot be read
bool is_sealed(const std::string& path);

}  // namespace shellmatch
