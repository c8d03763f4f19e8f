#include "tests/fuzz/kept_inputs.h"

#include "tests/fuzz/target.h"

#include <charconv>
#include <fstream>

namespace shellmatch::fuzz {

namespace {

std::string input_of(std::string_view line) {
  std::string bytes;
  while (!line.empty()) {
    const char c = line.front();
    line.remove_prefix(1);
    if (c != '\\') {
      bytes += c;
      continue;
    }
    demand(!line.empty(), "a backslash is followed by a letter");
    const char letter = line.front();
    line.remove_prefix(1);
    if (letter == 'x') {
      unsigned value = 0;
      demand(line.size() >= 2 && std::from_chars(line.data(), line.data() + 2, value, 16).ptr == line.data() + 2,
             "\\x has two digits");
      bytes += static_cast<char>(value);
      line.remove_prefix(2);
      continue;
    }
    constexpr std::string_view letters = "nrtz\\", meanings("\n\r\t\0\\", 5);
    const std::size_t which = letters.find(letter);
    demand(which != letters.npos, "a backslash is followed by n, r, t, z, x or a backslash");
    bytes += meanings[which];
  }
  return bytes;
}

}  // namespace

std::vector<std::string> kept_inputs(const std::string& path) {
  std::vector<std::string> inputs;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with('#')) inputs.push_back(input_of(line));
  return inputs;
}

}  // namespace shellmatch::fuzz
