#include "alignment/functional_map/mirrored_gain.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace shellmatch {

namespace {

double mean_spin_difference(const ShapePairSpectra& pair, const VertexMatches& matches) {
  double sum = 0;
  for (std::size_t i = 0; i < matches.from[0].size(); ++i)
    sum += (pair.shapes[0]->spin.col(matches.from[0][i]) - pair.shapes[1]->spin.col(matches.to[0][i])).squaredNorm();
  return sum / static_cast<double>(std::max<std::size_t>(1, matches.from[0].size()));
}

}  // namespace

// Orientations take time: those of the most alike maps are asked for until both have been seen.
double mirrored_gain(const ShapePairSpectra& pair, const std::vector<MapCandidate>& candidates) {
  constexpr double noise = 1e-3;  // of sampling
  constexpr std::size_t n_asked = 12;
  std::vector<std::pair<double, std::size_t>> by_spin;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    by_spin.emplace_back(mean_spin_difference(pair, candidates[i].matches), i);
  std::ranges::sort(by_spin);
  by_spin.resize(std::min(by_spin.size(), n_asked));
  double best[2] = {0, 0}, last = 0;  // of maps that keep and that reverse orientation; 0: not seen
  for (const auto& [spin, i] : by_spin) {
    const MapScore score = score_samples(pair, candidates[i].matches, candidates[i].c);
    last = noise + (score.functions + score.signature) * score.spin;
    double& of_kind = best[score.orientation > 0.5];
    if (of_kind == 0 || last < of_kind) of_kind = last;
    if (best[0] > 0 && best[1] > 0) break;
  }
  return best[1] == 0 ? 0 : (best[0] > 0 ? best[0] : last) / best[1];
}

}  // namespace shellmatch
