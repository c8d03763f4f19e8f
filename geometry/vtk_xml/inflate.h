#pragma once
/// \file
/// Decompression of data that nobody has checked.

#include <cstddef>
#include <string_view>

namespace shellmatch {

/// Expands one zlib stream, which must fill `n` bytes at `out` exactly and end with `compressed`. Returns false where
/// it is damaged or has another length; never writes beyond.
bool inflate_exactly(std::string_view compressed, char* out, std::size_t n);

/// The largest factor by which zlib expands (https://zlib.net/zlib_tech.html).
inline constexpr std::size_t max_expansion = 1032;

}  // namespace shellmatch
