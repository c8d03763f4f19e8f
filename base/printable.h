#pragma once
/// \file
/// Text that came from outside, made fit for a message.

#include <string>
#include <string_view>

namespace shellmatch {

/// The text on one line that a terminal shows as it is: control characters, marks that turn the direction of writing
/// and bytes that are no UTF-8 are written as escapes (`\n`, `\x1b`). Of a result longer than `most` bytes, the middle
/// is left out.
std::string printable(std::string_view text, std::size_t most = 160);

/// The length of a whole message, beyond which its middle is left out: it has its beginning, which names the file, and
/// its end, which says what to do.
inline constexpr std::size_t max_message_length = 2000;

}  // namespace shellmatch
