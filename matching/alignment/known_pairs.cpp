#include "matching/alignment/known_pairs.h"

#include "matching/alignment/correct_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace shellmatch {

namespace {

// In diagonals of the template.
constexpr double most_apart = 0.05;
constexpr std::size_t most_looked_at = 5000;  // vertices of each

}  // namespace

template <int Dim>
bool lie_near(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape) {
  const double within = most_apart * bounding_box(template_shape.surface().vertices).diagonal();
  const auto lies_near = [&](const SignedDistance<Dim>& one, const SignedDistance<Dim>& other) {
    const std::vector<std::array<Index, Dim>>& facets = one.surface().facets;
    const std::size_t step = std::max<std::size_t>(1, facets.size() / most_looked_at);
    for (std::size_t f = 0; f < facets.size(); f += step)
      if (!(std::abs(other(one.surface().vertices[facets[f][0]])) <= within)) return false;
    return true;
  };
  return lies_near(reference, template_shape) && lies_near(template_shape, reference);
}

template <int Dim>
std::vector<PairSet<Dim>> known_pairs(const std::vector<Landmark<Dim>>& landmarks, const Alignment<Dim>& alignment,
                                      const ExperimentOptions& options, const Similarity<Dim>& placement,
                                      const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape) {
  std::vector<PairSet<Dim>> sets;
  const auto add = [&](const std::string& name, const std::vector<Landmark<Dim>>& points,
                       const LandmarkOptions& weights) {
    if (points.empty()) return;
    std::vector<Landmark<Dim>> bent;
    if (alignment.bend) {
      bent = points;
      for (Landmark<Dim>& point : bent) point.on_reference = (*alignment.bend)(point.on_reference);
    }
    sets.push_back(landmark_pairs(name, alignment.bend ? bent : points, weights, alignment.pose, placement, reference,
                                  template_shape));
  };
  LandmarkOptions known = options.landmarks;
  // Noisy landmarks give way to pairs that are more exact, and only to such.
  if (!alignment.pairs.empty()) known.weight *= alignment.landmark_trust.value_or(1);
  add("landmarks", landmarks, known);
  LandmarkOptions found;
  found.weight = options.align.weight;
  // Limbs may begin half a diagonal away from where they belong: a robust loss would take their pairs for wrong ones.
  // Where none does, it finds these: patches of maps between surfaces with many handles are wrong.
  found.loss = Dim == 3 && !alignment.pairs.empty() && lie_near(reference, template_shape) ? RobustLoss::cauchy
                                                                                           : RobustLoss::trivial;
  found.scale = 2 * options.align.tolerance;
  add("alignment", alignment.pairs, found);
  if (alignment.pairs.empty()) return sets;
  // Pairs of nearly isometric shapes are as exact as landmarks set by hand, whose errors would spoil them.
  const double share = 1 - 1 / (alignment.spread * alignment.spread);
  if (!landmarks.empty() && !alignment.landmark_trust)
    correct_pairs(sets.back().pairs.pairs, sets.front().pairs.pairs, share, reference, template_shape);
  sets.back().pairs.tolerance =
      options.align.tolerance * alignment.spread * bounding_box(template_shape.surface().vertices).diagonal();
  return sets;
}

template <int Dim>
ExperimentOptions cascade_options(const ExperimentOptions& options, const Alignment<Dim>& alignment) {
  ExperimentOptions result = options;
  // The deep teeth of outlines lie between their pairs, and need a wide band.
  if (Dim == 3 && (alignment.is_near || (!alignment.pairs.empty() && options.align.weight > 0)))
    result.cascade.coarse_sigma_cells = options.align.coarse_sigma_cells;
  // What is near everywhere slides into place on the next level as well.
  if (alignment.is_near)
    result.cascade.intermediate_decrease =
        std::max(options.cascade.intermediate_decrease, options.cascade.substep_decrease);
  return result;
}

SHELLMATCH_2D_3D(lie_near);
SHELLMATCH_2D_3D(cascade_options);
SHELLMATCH_2D_3D(known_pairs);

}  // namespace shellmatch
