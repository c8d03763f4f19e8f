#include "matching/level/shape_fields.h"

#include "base/parallel.h"
#include "grid/fields/fast_marching.h"
#include "grid/octree/constraints.h"
#include "grid/octree/surface_cells.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace shellmatch {

template <int Dim>
void NodalDistance<Dim>::compute(const Octree<Dim>& grid, const SignedDistance<Dim>& shape, DistanceMethod method) {
  if (method == DistanceMethod::fast_marching) {
    values_ = march_distance<Dim>(grid, std::cref(shape));
    return;
  }
  const std::size_t known = values_.size();
  values_.resize(static_cast<std::size_t>(grid.n_nodes()));
  parallel_chunks(values_.size() - known, 256, [&](const Chunk& chunk) {
    std::vector<Vec<Dim>> nodes;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      nodes.push_back(grid.node_position(static_cast<Index>(known + i)));
    shape(nodes, std::span(values_).subspan(known + chunk.begin, nodes.size()));
  });
}

template <int Dim>
void FieldGrid<Dim>::compute(const SignedDistance<Dim>& shape, const CoefficientOptions& options) {
  distance.compute(grid, shape, options.distance);
  // Fast marching changes the distances at all nodes, so all fits have to be computed again.
  if (options.distance == DistanceMethod::fast_marching) hessians = {};
  hessians.update(grid, distance.values(), options);
}

template <int Dim>
void FieldGrid<Dim>::refine(double reach) {
  const int finest = grid.finest_level();
  grid.refine([&](Index leaf) {
    const auto& cell = grid.cell(leaf);
    if (cell.level < finest) return false;
    for (const Index node : cell.nodes)
      if (std::abs(distance.values()[node]) <= reach * cell.side()) return true;
    return false;
  });
}

template class NodalDistance<2>;
template class NodalDistance<3>;
template struct FieldGrid<2>;
template struct FieldGrid<3>;

namespace {

/// The values at all nodes of the finite element function with these values at the free nodes.
template <int Dim>
std::vector<double> conforming(const Octree<Dim>& grid, std::vector<double> nodal) {
  distribute(grid, nodal);
  return nodal;
}

bool takes_inverse_root(const ExperimentOptions& o) {
  return reads_shape_operators(o.energy) || !o.coefficients.invert_at_point;
}

}  // namespace

template <int Dim>
ShapeFields<Dim>::ShapeFields(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
                              const ExperimentOptions& options)
    : shapes_{&reference, &template_shape}, options_(&options) {
  if (is_smooth())
    for (auto& own : own_) own.emplace(options.cascade.min_level);
}

template <int Dim>
void ShapeFields<Dim>::compute_distances_on(const Octree<Dim>& grid) {
  const int n_shapes = refines_at_template(*options_) ? 2 : 1;
  for (int s = 0; s < n_shapes; ++s) on_grid_[s].compute(grid, *shapes_[s], options_->coefficients.distance);
}

template <int Dim>
void ShapeFields<Dim>::compute_distances(const Octree<Dim>& grid) {
  if (!is_smooth()) return compute_distances_on(grid);
  if (!own_[0]) return;
  const int level = field_level(grid);
  if (own_[0]->grid.finest_level() < level) smooth_.reset();
  for_both([&](int s) {
    FieldGrid<Dim>& own = *own_[s];
    if (own.distance.values().empty()) own.compute(*shapes_[s], options_->coefficients);
    while (own.grid.finest_level() < level) {
      own.refine(options_->coefficients.reach);
      own.compute(*shapes_[s], options_->coefficients);
    }
  });
  const double n = static_cast<double>(own_[0]->grid.n_nodes()) + static_cast<double>(own_[1]->grid.n_nodes());
  if (n > n_field_nodes_.back()) n_field_nodes_.push_back(n);
}

template <int Dim>
int ShapeFields<Dim>::field_level(const Octree<Dim>& grid) const {
  return std::min(grid.finest_level() + options_->coefficients.levels_ahead, options_->cascade.max_level);
}

template <int Dim>
double ShapeFields<Dim>::n_new_field_nodes(const Octree<Dim>& grid) const {
  if (!is_smooth() || !own_[0]) return 0;
  const int n_levels = field_level(grid) - own_[0]->grid.finest_level();
  const double n = n_field_nodes_.back();
  // A level refines the layer of cells around the surface, whose number grows as that of the surface's cells does.
  double sum = 0, last = n_field_nodes_.size() > 1 ? n - n_field_nodes_[n_field_nodes_.size() - 2] : 0;
  if (n == 0) sum = last = 2 * static_cast<double>(own_[0]->grid.n_nodes());
  for (int l = 0; l < n_levels; ++l) sum += last *= n_corners<Dim> / 2;
  return sum;
}

