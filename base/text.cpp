#include "base/text.h"

#include <fmt/format.h>

namespace shellmatch {

std::string counted(std::size_t n, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", n, n == 1 ? singular : plural);
}

std::string safe_file_name(std::string text) {
  for (char& c : text) {
    const bool is_alphanumeric = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (!is_alphanumeric && std::string_view("._+-=,").find(c) == std::string_view::npos) c = '_';
  }
  return text;
}

std::string csv_field(std::string_view text) {
  const bool has_blank_ends = !text.empty() && (text.front() == ' ' || text.back() == ' ');
  if (!has_blank_ends && text.find_first_of(",;\"#\t\r\n") == text.npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field.append(c == '"' ? 2 : 1, c);
  return field + '"';
}

}  // namespace shellmatch
