#include "matching/shape_report/curvature_comparison.h"

#include "base/parallel.h"
#include "geometry/curvature/curvature.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/surface/placement.h"
#include "grid/fields/fast_marching.h"
#include "grid/fields/interpolation.h"
#include "grid/fields/sample.h"
#include "grid/fits/curvature.h"
#include "grid/octree/surface_cells.h"
#include "matching/progress/phase_clock.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace shellmatch {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <int Dim>
using Curvatures = std::vector<PrincipalCurvature<Dim>>;
template <int Dim>
using Distance = std::function<double(const Vec<Dim>&)>;

// The free nodes on which the values in the leaves around the points depend, in ascending order.
template <int Dim>
std::vector<Index> nodes_around(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& points) {
  std::vector<char> needed(grid.n_nodes(), 0);
  for (const Vec<Dim>& x : points)
    for (const Index node : grid.cell(grid.locate(x)).nodes) needed[node] = 1;
  for (const HangingNode<Dim>& h : grid.hanging_nodes())
    for (int p = 0; p < h.n_parents && needed[h.node]; ++p) needed[h.parents[p]] = 1;
  std::vector<Index> nodes;
  for (const Index node : grid.free_nodes())
    if (needed[node]) nodes.push_back(node);
  return nodes;
}

// The curvatures that the energies would read at these points, times `scale`.
template <int Dim>
Curvatures<Dim> curvatures_on_grid(const Octree<Dim>& grid, const std::vector<double>& distance,
                                   const CoefficientOptions& options, const std::vector<Vec<Dim>>& points,
                                   double scale) {
  const auto geometry = nodal_geometry<Dim>(grid, distance, options, nodes_around(grid, points));
  Curvatures<Dim> result(points.size());
  parallel_for(points.size(), [&](std::size_t i) {
    const LocalPoint<Dim> p = locate_local(grid, points[i]);
    const auto components = evaluate_components<Dim*(Dim + 1) / 2>(grid, components_of(geometry.extended_shape), p);
    const Vec<Dim> normal = evaluate(grid, geometry.normal, p).normalized();
    result[i] = principal_curvature<Dim>(scale * unpack_symmetric<Dim>(components), normal);
  });
  return result;
}

// Calls finished(level, grid, curvatures, seconds) for every level.
template <int Dim, class Finished>
void over_levels(const Distance<Dim>& distance, const std::vector<Vec<Dim>>& points, double scale,
                 const ExperimentOptions& options, const Finished& finished) {
  Octree<Dim> grid(options.cascade.min_level);
  for (int level = options.cascade.min_level;; ++level) {
    std::map<std::string, double> seconds;
    PhaseClock clock(seconds);
    clock.start("distance");
    const bool march = options.coefficients.distance == DistanceMethod::fast_marching;
    const std::vector<double> nodal = march ? march_distance<Dim>(grid, distance) : sample_nodes<Dim>(grid, distance);
    clock.start("coefficients");
    const auto curvatures = curvatures_on_grid(grid, nodal, options.coefficients, points, scale);
    clock.stop();
    finished(level, grid, curvatures, seconds);
    if (level == options.cascade.max_level) return;
    grid.refine([&](Index leaf) { return meets_surface<Dim>(grid, nodal, distance, leaf); });
  }
}

Curvatures<3> fit_to_mesh(const Surface<3>& surface, const MeshFit& fit) {
  Curvatures<3> result;
  for (const VertexCurvature& v : vertex_curvatures(surface, {.degree = fit.degree, .n_rings = fit.n_rings}))
    result.push_back({v.k1, v.k2, v.d1});
  return result;
}

Curvatures<2> fit_to_mesh(const Surface<2>& curve, const MeshFit& fit) {
  Curvatures<2> result;
  for (const double k : curve_curvatures(curve, fit.n_rings)) result.push_back({k, nan, Vec<2>::Constant(nan)});
  return result;
}

template <int Dim>
Curvatures<Dim> by_formula(const Surface<Dim>& surface, const ExactShape<Dim>& formula) {
  std::vector<Vec<Dim>> normals(surface.vertices.size(), Vec<Dim>::Zero());
  for (Index f = 0; f < static_cast<Index>(surface.facets.size()); ++f)
    for (const Index v : surface.facets[f]) normals[v] += facet_normal(surface, f);
  Curvatures<Dim> result;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const Mat<Dim> s = formula.shape_operator(surface.vertices[v]);
    // Points where S vanishes have no normal of their own. The mesh's normal is sufficient, because P S P removes its
    // error.
    result.push_back(principal_curvature<Dim>(s, normals[v].normalized()));
  }
  return result;
}

ErrorQuantiles quantiles(std::vector<double> errors) {
  if (errors.empty()) return {nan, nan};
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
  };
  return {at(0.5), at(0.95)};
}

}  // namespace

