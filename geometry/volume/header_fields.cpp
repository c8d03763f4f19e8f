#include "geometry/volume/header_fields.h"

#include "base/printable.h"
#include "geometry/volume/zlib_volume.h"

#include <algorithm>

namespace shellmatch {

std::string header_text(const std::string& path, const std::function<bool(std::string_view line)>& is_last) {
  std::string text;
  const auto has_last = [&] {
    LineReader lines(path, text, 0);
    while (lines.next_line())
      if (is_last(lines.line())) return lines.n_left() > 0;  // the end of a line may have two bytes
    return false;
  };
  for (std::size_t wanted = 1 << 12;; wanted = std::min(4 * wanted, longest_header)) {
    for_each_piece(path, text.size(), false, 0, wanted - text.size(), [&](std::string_view piece) { text += piece; });
    if (text.size() < wanted || wanted == longest_header || has_last()) return text;
  }
}

bool split_field(std::string_view line, char separator, std::string_view& name, std::string_view& value) {
  const std::size_t at = line.find(separator);
  if (at == line.npos) return false;
  name = line.substr(0, at);
  value = line.substr(at + 1);
  while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
  while (value.starts_with(' ') || value.starts_with('\t')) value.remove_prefix(1);
  return true;
}

std::vector<double> numbers_of(const LineReader& lines, std::string_view name, std::string_view value, std::size_t n) {
  std::vector<double> numbers;
  for (std::string_view rest = value; rest.find_first_not_of(" \t") != rest.npos;)
    numbers.push_back(lines.number_of(rest, name));
  if (n > 0 && numbers.size() != n)
    lines.fail("{}: {} numbers are wanted, and there are {}", printable(name), n, numbers.size());
  return numbers;
}

std::vector<std::int64_t> counts_of(const LineReader& lines, std::string_view name, std::string_view value) {
  std::vector<std::int64_t> numbers;
  for (std::string_view rest = value; rest.find_first_not_of(" \t") != rest.npos;)
    numbers.push_back(lines.integer_of(rest, name));
  return numbers;
}

}  // namespace shellmatch
