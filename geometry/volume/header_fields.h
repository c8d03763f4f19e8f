#pragma once
/// \file
/// The lines of a header in text: names and values.

#include "geometry/io/read_text.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A header longer than this is none.
inline constexpr std::size_t longest_header = 1 << 16;

/// A line "name: value" or "name = value". \return false where the line has no separator
bool split_field(std::string_view line, char separator, std::string_view& name, std::string_view& value);

/// All numbers of a value, between blanks. \throws InputError naming the field where one is none, or where there are not `n` of them
/// (n = 0: any number)
std::vector<double> numbers_of(const LineReader& lines, std::string_view name, std::string_view value, std::size_t n);

/// The same for sizes.
std::vector<std::int64_t> counts_of(const LineReader& lines, std::string_view name, std::string_view value);

}  // namespace shellmatch
