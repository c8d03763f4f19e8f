#include "matching/pairs/coverage.h"

#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"
#include "grid/fields/interpolation.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shellmatch {

namespace {

/// Number along a Morton curve: points that are close on the curve are close in space.
template <int Dim>
std::uint64_t morton_number(const Vec<Dim>& x) {
  std::uint64_t number = 0;
  constexpr int bits = 60 / Dim;
  for (int k = 0; k < Dim; ++k) {
    const auto coordinate = static_cast<std::uint64_t>(std::clamp(x[k], 0.0, 1.0) * ((std::uint64_t{1} << bits) - 1));
    for (int bit = 0; bit < bits; ++bit) number |= ((coordinate >> bit) & 1) << (bit * Dim + k);
  }
  return number;
}

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

}  // namespace

template <int Dim>
Coverage<Dim>::Coverage(const Surface<Dim>& reference, const Surface<Dim>& template_shape, const CoverageOptions& options,
                        const ObservedPair<Dim>& observed)
    : reference_(&reference), observed_(observed), tolerance_(options.tolerance * bounding_box(template_shape.vertices).diagonal()) {
  const auto n_samples = static_cast<std::size_t>(options.samples);
  const std::size_t n = template_shape.vertices.size();
  std::vector<double> area(n, 0.0);
  std::vector<Vec<Dim>> normal(n, Vec<Dim>::Zero());
  for (Index f = 0; f < static_cast<Index>(template_shape.facets.size()); ++f) {
    const Vec<Dim> of_facet = facet_normal(template_shape, f);
    for (const Index v : template_shape.facets[f]) {
      area[v] += facet_measure(template_shape, f) / Dim;
      normal[v] += of_facet;
    }
  }
  std::vector<std::size_t> order;
  for (std::size_t v = 0; v < n; ++v)
    if (area[v] > 0 && normal[v].norm() > 0 && observed.template_shape.contains(template_shape.vertices[v])) order.push_back(v);
  double total = 0;
  for (const std::size_t v : order) total += area[v];
  const auto sample = [&](std::size_t v, double stands_for) {
    samples_.push_back({template_shape.vertices[v], normal[v].normalized(), stands_for});
  };
  if (order.size() <= n_samples) {
    for (const std::size_t v : order) sample(v, area[v]);
    return;
  }
  std::vector<std::uint64_t> number(n);
  for (const std::size_t v : order) number[v] = morton_number<Dim>(template_shape.vertices[v]);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return number[a] < number[b]; });
  const double each = total / static_cast<double>(n_samples);
  double passed = 0, next = 0.5 * each;
  for (const std::size_t v : order) {
    passed += area[v];
    if (passed < next) continue;
    const double count = std::floor((passed - next) / each) + 1;  // a vertex may stand for several shares
    sample(v, count * each);
    next += count * each;
  }
}

template <int Dim>
PointPairs<Dim> Coverage<Dim>::pairs(const Octree<Dim>& grid, std::span<const Vec<Dim>> phi) const {
  Surface<Dim> deformed = *reference_;
  parallel_for(deformed.vertices.size(), [&](std::size_t i) {
    const LocalPoint<Dim> at = locate_local(grid, reference_->vertices[i]);
    const auto n = shape_values<Dim>(at.xi);
    const auto& nodes = grid.cell(at.cell).nodes;
    deformed.vertices[i].setZero();
    for (int c = 0; c < n_corners<Dim>; ++c) deformed.vertices[i] += n[c] * phi[nodes[c]];
  });
  const FacetTree<Dim> tree(deformed);
  std::vector<PointPair<Dim>> found(samples_.size());
  parallel_for(
      samples_.size(),
      [&](std::size_t i) {
        const Sample& s = samples_[i];
        found[i] = {Vec<Dim>::Zero(), s.y, 0, s.normal};
        const Index f = tree.nearest(s.y);
        if (f == no_index || facet_normal(deformed, f).dot(s.normal) <= 0) return;
        found[i].p = preimage(*reference_, deformed, f, closest_point_on_facet(deformed, f, s.y).point);
        if (observed_.reference.contains(found[i].p)) found[i].weight = s.area;
      },
      64);
  std::erase_if(found, [](const PointPair<Dim>& pair) { return !(pair.weight > 0); });
  PointPairs<Dim> result{.pairs = std::move(found)};
  result.tolerance = tolerance_;
  return result;
}

template class Coverage<2>;
template class Coverage<3>;

}  // namespace shellmatch
