#include "geometry/surface/space.h"

namespace shellmatch {

Space space_in_comment(std::string_view text) {
  constexpr std::string_view key = "SPACE=";
  // A longer word that ends in the key is another one.
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
    if (at > 0 && text[at - 1] != ' ' && text[at - 1] != ';' && text[at - 1] != '\t' && text[at - 1] != '#') continue;
    const std::string_view value = text.substr(at + key.size(), 3);
    for (const Space space : {Space::ras, Space::lps})
      if (value == space_name(space)) return space;
  }
  return Space::unsaid;
}

std::string_view space_name(Space space) { return space == Space::ras ? "RAS" : space == Space::lps ? "LPS" : ""; }

Vec<3> in_space(const Vec<3>& x, Space from, Space to) {
  if (from == to || from == Space::unsaid || to == Space::unsaid) return x;
  return {-x.x(), -x.y(), x.z()};
}

bool change_space(std::vector<Vec<3>>& points, Space from, Space to) {
  if (from == to || from == Space::unsaid || to == Space::unsaid) return false;
  for (Vec<3>& x : points) x = in_space(x, from, to);
  return !points.empty();
}

}  // namespace shellmatch
