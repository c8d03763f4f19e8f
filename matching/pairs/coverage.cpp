#include "matching/pairs/coverage.h"

#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"
#include "grid/fields/interpolation.h"

#include <Eigen/LU>

namespace shellmatch {

namespace {

/// The point of the undeformed facet with the barycentric coordinates that x has in the deformed one.
template <int Dim>
Vec<Dim> preimage(const Surface<Dim>& reference, const Surface<Dim>& deformed, Index f, const Vec<Dim>& x) {
  const auto& facet = reference.facets[f];
  const auto at = [&](const Surface<Dim>& s, int k) -> const Vec<Dim>& { return s.vertices[facet[k]]; };
  Eigen::Matrix<double, Dim, Dim - 1> edges, edges_before;
  for (int k = 1; k < Dim; ++k) {
    edges.col(k - 1) = at(deformed, k) - at(deformed, 0);
    edges_before.col(k - 1) = at(reference, k) - at(reference, 0);
  }
  const Eigen::Matrix<double, Dim - 1, Dim - 1> gram = edges.transpose() * edges;
  Eigen::Matrix<double, Dim - 1, 1> b = gram.inverse() * (edges.transpose() * (x - at(deformed, 0)));
  if (!b.allFinite()) b.setZero();  // a facet without area
  b = b.cwiseMax(0.0).cwiseMin(1.0);
  if (b.sum() > 1) b /= b.sum();
  return at(reference, 0) + edges_before * b;
}

template <int Dim>
Surface<Dim> deformed_surface(const Surface<Dim>& reference, const Octree<Dim>& grid, std::span<const Vec<Dim>> phi) {
  Surface<Dim> deformed = reference;
  parallel_for(deformed.vertices.size(), [&](std::size_t i) {
    const LocalPoint<Dim> at = locate_local(grid, reference.vertices[i]);
    const auto n = shape_values<Dim>(at.xi);
    const auto& nodes = grid.cell(at.cell).nodes;
    deformed.vertices[i].setZero();
    for (int c = 0; c < n_corners<Dim>; ++c) deformed.vertices[i] += n[c] * phi[nodes[c]];
  });
  return deformed;
}

/// pair(i), of weight 0 where there is none, for i < n, appended in their order.
template <int Dim, class Pair>
void append_pairs(std::size_t n, const Pair& pair, std::vector<PointPair<Dim>>& found) {
  std::vector<PointPair<Dim>> made(n);
  parallel_for(n, [&](std::size_t i) { made[i] = pair(i); }, 64);
  for (const PointPair<Dim>& p : made)
    if (p.weight > 0) found.push_back(p);
}

}  // namespace

template <int Dim>
Coverage<Dim>::Coverage(const Surface<Dim>& reference, const SignedDistance<Dim>& template_shape, const CoverageOptions& options,
                        const ObservedPair<Dim>& observed)
    : reference_(&reference),
      template_(&template_shape),
      options_(options),
      observed_(observed),
      tolerance_(options.tolerance * bounding_box(template_shape.surface().vertices).diagonal()) {
  const auto most = static_cast<std::size_t>(options.samples);
  on_reference_ = sample_vertices<Dim>(reference, most, [&](const Vec<Dim>& x) { return observed.reference.contains(x); });
  on_template_ =
      sample_vertices<Dim>(template_shape.surface(), most, [&](const Vec<Dim>& x) { return observed.template_shape.contains(x); });
}

template <int Dim>
void Coverage<Dim>::add_from_template(const Surface<Dim>& deformed, double h, std::vector<PointPair<Dim>>& found) const {
  const FacetTree<Dim> tree(deformed);
  append_pairs<Dim>(
      on_template_.size(),
      [&](std::size_t i) {
        const SurfaceSample<Dim>& sample = on_template_[i];
        PointPair<Dim> pair{Vec<Dim>::Zero(), template_->surface().vertices[sample.vertex], 0, sample.normal};
        const Index f = tree.nearest(pair.y);
        if (f == no_index || facet_normal(deformed, f).dot(sample.normal) <= 0) return pair;
        const Vec<Dim> nearest = closest_point_on_facet(deformed, f, pair.y).point;
        pair.p = preimage(*reference_, deformed, f, nearest);
        // The planes along a thin part that is drawn in do not attract it to its tip.
        if ((nearest - pair.y).norm() > options_.point_distance * h) pair.normal.setZero();
        if (observed_.reference.contains(pair.p)) pair.weight = sample.area;
        return pair;
      },
      found);
}

template <int Dim>
void Coverage<Dim>::add_from_reference(const Surface<Dim>& deformed, std::vector<PointPair<Dim>>& found) const {
  const std::vector<Vec<Dim>> normals = vertex_normals(deformed);
  append_pairs<Dim>(
      on_reference_.size(),
      [&](std::size_t i) {
        const auto& [vertex, normal, area] = on_reference_[i];
        PointPair<Dim> pair{reference_->vertices[vertex], Vec<Dim>::Zero(), 0};
        const ClosestPoint<Dim> nearest = template_->closest(deformed.vertices[vertex]);
        pair.y = nearest.point;
        pair.normal = facet_normal(template_->surface(), nearest.facet);
        if (pair.normal.dot(normals[vertex]) <= 0) return pair;
        pair.normal.normalize();
        if (observed_.template_shape.contains(pair.y)) pair.weight = area;
        return pair;
      },
      found);
}

template <int Dim>
PointPairs<Dim> Coverage<Dim>::pairs(const Octree<Dim>& grid, std::span<const Vec<Dim>> phi) const {
  const Surface<Dim> deformed = deformed_surface(*reference_, grid, phi);
  PointPairs<Dim> result;
  const double h = grid.finest_side();
  add_from_template(deformed, h, result.pairs);
  add_from_reference(deformed, result.pairs);
  result.tolerance = tolerance_;
  result.loss = RobustLoss::huber;
  result.scale = options_.loss_scale * h;
  return result;
}

template class Coverage<2>;
template class Coverage<3>;

}  // namespace shellmatch
