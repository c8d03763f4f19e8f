#pragma once
/// \file
/// Decompression of data that nobody has checked.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace shellmatch {

/// Expands one zlib stream, which must fill `n` bytes at `out` exactly and end with `compressed`. Returns false where
/// it is damaged or has another length; never writes beyond.
bool inflate_exactly(std::string_view compressed, char* out, std::size_t n);

enum class StreamForm { raw, zlib_or_gzip };

/// The `size` bytes that one stream holds, which must end with `packed`; nothing where it is damaged or has another
/// length. Memory is taken only for what so many packed bytes can hold.
std::optional<std::string> inflate_stream(std::string_view packed, StreamForm form, std::size_t size);

/// The largest factor by which zlib expands (https://zlib.net/zlib_tech.html).
inline constexpr std::size_t max_expansion = 1032;

}  // namespace shellmatch
