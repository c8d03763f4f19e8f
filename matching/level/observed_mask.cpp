#include "matching/level/observed_mask.h"

#include <algorithm>

namespace shellmatch {

namespace {

// A narrow gap takes no more of its surroundings than of itself: a scan may have many.
template <int Dim>
double weight_in(const ObservedPart<Dim>& part, const Vec<Dim>& x, double width) {
  if (part.is_beyond(x, width)) return 1;
  if (part.is_within(x, 0)) return 0;
  const auto [margin, half_width] = part.nearest_gap(x);
  if (!(margin > 0)) return 0;
  const double t = std::min(1.0, margin / std::min(width, 2 * half_width));
  return t * t * (3 - 2 * t);
}

enum class Side { without_data, with_data, edge };

// The margin changes at most by twice the distance.
template <int Dim>
Side side_of_ball(const ObservedPart<Dim>& part, const Vec<Dim>& centre, double radius, double width) {
  if (part.is_beyond(centre, width + 2 * radius)) return Side::with_data;
  if (part.is_within(centre, -2 * radius)) return Side::without_data;
  const double margin = part.margin(centre);
  if (margin - 2 * radius >= width) return Side::with_data;
  return margin + 2 * radius <= 0 ? Side::without_data : Side::edge;
}

}  // namespace

template <int Dim>
double ObservedMask<Dim>::weight(const Vec<Dim>& x, const Vec<Dim>& y) const {
  const double of_reference = weight_in(parts_.reference, x, width_);
  return of_reference > 0 ? of_reference * weight_in(parts_.template_shape, y, width_) : 0;
}

template <int Dim>
std::optional<double> ObservedMask<Dim>::constant(const Vec<Dim>& x, double x_radius, const Vec<Dim>& y,
                                                  double y_radius) const {
  const Side of_reference = side_of_ball(parts_.reference, x, x_radius, width_);
  if (of_reference == Side::without_data) return 0;
  const Side of_template = side_of_ball(parts_.template_shape, y, y_radius, width_);
  if (of_template == Side::without_data) return 0;
  if (of_reference == Side::with_data && of_template == Side::with_data) return 1;
  return std::nullopt;
}

template class ObservedMask<2>;
template class ObservedMask<3>;

}  // namespace shellmatch
