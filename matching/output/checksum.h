#pragma once
/// \file
/// Checksums that tell damaged or changed contents: no protection against malice.

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

namespace shellmatch {

/// FNV-1a, 64 bits (Fowler, Noll, Vo): every step is invertible, so that one changed byte never goes unseen.
std::uint64_t text_checksum(std::string_view text, std::uint64_t begin = 0xcbf29ce484222325u);

/// The same of the next `length` bytes; nothing where the stream ends before.
std::optional<std::uint64_t> stream_checksum(std::istream& in, std::uintmax_t length);

/// Of a whole file. \throws InputError if it cannot be read
std::uint64_t file_checksum(const std::string& path);

/// 16 hexadecimal digits.
std::string checksum_text(std::uint64_t sum);

}  // namespace shellmatch
