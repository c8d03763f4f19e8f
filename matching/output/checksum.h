#pragma once
/// \file
/// Checksums that tell damaged or changed contents: no protection against malice.

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace shellmatch {

/// XXH3 of 64 bits (Collet, xxHash, https://xxhash.com; the same numbers since its version 0.8), as 16 hexadecimal
/// digits, of bytes that come piece by piece.
class Checksum {
 public:
  Checksum();
  ~Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;

  Checksum& add(std::string_view bytes);
  /// Of all that has been added so far.
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string text_checksum(std::string_view text);

/// Of the next `length` bytes; nothing where the stream ends before.
std::optional<std::string> stream_checksum(std::istream& in, std::uintmax_t length);

/// Of a whole file. \throws InputError if it cannot be read
std::string file_checksum(const std::string& path);

}  // namespace shellmatch
