#include "grid/fits/curvature.h"

#include "base/decompositions.h"
#include "base/parallel.h"
#include "grid/fields/projection.h"
#include "grid/octree/constraints.h"

#include <algorithm>

namespace shellmatch {

namespace {

/// hessian(i) is the Hessian of the distance at nodes[i].
template <int Dim>
NodalGeometry<Dim> assemble(const Octree<Dim>& grid, std::vector<double> distance, const CoefficientOptions& options,
                            const auto& hessian, std::span<const Index> nodes) {
  NodalGeometry<Dim> g;
  g.distance = std::move(distance);
  g.normal = nodal_normals(grid, g.distance, options.normal_mass);
  g.extended_shape.resize(grid.n_nodes());
  const auto free = grid.free_nodes();
  parallel_for(free.size(), [&](std::size_t i) {
    g.extended_shape[free[i]] = pack_symmetric<Dim>(g.normal[free[i]] * g.normal[free[i]].transpose());
  });
  parallel_for(nodes.size(), [&](std::size_t i) {
    g.extended_shape[nodes[i]] =
        pack_symmetric<Dim>(extended_shape_operator<Dim>(unpack_symmetric<Dim>(hessian(i)), g.normal[nodes[i]]));
  });
  distribute(grid, g.extended_shape);
  return g;
}

}  // namespace

template <int Dim>
NodalGeometry<Dim> nodal_geometry(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                  const CoefficientOptions& options, std::span<const Index> nodes) {
  if (nodes.empty()) nodes = grid.free_nodes();
  const auto hessians = fit_hessians(grid, nodal_distance, options, nodes);
  return assemble<Dim>(
      grid, std::move(nodal_distance), options, [&](std::size_t i) { return hessians[i]; }, nodes);
}

template <int Dim>
NodalGeometry<Dim> nodal_geometry(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                  const CoefficientOptions& options, const HierarchicalFit<Dim>& hessians) {
  const auto free = grid.free_nodes();
  return assemble<Dim>(
      grid, std::move(nodal_distance), options, [&](std::size_t i) { return hessians[free[i]]; }, free);
}

template <int Dim>
std::array<NodalGeometry<Dim>, 2> nodal_geometry(const Octree<Dim>& grid,
                                                 std::array<std::vector<double>, 2> nodal_distances,
                                                 const CoefficientOptions& options, std::span<const Index> nodes) {
  if (nodes.empty()) nodes = grid.free_nodes();
  const auto hessians = fit_hessians(grid, nodal_distances, options, nodes);
  const auto of = [&](int s) {
    return assemble<Dim>(
        grid, std::move(nodal_distances[s]), options, [&](std::size_t i) { return hessians[s][i]; }, nodes);
  };
  return {of(0), of(1)};
}

namespace {

template <int Dim>
double least_curvature(const Octree<Dim>& grid, const NodalGeometry<Dim>& geometry) {
  double least = 0;
  for (const Index node : grid.free_nodes()) {
    const Mat<Dim> s = unpack_symmetric<Dim>(geometry.extended_shape[node]);
    least = std::min(least, eigenpairs<Dim>(s).values[0]);
  }
  return least;
}

}  // namespace

template <int Dim>
Classifier make_classifier(const GridPair<Dim>& grids, const CoefficientOptions& options,
                           const NodalGeometry<Dim>& first, const NodalGeometry<Dim>& second) {
  Classifier c{.kind = options.classification, .tau = options.tau, .cap = 0, .shift = 0, .root = options.root};
  // The finer grid would admit a larger cap, but C must be the same function for both.
  c.cap = options.max_curvature_times_h / std::max(grids[0]->finest_side(), grids[1]->finest_side());
  if (c.kind == Classification::shift) {
    const double least = std::min(least_curvature(*grids[0], first), least_curvature(*grids[1], second));
    c.shift = options.tau - (c.cap > 0 ? std::max(least, -c.cap) : least);
  }
  return c;
}

template <int Dim>
CoefficientFields<Dim> classify(const Octree<Dim>& grid, NodalGeometry<Dim> geometry, const Classifier& classifier,
                                bool inverse_root) {
  CoefficientFields<Dim> fields{std::move(geometry.distance), std::move(geometry.normal),
                                std::move(geometry.extended_shape)};
  const auto free = grid.free_nodes();
  const double exponent = inverse_root ? -0.5 : 0.5;
  parallel_for(free.size(), [&](std::size_t i) {
    auto& s = fields.root[free[i]];
    const Vec<Dim>& normal = fields.normal[free[i]];
    const bool is_extended = classifier.root == RootMethod::eigen && !normal.isZero();  // by a unit normal
    s = pack_symmetric<Dim>(is_extended ? classified_power<Dim>(unpack_symmetric<Dim>(s), normal, classifier, exponent)
                                        : classified_power<Dim>(unpack_symmetric<Dim>(s), classifier, exponent));
  });
  distribute(grid, fields.root);
  return fields;
}

template <int Dim>
CoefficientFields<Dim> compute_coefficients(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                            const CoefficientOptions& options, bool inverse_root) {
  auto geometry = nodal_geometry(grid, std::move(nodal_distance), options);
  const Classifier classifier = make_classifier<Dim>({&grid, &grid}, options, geometry, geometry);
  return classify(grid, std::move(geometry), classifier, inverse_root);
}

template <int Dim>
CoefficientPair<Dim> coefficient_pair(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry,
                                      const CoefficientOptions& options) {
  const Classifier classifier = make_classifier(grids, options, geometry[0], geometry[1]);
  std::array<CoefficientFields<Dim>, 2> fields;
  for_both([&](int s) {
    fields[s] = classify(*grids[s], std::move(geometry[s]), classifier, s == 0 && !options.invert_at_point);
  });
  return {std::move(fields[0]), std::move(fields[1])};
}

template <int Dim>
CoefficientPair<Dim> shape_operator_pair(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry,
                                         const CoefficientOptions& options) {
  const double cap = options.max_curvature_times_h / std::max(grids[0]->finest_side(), grids[1]->finest_side());
  const auto operators = [&](const Octree<Dim>& grid, NodalGeometry<Dim>& g) {
    const auto free = grid.free_nodes();
    parallel_for(free.size(), [&](std::size_t i) {
      const Vec<Dim>& n = g.normal[free[i]];
      Mat<Dim> s = unpack_symmetric<Dim>(g.extended_shape[free[i]]) - n * n.transpose();
      if (cap > 0) {
        const Eigenpairs<Dim> eigen = eigenpairs<Dim>(s);
        const Vec<Dim> capped = eigen.values.cwiseMax(-cap).cwiseMin(cap);
        s = eigen.vectors * capped.asDiagonal() * eigen.vectors.transpose();
      }
      g.extended_shape[free[i]] = pack_symmetric<Dim>(s);
    });
    distribute(grid, g.extended_shape);
    return CoefficientFields<Dim>{std::move(g.distance), std::move(g.normal), std::move(g.extended_shape)};
  };
  return {operators(*grids[0], geometry[0]), operators(*grids[1], geometry[1])};
}

SHELLMATCH_2D_3D(make_classifier);
SHELLMATCH_2D_3D(classify);
SHELLMATCH_2D_3D(compute_coefficients);
SHELLMATCH_2D_3D(coefficient_pair);
SHELLMATCH_2D_3D(shape_operator_pair);
#define SHELLMATCH_INSTANTIATE(Dim)                                                                                   \
  template NodalGeometry<Dim> nodal_geometry<Dim>(const Octree<Dim>&, std::vector<double>, const CoefficientOptions&, \
                                                  std::span<const Index>);                                            \
  template std::array<NodalGeometry<Dim>, 2> nodal_geometry<Dim>(                                                     \
      const Octree<Dim>&, std::array<std::vector<double>, 2>, const CoefficientOptions&, std::span<const Index>);     \
  template NodalGeometry<Dim> nodal_geometry<Dim>(const Octree<Dim>&, std::vector<double>, const CoefficientOptions&, \
                                                  const HierarchicalFit<Dim>&);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
