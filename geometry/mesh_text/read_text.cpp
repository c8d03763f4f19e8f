#include "geometry/mesh_text/read_text.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace shellmatch {
namespace {

constexpr std::string_view blanks = " \t\v\f";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Long words come from binary data; a message shows their beginning only, and only printable characters.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, 24));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return word.size() > 24 ? text + "..." : text;
}

// Where the comment of a line begins. In the quotes around a field there is none; a quote that is not closed is a
// letter.
std::size_t comment_in(std::string_view line, char comment) {
  if (!comment) return line.npos;
  std::size_t at = line.find(comment);
  for (std::size_t k = line.find('"'); k < at; k = line.find('"', k + 1)) {
    if (k > 0 && std::string_view(" \t,;").find(line[k - 1]) == line.npos) continue;
    std::size_t end = line.find('"', k + 1);
    while (end < line.size() && line.substr(end + 1).starts_with('"')) end = line.find('"', end + 2);
    if (end == line.npos) break;
    k = end;
    if (at < k) at = line.find(comment, k);
  }
  return at;
}

}  // namespace

std::optional<double> to_double(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  // Out of range: strtod knows whether that means 0 or infinity.
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(word).c_str(), nullptr);
  if (error != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> to_integer(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error != std::errc() || word.empty()) return std::nullopt;
  return value;
}

bool equals_ignoring_case(std::string_view text, std::string_view lower_case_word) {
  return std::equal(text.begin(), text.end(), lower_case_word.begin(), lower_case_word.end(),
                    [](char a, char b) { return lower(a) == b; });
}

std::string_view next_word(std::string_view& rest, std::string_view separators) {
  const std::size_t begin = std::min(rest.find_first_not_of(separators), rest.size());
  const std::size_t end = std::min(rest.find_first_of(separators, begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

std::vector<std::string_view> csv_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    std::size_t comma = 0;
    // A pair of quotes within quotes closes and opens them.
    for (bool is_quoted = false; comma < line.size() && (is_quoted || line[comma] != ','); ++comma)
      if (line[comma] == '"' && (is_quoted || line.front() == '"')) is_quoted = !is_quoted;
    const std::string_view field = line.substr(0, comma);
    fields.push_back(field.substr(0, field.find_last_not_of(blanks) + 1));
    if (comma >= line.size()) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::string csv_text(std::string_view field) {
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return std::string(field);
  std::string text;
  field = field.substr(1, field.size() - 2);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] == '"' && i + 1 < field.size() && field[i + 1] == '"') ++i;
    text.push_back(field[i]);
  }
  return text;
}

LineReader::LineReader(std::string path, std::string_view text, char comment)
    : path_(std::move(path)), text_(text), comment_(comment) {
  // A byte order mark is no part of the first word.
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
}

bool LineReader::next() {
  while (next_line())
    if (!line_.empty()) return true;
  return false;
}

bool LineReader::next_line() {
  stop_check_();
  line_ = {};
  only_comment_ = false;
  if (position_ >= text_.size()) return false;
  ++number_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", position_), text_.size());
  line_ = text_.substr(position_, end - position_);
  position_ = std::min(end + 1, text_.size());
  if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++position_;
  const std::size_t comment = comment_in(line_, comment_);
  if (comment != std::string_view::npos) line_ = line_.substr(0, comment);
  line_.remove_prefix(std::min(line_.find_first_not_of(blanks), line_.size()));
  line_ = line_.substr(0, line_.find_last_not_of(blanks) + 1);
  only_comment_ = comment != std::string_view::npos && line_.empty();
  return true;
}

double LineReader::number_of(std::string_view& rest, std::string_view what) const {
  const std::string_view word = next_word(rest);
  if (word.empty()) fail("{} is missing", what);
  const std::optional<double> value = to_double(word);
  if (!value) fail("{} should be a number, not '{}'", what, shown(word));
  return *value;
}

std::int64_t LineReader::integer_of(std::string_view& rest, std::string_view what) const {
  const std::string_view word = next_word(rest);
  if (word.empty()) fail("{} is missing", what);
  const std::optional<std::int64_t> value = to_integer(word);
  if (!value) fail("{} should be a whole number, not '{}'", what, shown(word));
  return *value;
}

}  // namespace shellmatch
