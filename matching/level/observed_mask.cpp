#include "matching/level/observed_mask.h"

#include <algorithm>
#include <vector>

namespace shellmatch {

namespace {

// A narrow gap takes no more of its surroundings than of itself: a scan may have many.
template <class Gap>
double weight_near(const Gap& gap, double width) {
  if (!(gap.margin > 0)) return 0;
  if (gap.margin >= width) return 1;
  const double t = std::min(1.0, gap.margin / std::min(width, 2 * gap.half_width));
  return t * t * (3 - 2 * t);
}

// Most points are far from the edges of gaps. Of the others the gaps are found together.
template <int Dim>
void weigh(const ObservedPart<Dim>& part, std::span<const Vec<Dim>> points, double width, std::span<double> weights) {
  std::vector<std::size_t> places;
  std::vector<Vec<Dim>> open;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (part.is_surely_beyond(points[i], width)) {
      weights[i] = 1;
    } else if (part.is_within(points[i], 0)) {
      weights[i] = 0;
    } else {
      places.push_back(i);
      open.push_back(points[i]);
    }
  }
  if (open.empty()) return;
  std::vector<typename ObservedPart<Dim>::Gap> gaps(open.size());
  part.nearest_gaps(open, width, gaps);
  for (std::size_t k = 0; k < gaps.size(); ++k) weights[places[k]] = weight_near(gaps[k], width);
}

}  // namespace

template <int Dim>
void ObservedMask<Dim>::reference_weights(std::span<const Vec<Dim>> x, std::span<double> weights) const {
  weigh(parts_.reference, x, width_, weights);
}

template <int Dim>
void ObservedMask<Dim>::template_weights(std::span<const Vec<Dim>> y, std::span<double> weights) const {
  weigh(parts_.template_shape, y, width_, weights);
}

template class ObservedMask<2>;
template class ObservedMask<3>;

}  // namespace shellmatch
