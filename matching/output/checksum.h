#pragma once
/// \file
/// Checksums that detect damaged or changed contents. They do not protect against malicious changes.

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

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

/// XXH3 of 64 bits (Collet, xxHash, https://xxhash.com; the same values since its version 0.8) of bytes that are added
/// piece by piece, as 16 hexadecimal digits.
class Checksum {
 public:
  Checksum();
  ~Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;

  Checksum& add(std::string_view bytes);
  /// The checksum of all bytes added so far.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string text_checksum(std::string_view text);

/// The checksum of the next `length` bytes; nothing where the stream ends before.
std::optional<std::string> stream_checksum(std::istream& in, std::uintmax_t length);

/// The checksum of a whole file. \throws InputError if it cannot be read
std::string file_checksum(const std::string& path);

}  // namespace shellmatch
