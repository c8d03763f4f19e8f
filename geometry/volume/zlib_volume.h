#pragma once
/// \file
/// Compressed values.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace shellmatch {

/// The beginning of a file, inflated where gzip has compressed it, of at most this many bytes; fewer where the file
/// ends. \throws InputError where it cannot be opened, or what gzip has compressed is damaged
std::string inflated_beginning(const std::string& path, std::size_t n_bytes);

/// Whether the file is one that gzip has compressed as a whole: its bytes say that, whatever its name says.
bool is_gzip_file(const std::string& path);

/// Passes on what the file holds from `offset` on, inflated if `deflated` (zlib's or gzip's form), without its first
/// `skipped` bytes: in pieces of a multiple of 8 bytes but for the last, n_bytes in all. \return how many there were
std::uintmax_t for_each_piece(const std::string& path, std::uintmax_t offset, bool deflated, std::uintmax_t skipped,
                              std::uintmax_t n_bytes, const std::function<void(std::string_view)>& take);

enum class Deflated { gzip, zlib };
std::string deflated(std::string_view bytes, Deflated form);

}  // namespace shellmatch