template <int Dim>
PrincipalCurvature<Dim> principal_curvature(const Mat<Dim>& s, const Vec<Dim>& normal) {
  if constexpr (Dim == 2) {
    const Vec<2> tangent(-normal[1], normal[0]);
    return {tangent.dot(s * tangent), nan, tangent};
  } else {
    const Vec<3> t1 = normal.unitOrthogonal(), t2 = normal.cross(t1);
    const double a = t1.dot(s * t1), b = t1.dot(s * t2), c = t2.dot(s * t2);
    const double mean = 0.5 * (a + c), half = 0.5 * (a - c), radius = std::hypot(half, b);
    const double angle = 0.5 * std::atan2(b, half);
    return {mean + radius, mean - radius, std::cos(angle) * t1 + std::sin(angle) * t2};
  }
}

template <int Dim>
CurvatureErrors compare_curvatures(const Curvatures<Dim>& found, const Curvatures<Dim>& expected, double diagonal) {
  std::vector<double> k1, k2, direction;
  for (std::size_t v = 0; v < found.size(); ++v) {
    const PrincipalCurvature<Dim>&f = found[v], &e = expected[v];
    if (!std::isfinite(f.k1) || !std::isfinite(e.k1)) continue;
    k1.push_back(std::abs(f.k1 - e.k1) * diagonal);
    if constexpr (Dim == 3) {
      k2.push_back(std::abs(f.k2 - e.k2) * diagonal);
      const double least_gap = std::max(0.25 * std::max(std::abs(e.k1), std::abs(e.k2)), 1 / diagonal);
      if (e.k1 - e.k2 > least_gap)
        direction.push_back(std::atan2(f.first.cross(e.first).norm(), std::abs(f.first.dot(e.first))) * 180 / M_PI);
    }
  }
  const std::size_t n = k1.size(), n_directions = direction.size();
  return {quantiles(std::move(k1)), quantiles(std::move(k2)), quantiles(std::move(direction)), n, n_directions};
}

template <int Dim>
CurvatureComparison<Dim> compare_curvatures(const Shape<Dim>& shape, const std::optional<ExactShape<Dim>>& formula,
                                            const ExperimentOptions& options, const MeshFit& fit,
                                            const std::function<void(const CurvatureLevel&)>& finished) {
  CurvatureComparison<Dim> result;
  result.surface = shape.surface;
  const double diagonal = result.diagonal = bounding_box(shape.surface.vertices).diagonal();
  const double clearance = std::ldexp(1.0, -options.cascade.max_level);
  const Similarity<Dim> placement = options.input.placement == PlacementKind::fit
                                        ? fit_placement(shape, shape, options.input.margin)
                                        : as_is_placement(shape, shape, clearance);
  Surface<Dim> placed = shape.surface;
  apply_similarity(placement, placed);

  result.mesh_fit = fit_to_mesh(shape.surface, fit);
  std::vector<CurvatureErrors> formula_to_formula;
  if (formula) {
    result.formula = by_formula(shape.surface, *formula);
    result.mesh_fit_to_formula = compare_curvatures<Dim>(result.mesh_fit, result.formula, diagonal);
    over_levels<Dim>([&](const Vec<Dim>& y) { return placement.scale * formula->distance(placement.inverse(y)); },
                     placed.vertices, placement.scale, options,
                     [&](int, const auto&, const Curvatures<Dim>& curvatures, const auto&) {
                       formula_to_formula.push_back(compare_curvatures<Dim>(curvatures, result.formula, diagonal));
                     });
  }
  const SignedDistance<Dim> distance(placed);
  over_levels<Dim>(std::cref(distance), placed.vertices, placement.scale, options,
                   [&](int level, const Octree<Dim>& grid, const Curvatures<Dim>& curvatures, auto& seconds) {
                     CurvatureLevel l;
                     l.level = level;
                     l.side = grid.finest_side() / (placement.scale * diagonal);
                     l.n_nodes = grid.n_nodes();
                     l.n_free_nodes = static_cast<Index>(grid.free_nodes().size());
                     l.distance_seconds = seconds["distance"];
                     l.coefficient_seconds = seconds["coefficients"];
                     l.to_mesh_fit = compare_curvatures<Dim>(curvatures, result.mesh_fit, diagonal);
                     if (formula) {
                       l.to_formula = compare_curvatures<Dim>(curvatures, result.formula, diagonal);
                       l.formula_to_formula = formula_to_formula[result.levels.size()];
                     }
                     result.levels.push_back(l);
                     result.grid = curvatures;
                     finished(l);
                   });
  return result;
}

SHELLMATCH_2D_3D(principal_curvature);
#define SHELLMATCH_INSTANTIATE(Dim)                                                                                   \
  template CurvatureErrors compare_curvatures<Dim>(const Curvatures<Dim>&, const Curvatures<Dim>&, double);           \
  template CurvatureComparison<Dim> compare_curvatures<Dim>(const Shape<Dim>&, const std::optional<ExactShape<Dim>>&, \
                                                            const ExperimentOptions&, const MeshFit&,                 \
                                                            const std::function<void(const CurvatureLevel&)>&);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
