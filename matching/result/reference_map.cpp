#include "matching/result/reference_map.h"

#include "base/parallel.h"
#include "geometry/surface/subdivision.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace shellmatch {

template <int Dim>
InverseCarrier<Dim>::InverseCarrier(const Surface<Dim>& moving, const Octree<Dim>& grid,
                                    const std::vector<Vec<Dim>>& phi)
    : inverse_(grid, phi),
      moving_(subdivided(moving, grid.finest_side())),
      moved_(deformed_surface(moving_, grid, phi)),
      facets_(moved_),
      reach_(4 * grid.finest_side()),
      slack_(0.1 * grid.finest_side()) {}

template <int Dim>
std::optional<Vec<Dim>> InverseCarrier<Dim>::operator()(const Vec<Dim>& x, const Vec<Dim>& normal) const {
  const std::optional<Vec<Dim>> y = inverse_(x);
  if (!y) return y;
  const auto nearest = facets_.nearest(x, normal);
  if (!nearest) return y;
  const std::array<double, Dim> weights = barycentric_coordinates(moved_, nearest->facet, nearest->point);
  Vec<Dim> p = Vec<Dim>::Zero();
  const auto& facet = moving_.facets[static_cast<std::size_t>(nearest->facet)];
  for (std::size_t k = 0; k < Dim; ++k) p += weights[k] * moving_.vertices[static_cast<std::size_t>(facet[k])];
  const Vec<Dim> offset = *y - p;
  const double own = nearest->distance / (1 - std::min(0.5, nearest->distance / reach_)) + slack_,
               length = offset.norm();
  if (length <= 2 * own) return y;
  return Vec<Dim>(p + offset * (own / length * (1 + 2 * own / length)));  // from 2 d at 2 d down to d
}

template <int Dim>
std::vector<Vec<Dim>> InverseCarrier<Dim>::carried(const std::vector<Vec<Dim>>& points,
                                                   const std::vector<Vec<Dim>>& normals) const {
  std::vector<std::optional<Vec<Dim>>> images(points.size());
  parallel_for(
      points.size(), [&](std::size_t i) { images[i] = (*this)(points[i], normals[i]); }, 64);
  std::vector<Vec<Dim>> moved = points;
  parallel_for(points.size(), [&](std::size_t i) {
    std::size_t from = i;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; !images[i] && k < points.size(); ++k)
      if (const double distance = (points[k] - points[i]).squaredNorm(); images[k] && distance < least)
        from = k, least = distance;
    if (from == i && images[i]) moved[i] = *images[i];
    else if (images[from]) moved[i] += *images[from] - points[from];
  });
  return moved;
}

template <int Dim>
std::vector<Vec<Dim>> nearest_normals(const Surface<Dim>& surface, std::span<const Vec<Dim>> points) {
  const FacetTree<Dim> tree(surface);
  std::vector<Vec<Dim>> normals(points.size(), Vec<Dim>::Zero());
  parallel_for(
      points.size(),
      [&](std::size_t i) {
        if (const Index f = tree.nearest(points[i]); f != no_index) normals[i] = facet_normal(surface, f);
      },
      64);
  return normals;
}

template class InverseCarrier<2>;
template class InverseCarrier<3>;
SHELLMATCH_2D_3D(nearest_normals);

template <int Dim>
std::vector<Vec<Dim>> ReferenceMap<Dim>::carried(std::vector<Vec<Dim>> points, const Deformation<Dim>& frame,
                                                 const Surface<Dim>& reference) const {
  if (!inverse_) {
    parallel_for(points.size(), [&](std::size_t i) { points[i] = frame.apply(points[i]); });
    return points;
  }
  for (Vec<Dim>& x : points) x = frame.placement(x);
  points = inverse_->carried(points, nearest_normals<Dim>(reference, points));
  for (Vec<Dim>& x : points) x = frame.pose.inverse(frame.placement.inverse(x));
  return points;
}

template class ReferenceMap<2>;
template class ReferenceMap<3>;

}  // namespace shellmatch
