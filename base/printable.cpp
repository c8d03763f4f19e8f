#include "base/printable.h"

#include <fmt/format.h>

namespace shellmatch {

namespace {

// The number of bytes of the UTF-8 character at the front, and its code; no bytes where there is none.
struct Character {
  std::size_t n_bytes = 0;
  char32_t code = 0;
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {1, lead};
  const std::size_t n = lead >= 0xF0 && lead < 0xF5   ? 4
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xC2 && lead < 0xE0 ? 2
                                                      : 0;
  if (n == 0 || text.size() < n) return {};
  char32_t code = lead & (0x7F >> n);
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  // Longer than needed, half of a pair, or beyond the last character.
  const bool wrong = code < (n == 2   ? 0x80u
                             : n == 3 ? 0x800u
                                      : 0x10000u) ||
                     (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF;
  return wrong ? Character{} : Character{n, code};
}

bool is_shown(char32_t code) {
  const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool turns =
      (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0x200E || code == 0x200F;
  return !control && !turns && code != 0x2028 && code != 0x2029;
}

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  constexpr std::string_view gap = " ... ";
  std::string shown;
  // Each byte becomes at most four: of a long text, only what may be shown of both ends is looked at.
  const std::size_t reach = most + 8;
  const bool is_cut = text.size() > 2 * reach;
  const auto append = [&](std::string_view part) {
    while (!part.empty()) {
      const Character c = first_character(part);
      const std::size_t n = c.n_bytes == 0 ? 1 : c.n_bytes;
      if (c.n_bytes > 0 && is_shown(c.code)) shown += part.substr(0, n);
      else if (part[0] == '\n') shown += "\\n";
      else if (part[0] == '\t') shown += "\\t";
      else
        for (const char b : part.substr(0, n)) shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(b));
      part.remove_prefix(n);
    }
  };
  append(is_cut ? text.substr(0, reach) : text);
  if (is_cut) append(text.substr(text.size() - reach));
  if (shown.size() <= most) return shown;
  const std::size_t kept = most > gap.size() ? most - gap.size() : 0;
  std::size_t head = kept * 2 / 3, tail = shown.size() - (kept - head);
  while (head > 0 && is_continuation(shown[head])) --head;
  while (tail < shown.size() && is_continuation(shown[tail])) ++tail;
  return shown.substr(0, head) + std::string(gap) + shown.substr(tail);
}

}  // namespace shellmatch
