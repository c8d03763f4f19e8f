#include "geometry/statistics/point_sets.h"

#include "base/error.h"

#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

// Twice the area of a triangle, or the length of a segment.
template <int Dim>
double measure(const Eigen::VectorXd& points, const std::array<Index, Dim>& facet) {
  const auto at = [&](int corner) {
    return points.segment<Dim>(Dim * Eigen::Index{facet[static_cast<std::size_t>(corner)]});
  };
  if constexpr (Dim == 2) {
    return (at(1) - at(0)).norm();
  } else {
    const Vec<3> a = at(1) - at(0), b = at(2) - at(0);
    return Vec<3>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]).norm();
  }
}

}  // namespace

template <int Dim>
Eigen::VectorXd area_weights(const Eigen::VectorXd& points, const std::vector<std::array<Index, Dim>>& facets) {
  SHELLMATCH_CHECK(points.size() % Dim == 0, "points have as many coordinates as the space has dimensions");
  if (!points.allFinite()) throw_input_error("area weights: a point is not finite");
  const Eigen::Index n_points = points.size() / Dim;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(n_points);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const Index v : facets[f])
      if (v < 0 || v >= n_points)
        throw_input_error("area weights: facet {} names point {}; there are points 0 to {}", f, v, n_points - 1);
    const double part = measure<Dim>(points, facets[f]);
    for (const Index v : facets[f]) weights[v] += part;
  }
  const double whole = weights.sum();
  if (!(whole > 0) || !std::isfinite(whole))
    throw_input_error(
        "area weights: the {} facets have no area in all; give weights for the points, or the same for each",
        facets.size());
  return weights / whole;
}

template Eigen::VectorXd area_weights<2>(const Eigen::VectorXd&, const std::vector<std::array<Index, 2>>&);
template Eigen::VectorXd area_weights<3>(const Eigen::VectorXd&, const std::vector<std::array<Index, 3>>&);

Eigen::VectorXd uniform_weights(Eigen::Index n_points) {
  return Eigen::VectorXd::Constant(n_points, 1 / static_cast<double>(n_points));
}

void check_point_sets(const PointSets& sets, const Eigen::VectorXd& weights) {
  if (sets.dimension != 2 && sets.dimension != 3)
    throw_input_error("points of {} coordinates; 2 or 3 are expected", sets.dimension);
  if (sets.coordinates.rows() % sets.dimension != 0)
    throw_input_error("shapes of {} numbers, which is no multiple of the dimension, {}", sets.coordinates.rows(),
                      sets.dimension);
  if (sets.n_points() == 0 || sets.n_sets() == 0)
    throw_input_error("{} shapes of {} points: there is nothing to compute with", sets.n_sets(), sets.n_points());
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i)
    for (Eigen::Index row = 0; row < sets.coordinates.rows(); ++row)
      if (!std::isfinite(sets.coordinates(row, i)))
        throw_input_error("shape {}, point {} (counted from 0) is not finite; leave the shape out", i,
                          row / sets.dimension);
  if (weights.size() != sets.n_points()) throw_input_error("{} weights for {} points", weights.size(), sets.n_points());
  for (Eigen::Index p = 0; p < weights.size(); ++p)
    if (!(weights[p] >= 0))
      throw_input_error("weight {} (counted from 0) is {}; weights are not negative", p, weights[p]);
  constexpr double tolerance = 1e-9;  // of rounding in a sum over many points
  if (!(std::abs(weights.sum() - 1) <= tolerance))
    throw_input_error("the sum of the weights is {}, and not 1", weights.sum());
}

double rounding_of(const PointSets& sets) {
  return 64 * std::numeric_limits<double>::epsilon() * sets.coordinates.cwiseAbs().maxCoeff();
}

Eigen::VectorXd mean_of(const PointSets& sets) {
  const auto n = static_cast<double>(sets.n_sets());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(sets.coordinates.rows()), correction = mean;
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i) mean += sets.coordinates.col(i);
  mean /= n;
  // What the sum of large numbers has rounded away.
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i) correction += sets.coordinates.col(i) - mean;
  return mean + correction / n;
}

}  // namespace shellmatch
