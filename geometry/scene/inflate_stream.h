#pragma once
/// \file
/// Decompression of a whole stream.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace shellmatch {

enum class StreamForm { raw, zlib_or_gzip };

/// The `size` bytes that one stream holds, which must end with `packed`; nothing where it is damaged or has another
/// length. Memory is taken only for what so many packed bytes can hold.
std::optional<std::string> inflate_stream(std::string_view packed, StreamForm form, std::size_t size);

}  // namespace shellmatch
