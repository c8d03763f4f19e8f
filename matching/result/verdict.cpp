#include "matching/result/verdict.h"

#include <fmt/format.h>

namespace shellmatch {

namespace {

// Shares of the template's diagonal, and of the reference's facets. After a successful matching the mean distance is at
// most 0.01 of the diagonal even on coarse grids, and at most a few facets in a thousand are flipped.
constexpr double far_away = 0.03, many_turned = 0.02;
// Shares of the template, and of the one before. Where limbs find their places the share falls by half or more from level to level.
constexpr double much_unreached = 0.1, hardly_less = 0.7;

}  // namespace

std::vector<std::string> verdict(const MatchSummary& summary) {
  std::vector<std::string> lines;
  if (summary.distance) {
    const auto& [there, back, uncovered] = *summary.distance;
    lines.push_back(fmt::format("distance: mean {:.2g}, largest {:.2g} from the deformed reference to the template, mean {:.2g}, "
                                "largest {:.2g} back, in diagonals of the template; {} folded cells",
                                there.mean, there.max, back.mean, back.max,
                                summary.levels.empty() ? 0 : summary.levels.back().folds.n_folded_cells));
    if (uncovered) lines.back() += fmt::format("; {:.2g} % of the template uncovered", 100 * *uncovered);
    if (!(there.mean < far_away && back.mean < far_away))
      lines.push_back("the shapes do not match: are their units and places the same (shellmatch inspect), are both whole and of one kind?");
  }
  const auto n = static_cast<double>(summary.reference.n_facets);
  if (summary.n_flipped_facets && static_cast<double>(*summary.n_flipped_facets) > many_turned * n)
    lines.push_back(fmt::format("{} of {} facets face away from the template next to them: look at the pictures",
                                *summary.n_flipped_facets, summary.reference.n_facets));
  return lines;
}

std::optional<std::string> stuck_warning(const std::vector<LevelSummary>& levels) {
  if (levels.size() < 3) return std::nullopt;
  const auto uncovered = [](const LevelSummary& level) { return level.distance ? level.distance->uncovered.value_or(0) : 0; };
  const double before = uncovered(levels[levels.size() - 2]), now = uncovered(levels.back());
  if (!(now > much_unreached && now > hardly_less * before)) return std::nullopt;
  return fmt::format("level {}: {:.0f} % of the template is not reached, after {:.0f} % on the level before, and finer levels will hardly reach more: "
                     "the shapes begin too far apart there, or are of different kinds; landmarks can tell where to go (docs/landmarks.md)",
                     levels.back().level, 100 * now, 100 * before);
}

}  // namespace shellmatch