template <int Dim>
CoefficientPair<Dim> ShapeFields<Dim>::coefficients(const GridPair<Dim>& grids,
                                                    std::array<NodalGeometry<Dim>, 2> geometry) const {
  const auto compute = reads_shape_operators(options_->energy) ? shape_operator_pair<Dim> : coefficient_pair<Dim>;
  return compute(grids, std::move(geometry), options_->coefficients);
}

template <int Dim>
GeometryPair<Dim> ShapeFields<Dim>::geometry(const Octree<Dim>& grid) {
  if (!is_smooth()) {
    const auto nodal = coefficients(
        {&grid, &grid},
        nodal_geometry<Dim>(grid, {conforming(grid, on_grid_[0].values()), conforming(grid, on_grid_[1].values())},
                            options_->coefficients));
    return multilinear_geometry(grid, nodal.reference, nodal.target, *options_);
  }
  if (!smooth_) smooth_ = smooth_geometry();
  return *smooth_;
}

template <int Dim>
GeometryPair<Dim> ShapeFields<Dim>::smooth_geometry() {
  // No refinement follows the finest level, so that intermediate data are released as soon as they have been used.
  const bool last = own_[0]->grid.finest_level() == options_->cascade.max_level;
  std::array<NodalGeometry<Dim>, 2> geometry;
  for_both([&](int s) {
    FieldGrid<Dim>& own = *own_[s];
    geometry[s] = nodal_geometry<Dim>(own.grid, last ? own.distance.take() : own.distance.values(),
                                      options_->coefficients, own.hessians);
    if (last) own.hessians = {};
  });
  auto nodal = coefficients({&own_[0]->grid, &own_[1]->grid}, std::move(geometry));
  const bool roots = !reads_shape_operators(options_->energy);
  const auto field = [&](int s, CoefficientFields<Dim> of) {
    auto made = GeometryField<Dim>::smooth(own_[s]->grid, of.distance, of.normal, of.root, roots);
    if (last) own_[s].reset();
    return made;
  };
  auto reference = field(0, std::move(nodal.reference));
  return {std::move(reference), field(1, std::move(nodal.target)), takes_inverse_root(*options_)};
}

template <int Dim>
void ShapeFields<Dim>::refine(Octree<Dim>& grid) {
  if (is_smooth()) compute_distances_on(grid);  // refinement alone needs them, hence never on the finest grid
  const int n_shapes = refines_at_template(*options_) ? 2 : 1;
  grid.refine([&](Index leaf) {
    for (int s = 0; s < n_shapes; ++s)
      if (meets_surface<Dim>(grid, on_grid_[s].values(), std::cref(*shapes_[s]), leaf)) return true;
    return false;
  });
}

template <int Dim>
GeometryPair<Dim> multilinear_geometry(const Octree<Dim>& grid, const CoefficientFields<Dim>& reference,
                                       const CoefficientFields<Dim>& target, const ExperimentOptions& options) {
  return {{grid, reference.distance, reference.normal, reference.root},
          {grid, target.distance, target.normal, target.root},
          takes_inverse_root(options)};
}

template <int Dim>
CoefficientFields<Dim> at_nodes(const GeometryField<Dim>& field, const Octree<Dim>& grid) {
  const std::size_t n = static_cast<std::size_t>(grid.n_nodes());
  CoefficientFields<Dim> nodal{std::vector<double>(n), std::vector<Vec<Dim>>(n),
                               std::vector<SymmetricComponents<Dim>>(n)};
  constexpr std::size_t lanes = autodiff::pack_size;
  parallel_for(
      n_chunks(n, lanes),
      [&](std::size_t chunk) {
        std::array<autodiff::Pack, Dim> y;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          const Vec<Dim> x = grid.node_position(static_cast<Index>(std::min(chunk * lanes + lane, n - 1)));
          for (int k = 0; k < Dim; ++k) y[k][lane] = x[k];
        }
        typename GeometryField<Dim>::Packs values;
        field.look_up(autodiff::Pack{} + 1.0, field.find(y), values.data());
        for (std::size_t i = chunk * lanes; i < std::min(n, (chunk + 1) * lanes); ++i) {
          const std::size_t lane = i % lanes;
          nodal.distance[i] = values[0][lane];
          for (int k = 0; k < Dim; ++k) nodal.normal[i][k] = values[1 + k][lane];
          for (int k = 0; k < n_symmetric<Dim>; ++k) nodal.root[i][k] = values[1 + Dim + k][lane];
        }
      },
      128);
  return nodal;
}

template <int Dim>
std::vector<Vec<Dim>> identity_map(const Octree<Dim>& grid) {
  std::vector<Vec<Dim>> phi(static_cast<std::size_t>(grid.n_nodes()));
  for (Index i = 0; i < grid.n_nodes(); ++i) phi[i] = grid.node_position(i);
  return phi;
}

SHELLMATCH_2D_3D(multilinear_geometry);
SHELLMATCH_2D_3D(at_nodes);
SHELLMATCH_2D_3D(identity_map);
template class ShapeFields<2>;
template class ShapeFields<3>;

}  // namespace shellmatch
