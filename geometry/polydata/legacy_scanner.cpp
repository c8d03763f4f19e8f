#include "geometry/polydata/legacy_scanner.h"

#include "base/printable.h"
#include "base/stop.h"
#include "geometry/mesh_text/read_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

namespace shellmatch {

namespace {

constexpr std::string_view legacy_blanks = " \t\r\n\v\f";

}  // namespace

std::string LegacyScanner::place() const {
  if (is_binary_) return fmt::format("byte {}", position_);
  return fmt::format("line {}",
                     1 + std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(position_), '\n'));
}

std::string_view LegacyScanner::line() {
  const std::size_t end = std::min(left().find('\n'), left().size());
  std::string_view text = left().substr(0, end);
  position_ += std::min(end + 1, left().size());
  text.remove_prefix(std::min(text.find_first_not_of(legacy_blanks), text.size()));
  return text.substr(0, text.find_last_not_of(legacy_blanks) + 1);
}

std::string_view LegacyScanner::word() {
  std::string_view rest = left();
  const std::string_view text = next_word(rest, legacy_blanks);
  position_ = bytes_.size() - rest.size();
  return text;
}

std::string LegacyScanner::name() {
  std::string text;
  for (std::string_view rest = word(); !rest.empty();) {
    unsigned code = 0;
    const char* const end = rest.data() + 3;
    const bool is_code =
        rest.size() >= 3 && rest[0] == '%' && std::from_chars(rest.data() + 1, end, code, 16).ptr == end;
    text += is_code ? static_cast<char>(code) : rest[0];
    rest.remove_prefix(is_code ? 3 : 1);
  }
  return text;
}

bool LegacyScanner::take(std::string_view lower_case_word) {
  const std::size_t before = position_;
  if (equals_ignoring_case(word(), lower_case_word)) return true;
  position_ = before;
  return false;
}

std::size_t LegacyScanner::count(std::string_view what) {
  const std::string_view text = word();
  const std::optional<std::int64_t> value = to_integer(text);
  if (!value || *value < 0) fail("{} should be a count, not '{}'", what, printable(text, 30));
  return static_cast<std::size_t>(*value);
}

ValueType LegacyScanner::type() {
  const std::string name(word());
  const std::optional<ValueType> type = legacy_type(name);
  if (!type) fail("unknown type of values '{}'", printable(name, 30));
  return *type;
}

void LegacyScanner::end_line() {
  const std::size_t end = left().find('\n');
  if (end == std::string_view::npos || left().find_first_not_of(" \t\r") != end)
    fail("there is more in the line where binary values should follow");
  position_ += end + 1;
}

std::vector<double> LegacyScanner::values(ValueType type, std::size_t n, std::string_view what) {
  if (is_binary_) {
    if (n == 0) return {};
    end_line();
    // A bit for each value, at least.
    if (n / 8 > left().size() || bytes_of(type, n) > left().size())
      fail("cut off: {} {} do not fit into the {} bytes that are left", n, what, left().size());
    std::vector<double> values = values_of(left(), type, n, true);
    position_ += bytes_of(type, n);
    return values;
  }
  if (n > left().size() / 2 + 1)
    fail("cut off: {} {} do not fit into the {} bytes that are left", n, what, left().size());
  std::vector<double> values;
  values.reserve(n);
  StopCheck stop_check;
  while (values.size() < n) {
    stop_check();
    const std::string_view text = word();
    if (text.empty()) fail("cut off: {} of {} {} are there", values.size(), n, what);
    const std::optional<double> value = to_double(text);
    if (!value) fail("a number of the {} is '{}'", what, printable(text, 30));
    values.push_back(*value);
  }
  return values;
}

// In binary files the length of a string stands before it, in 1, 2, 4 or 8 bytes, as the first two bits say.
void LegacyScanner::skip_strings(std::size_t n) {
  if (n > left().size()) fail("cut off: {} strings do not fit into the {} bytes that are left", n, left().size());
  if (n > 0) end_line();
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_binary_) {
      line();
      continue;
    }
    if (left().empty()) fail("cut off within strings");
    const auto first = static_cast<unsigned char>(left().front());
    const std::size_t n_bytes = std::size_t{1} << (3 - (first >> 6));
    if (n_bytes > left().size()) fail("cut off within strings");
    std::uint64_t length = first & 0x3f;
    for (std::size_t k = 1; k < n_bytes; ++k) length = length << 8 | static_cast<unsigned char>(left()[k]);
    position_ += n_bytes;
    if (length > left().size()) fail("cut off within strings");
    position_ += length;
  }
}

}  // namespace shellmatch
