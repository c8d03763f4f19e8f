#include "base/options.h"

#include "base/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shellmatch {

namespace {

// Damerau-Levenshtein distance, in which a swap of adjacent letters counts 1: "simga" for "sigma".
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

Choice& Choice::operator=(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  SHELLMATCH_CHECK(found != names_.end(), "a choice is set to one of its names");
  index_ = static_cast<std::size_t>(found - names_.begin());
  return *this;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& c : candidates)
    if (const std::size_t d = edit_distance(word, c); d < least) {
      least = d;
      best = c;
    }
  return best;
}

std::string range_text(const OptionInfo& info) {
  const bool low = std::isfinite(info.min), high = std::isfinite(info.max);
  const char* less = info.min_excluded ? "<" : "<=";
  if (low && high) return fmt::format("{:.7g} {} x <= {:.7g}", info.min, less, info.max);
  if (low) return fmt::format("x {} {:.7g}", info.min_excluded ? ">" : ">=", info.min);
  if (high) return fmt::format("x <= {:.7g}", info.max);
  return "any";
}

bool in_range(double value, const OptionInfo& info) {
  return (info.min_excluded ? value > info.min : value >= info.min) && value <= info.max;
}

}  // namespace shellmatch
