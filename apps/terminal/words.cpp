#include "apps/terminal/words.h"

#include "base/error.h"
#include "base/printable.h"

#include <charconv>
#include <cstdio>

namespace shellmatch {

namespace {

template <class T>
T parsed(std::string_view word, std::string_view option, T least, T greatest, std::string_view kind) {
  T value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (!word.empty() && error == std::errc() && end == word.data() + word.size() && value >= least && value <= greatest)
    return value;
  const bool has_least = least > std::numeric_limits<T>::lowest(),
             has_greatest = greatest < std::numeric_limits<T>::max();
  const std::string range = has_least && has_greatest ? fmt::format(" from {} to {}", least, greatest)
                            : has_least               ? fmt::format(", at least {}", least)
                                                      : "";
  throw_input_error("{} {}: expected a {}{}", option, word.empty() ? "''" : word, kind, range);
}

}  // namespace

int whole_number(std::string_view word, std::string_view option, int least, int greatest) {
  return parsed(word, option, least, greatest, "whole number");
}

double number(std::string_view word, std::string_view option, double least, double greatest) {
  return parsed(word, option, least, greatest, "number");
}

void say_line(std::string_view text) {
  std::fputs(fmt::format("{}\n", printable(text, max_message_length)).c_str(), stderr);
}

}  // namespace shellmatch
