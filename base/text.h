#pragma once
/// \file
/// Wording of messages, and of names of files.

#include <cstddef>
#include <string>
#include <string_view>

namespace shellmatch {

/// "1 vertex", "12 vertices": a count with its noun.
std::string counted(std::size_t n, std::string_view singular, std::string_view plural);

/// `text` for use in file names: bytes other than ASCII letters, digits and ._+-=, become '_'.
std::string safe_file_name(std::string text);

/// The text as a field of a CSV line, in quotes where it needs them. A line break in it remains one.
std::string csv_field(std::string_view text);

}  // namespace shellmatch
