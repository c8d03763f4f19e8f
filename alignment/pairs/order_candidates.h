#pragma once
/// \file
/// The order among candidates of a search over poses, for outlines and surfaces alike.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace shellmatch {

/// Differences of scores that mean nothing: a candidate scores alike that is worse than the best by at most `factor`
/// and `noise`.
struct ScoreTolerance {
  double factor = 1;  ///< at least 1
  double noise = 0;
};

/// Sorts candidates by `score`, and of those that score like the best, puts first the one with `is_identity`, else the
/// one that turns least and is not `is_mirrored`: shapes that are symmetric themselves score nearly the same mirrored,
/// and are to stay as they are. One without pairs is never put first while another has some. \param angle of a
/// candidate's rotation, in [-pi, pi]
template <class Candidate, class Angle>
void order_candidates(std::vector<Candidate>& candidates, const ScoreTolerance& tolerance, const Angle& angle) {
  // Not std::stable_sort, whose buffer in g++ ignores that matrices may be aligned to 32 bytes.
  const auto penalised = [&](const Candidate& c) {
    return c.is_mirrored ? tolerance.factor * c.score + tolerance.noise : c.score;
  };
  std::sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    return a.pairs.empty() != b.pairs.empty() ? b.pairs.empty() : penalised(a) < penalised(b);
  });
  const double limit = tolerance.factor * penalised(candidates.front()) + tolerance.noise;
  const auto rank = [&](const Candidate& c) {
    if (penalised(c) > limit || c.pairs.empty()) return std::numeric_limits<double>::infinity();
    return c.is_identity ? -1.0 : std::abs(angle(c)) + (c.is_mirrored ? 10 : 0);
  };
  const auto first = std::min_element(candidates.begin(), candidates.end(),
                                      [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  std::rotate(candidates.begin(), first, first + 1);
}

/// Marks the candidates that differ from the first by a symmetry, and returns the least score of the others of the same
/// handedness over that of the first; infinite without others. \param noise the least score that counts
template <class Candidate, class DifferBySymmetry>
double margin_of_first(std::vector<Candidate>& candidates, double noise, const DifferBySymmetry& differ_by_symmetry) {
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    candidates[i].is_symmetry = differ_by_symmetry(candidates[0], candidates[i]);
    if (!candidates[i].is_symmetry && candidates[i].is_mirrored == candidates[0].is_mirrored)
      margin = std::min(margin, candidates[i].score / std::max(candidates[0].score, noise));
  }
  return margin;
}

}  // namespace shellmatch
