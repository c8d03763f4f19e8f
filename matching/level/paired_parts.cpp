#include "matching/level/paired_parts.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shellmatch {

namespace {

// Distances between neighbouring pairs: a pair that the search trusted less is missing here and there.
constexpr double reach = 3;
// A point of the whole lies farther from a pair than its counterpart on the part, as pairs are inexact and shapes
// stretch.
constexpr double longer = 1.5;

template <int Dim>
using Points = Eigen::Matrix<double, Dim, Eigen::Dynamic>;

template <int Dim>
const Surface<Dim>& observed_surface(const Shape<Dim>& shape) {
  return shape.evidence.is_complete() ? shape.surface : shape.evidence.observed;
}

/// The point nearest to each facet's centre.
struct Nearest {
  std::vector<Eigen::Index> point;
  std::vector<double> distance;
};

template <int Dim>
Nearest nearest_points(const Surface<Dim>& surface, const Points<Dim>& points) {
  Nearest nearest{std::vector<Eigen::Index>(surface.facets.size()), std::vector<double>(surface.facets.size())};
  parallel_for(
      surface.facets.size(),
      [&](std::size_t f) {
        Vec<Dim> centre = Vec<Dim>::Zero();
        for (const Index v : surface.facets[f]) centre += surface.vertices[v] / Dim;
        nearest.distance[f] =
            std::sqrt((points.colwise() - centre).colwise().squaredNorm().minCoeff(&nearest.point[f]));
      },
      64);
  return nearest;
}

template <int Dim>
double spacing(const Points<Dim>& points) {
  std::vector<double> distances(static_cast<std::size_t>(points.cols()));
  parallel_for(distances.size(), [&](std::size_t i) {
    const auto k = static_cast<Eigen::Index>(i);
    Eigen::VectorXd squares = (points.colwise() - points.col(k)).colwise().squaredNorm();
    squares[k] = std::numeric_limits<double>::infinity();
    distances[i] = std::sqrt(squares.minCoeff());
  });
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// For each pair how far the part goes on from it, or from one beside it, without another: a limb may have no pairs.
template <int Dim>
Eigen::VectorXd extents(const Surface<Dim>& part, const Points<Dim>& points, double beside) {
  const Nearest nearest = nearest_points(part, points);
  Eigen::VectorXd own = Eigen::VectorXd::Zero(points.cols());
  for (std::size_t f = 0; f < nearest.point.size(); ++f)
    own[nearest.point[f]] = std::max(own[nearest.point[f]], nearest.distance[f]);
  Eigen::VectorXd extents(points.cols());
  parallel_for(static_cast<std::size_t>(points.cols()), [&](std::size_t i) {
    const auto k = static_cast<Eigen::Index>(i);
    const auto squares = (points.colwise() - points.col(k)).colwise().squaredNorm().array();
    extents[k] = (squares.transpose() <= beside * beside).select(own.array(), 0.0).maxCoeff();
  });
  return extents;
}

/// What is farther from its nearest point than that point's limit counts as unobserved, too.
template <int Dim>
Evidence<Dim> evidence_near(const Shape<Dim>& shape, const Points<Dim>& points, const Eigen::VectorXd& limits) {
  const Surface<Dim>& all = observed_surface(shape);
  const Nearest nearest = nearest_points(all, points);
  Evidence<Dim> evidence{{all.vertices, {}}, shape.evidence.unobserved};
  const auto first = static_cast<Index>(evidence.unobserved.vertices.size());
  evidence.unobserved.vertices.insert(evidence.unobserved.vertices.end(), all.vertices.begin(), all.vertices.end());
  for (std::size_t f = 0; f < all.facets.size(); ++f) {
    auto facet = all.facets[f];
    if (nearest.distance[f] <= limits[nearest.point[f]]) {
      evidence.observed.facets.push_back(facet);
      continue;
    }
    for (Index& v : facet) v += first;
    evidence.unobserved.facets.push_back(facet);
  }
  return evidence;
}

}  // namespace

template <int Dim>
ObservedPair<Dim> paired_parts(ObservedPair<Dim> observed, const Shape<Dim>& deformed, const Shape<Dim>& other,
                               const std::vector<PairSet<Dim>>& sets) {
  const auto found = std::ranges::find(sets, "alignment", &PairSet<Dim>::name);
  if (found == sets.end() || found->pairs.pairs.size() < 2) return observed;
  const std::vector<PointPair<Dim>>& pairs = found->pairs.pairs;
  const bool deformed_is_whole = surface_measure(observed_surface(deformed)) > surface_measure(observed_surface(other));
  Points<Dim> of_whole(Dim, static_cast<Eigen::Index>(pairs.size())), of_part = of_whole;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    of_whole.col(k) = deformed_is_whole ? pairs[i].p : pairs[i].y;
    of_part.col(k) = deformed_is_whole ? pairs[i].y : pairs[i].p;
  }
  const Shape<Dim>&whole = deformed_is_whole ? deformed : other, &part = deformed_is_whole ? other : deformed;
  const Eigen::VectorXd limits =
      (longer * extents(observed_surface(part), of_part, reach * spacing(of_part))).cwiseMax(reach * spacing(of_whole));
  (deformed_is_whole ? observed.reference : observed.template_shape) =
      ObservedPart<Dim>(evidence_near(whole, of_whole, limits));
  return observed;
}

SHELLMATCH_2D_3D(paired_parts);

}  // namespace shellmatch
