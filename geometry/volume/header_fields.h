#pragma once
/// \file
/// The lines of a header in text: names and values.

#include "geometry/mesh_text/read_text.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A header longer than this is none: 8 MiB, as programs keep all of a scanner's protocol in it.
inline constexpr std::size_t longest_header = std::size_t{1} << 23;

/// The beginning of a file whose header is text, at least up to that line of it for which `is_last` is true: the first
/// 64 KiB, and more as long as that line is not among them. Where there is no such line, the file's beginning of
/// longest_header bytes.
std::string header_text(const std::string& path, const std::function<bool(std::string_view line)>& is_last);

/// A line "name: value" or "name = value". \return false where the line has no separator
bool split_field(std::string_view line, char separator, std::string_view& name, std::string_view& value);

/// All numbers of a value, between blanks. \throws InputError naming the field where one is none, or where there are
/// not `n` of them (n = 0: any number)
std::vector<double> numbers_of(const LineReader& lines, std::string_view name, std::string_view value, std::size_t n);

/// The same for sizes.
std::vector<std::int64_t> counts_of(const LineReader& lines, std::string_view name, std::string_view value);

}  // namespace shellmatch
