#include "geometry/distance/surface_bend.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/surface/facet_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

// Axes that turn with a facet: its normal, the first edge and what is perpendicular to both. Zero where it has no area.
Mat<2> axes(const Surface<2>& surface, Index f) {
  const Vec<2> normal = facet_normal(surface, f).normalized();
  Mat<2> m;
  m << normal, Vec<2>(-normal.y(), normal.x());
  return m;
}

Mat<3> axes(const Surface<3>& surface, Index f) {
  const auto& [a, b, c] = surface.facets[f];
  const Vec<3> edge = surface.vertices[b] - surface.vertices[a], other = surface.vertices[c] - surface.vertices[a];
  if (is_degenerate(edge, other)) return Mat<3>::Zero();
  const Vec<3> normal = edge.cross(other).normalized(), along = edge.normalized();
  Mat<3> m;
  m << normal, along, normal.cross(along);
  return m;
}

}  // namespace

template <int Dim>
SurfaceBend<Dim>::SurfaceBend(Surface<Dim> surface, std::vector<Vec<Dim>> bent)
    : surface_(std::move(surface)), bent_{std::move(bent), surface_.facets}, tree_(surface_), bent_tree_(bent_) {
  SHELLMATCH_CHECK(bent_.vertices.size() == surface_.vertices.size(), "every vertex has a bent position");
}

template <int Dim>
Vec<Dim> SurfaceBend<Dim>::carried(const Surface<Dim>& from, const FacetTree<Dim>& tree, const Surface<Dim>& to,
                                   const Vec<Dim>& x) {
  const Index f = tree.nearest(x);
  if (f == no_index) return x;  // its distance is not finite
  const FacetPoint<Dim> nearest = closest_point_on_facet(from, f, x);
  const std::array<double, Dim> weights = barycentric_coordinates(from, f, nearest);
  Vec<Dim> y = Vec<Dim>::Zero();
  for (int k = 0; k < Dim; ++k) y += weights[static_cast<std::size_t>(k)] * to.vertices[to.facets[f][k]];
  const Vec<Dim> beside = x - nearest.point;
  return beside.isZero(0) ? y : Vec<Dim>(y + axes(to, f) * (axes(from, f).transpose() * beside));
}

template <int Dim>
double SurfaceBend<Dim>::farthest(const Surface<Dim>& surface) const {
  std::vector<double> distances(surface.vertices.size());
  parallel_for(distances.size(), [&](std::size_t v) {
    const Vec<Dim>& x = surface.vertices[v];
    const Index f = tree_.nearest(x);
    distances[v] = f == no_index ? std::numeric_limits<double>::infinity()
                                 : (closest_point_on_facet(surface_, f, x).point - x).norm();
  });
  return distances.empty() ? 0 : *std::ranges::max_element(distances);
}

template <int Dim>
void SurfaceBend<Dim>::apply(Surface<Dim>& surface) const {
  parallel_for(surface.vertices.size(), [&](std::size_t v) { surface.vertices[v] = (*this)(surface.vertices[v]); });
}

template <int Dim>
void SurfaceBend<Dim>::apply(Shape<Dim>& shape) const {
  for (Surface<Dim>* surface : {&shape.surface, &shape.evidence.observed, &shape.evidence.unobserved}) apply(*surface);
}

template class SurfaceBend<2>;
template class SurfaceBend<3>;

}  // namespace shellmatch
