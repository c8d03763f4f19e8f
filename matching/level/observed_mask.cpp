#include "matching/level/observed_mask.h"

#include <algorithm>
#include <array>

namespace shellmatch {

namespace {

constexpr std::size_t group_size = 8;

// A narrow gap takes no more of its surroundings than of itself: a scan may have many.
template <class Gap>
double weight_near(const Gap& gap, double width) {
  if (!(gap.margin > 0)) return 0;
  if (gap.margin >= width) return 1;
  const double t = std::min(1.0, gap.margin / std::min(width, 2 * gap.half_width));
  return t * t * (3 - 2 * t);
}

// Most points are far from the edges of gaps. Of the others the gaps are found together. \pre at most group_size
template <int Dim>
void weigh_group(const ObservedPart<Dim>& part, std::span<const Vec<Dim>> points, double width,
                 std::span<double> weights) {
  std::array<std::size_t, group_size> places;
  std::array<Vec<Dim>, group_size> open;
  std::size_t n = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (part.is_surely_beyond(points[i], width)) {
      weights[i] = 1;
    } else if (part.is_within(points[i], 0)) {
      weights[i] = 0;
    } else {
      places[n] = i;
      open[n++] = points[i];
    }
  }
  if (n == 0) return;
  std::array<typename ObservedPart<Dim>::Gap, group_size> gaps;
  part.nearest_gaps(std::span(open).first(n), width, std::span(gaps).first(n));
  for (std::size_t i = 0; i < n; ++i) weights[places[i]] = weight_near(gaps[i], width);
}

template <int Dim>
void weigh(const ObservedPart<Dim>& part, std::span<const Vec<Dim>> points, double width, std::span<double> weights) {
  if (part.is_all()) return void(std::ranges::fill(weights, 1.0));
  for (std::size_t i = 0; i < points.size(); i += group_size) {
    const std::size_t n = std::min(group_size, points.size() - i);
    weigh_group(part, points.subspan(i, n), width, weights.subspan(i, n));
  }
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
