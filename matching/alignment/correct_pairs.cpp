#include "matching/alignment/correct_pairs.h"

#include "geometry/surface/surface.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shellmatch {

namespace {

constexpr double largest_difference = 0.1;  // diagonals of the template
// Twice as many as a linear function of Dim variables has coefficients.
template <int Dim>
constexpr std::size_t n_neighbours = 2 * (Dim + 1);
constexpr double ridge = 0.01;  // on the gradient, over the sum of squared distances: neighbours nearly lie in a plane
constexpr double far_weight = 0.1;  // of no correction, beside 1 for that of a landmark at the pair itself

/// Where the map of the pairs takes x: the displacements of its nearest pairs, fitted by a linear function.
template <int Dim>
Vec<Dim> mapped(const std::vector<PointPair<Dim>>& pairs, const Vec<Dim>& x) {
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto n = static_cast<std::ptrdiff_t>(std::min(n_neighbours<Dim>, pairs.size()));
  std::partial_sort(order.begin(), order.begin() + n, order.end(), [&](std::size_t a, std::size_t b) {
    return (pairs[a].p - x).squaredNorm() < (pairs[b].p - x).squaredNorm();
  });
  using Design = Vec<Dim + 1>;
  Mat<Dim + 1> normal_matrix = Mat<Dim + 1>::Zero();
  Eigen::Matrix<double, Dim + 1, Dim> right = Eigen::Matrix<double, Dim + 1, Dim>::Zero();
  double squares = 0;
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const PointPair<Dim>& pair = pairs[order[static_cast<std::size_t>(k)]];
    Design design;
    design << 1, pair.p - x;
    normal_matrix += design * design.transpose();
    right += design * (pair.y - pair.p).transpose();
    squares += (pair.p - x).squaredNorm();
  }
  normal_matrix.diagonal().template tail<Dim>().array() += ridge * squares;
  return x + normal_matrix.ldlt().solve(right).row(0).transpose();
}

template <int Dim>
struct Difference {
  Vec<Dim> p, mapped, value;  ///< a landmark's point of the reference, where the pairs map it, and the vector from
                              ///< there to where it belongs
};

}  // namespace

template <int Dim>
void correct_pairs(std::vector<PointPair<Dim>>& pairs, const std::vector<PointPair<Dim>>& landmarks, double share,
                   const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape) {
  if (pairs.empty() || landmarks.empty() || share == 0) return;
  const double limit = largest_difference * bounding_box(template_shape.surface().vertices).diagonal();
  std::vector<Difference<Dim>> differences;
  for (const PointPair<Dim>& landmark : landmarks) {
    const Vec<Dim> y = mapped(pairs, landmark.p);
    if ((landmark.y - y).norm() <= limit) differences.push_back({landmark.p, y, landmark.y - y});
  }
  // The mean distance of landmarks, as if they lay evenly, but not more than the limit where there are few.
  const double spacing = std::min(
      limit, std::pow(surface_measure(reference.surface()) / static_cast<double>(landmarks.size()), 1.0 / (Dim - 1)));
  for (PointPair<Dim>& pair : pairs) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    double weights = far_weight;
    for (const Difference<Dim>& d : differences) {
      // Near on both shapes: two legs may be next to each other on one of them.
      const double r2 = std::max((pair.p - d.p).squaredNorm(), (pair.y - d.mapped).squaredNorm()) / (spacing * spacing);
      const double weight = std::exp(-r2 / 2);
      sum += weight * d.value;
      weights += weight;
    }
    if (sum.isZero()) continue;
    pair.y = template_shape.closest(pair.y + share / weights * sum).point;
  }
}

SHELLMATCH_2D_3D(correct_pairs);

}  // namespace shellmatch
