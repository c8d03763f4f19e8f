#pragma once
/// \file
/// The accuracy of the curvatures that a grid resolves: the shape operator that the energies use, evaluated at the
/// surface's vertices, against fits to the mesh and, where available, formulas.

#include "geometry/generate/exact_shape.h"
#include "geometry/surface/surface.h"
#include "matching/experiment/options.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Principal curvatures with respect to the outward normal, in 1/length of the user's coordinates. NaN where unknown.
template <int Dim>
struct PrincipalCurvature {
  double k1, k2;   ///< k1 >= k2; in the plane k1 is the curve's curvature and k2 is NaN
  Vec<Dim> first;  ///< unit direction of k1, up to its sign
};

/// Principal curvatures of the tangential part P S P of a shape operator, with P the projection orthogonal to the unit
/// vector `normal`.
template <int Dim>
PrincipalCurvature<Dim> principal_curvature(const Mat<Dim>& shape_operator, const Vec<Dim>& normal);

/// Parameters of the polynomials fitted to the mesh.
struct MeshFit {
  int degree = 2;   ///< 2 to 4; in the plane always 2
  int n_rings = 2;  ///< rings of neighbours that the fit uses, 1 to 10
};

struct ErrorQuantiles {
  double median, p95;  ///< NaN if there was nothing to compare
};

/// Differences over all vertices where both sides are known: of curvatures in units of 1/(diagonal of the bounding
/// box), and of the directions of k1 in degrees, 0 to 90, where |k1 - k2| is more than a quarter of the larger one and
/// of 1/diagonal.
struct CurvatureErrors {
  ErrorQuantiles k1, k2, direction;
  std::size_t n_vertices, n_directions;
};

template <int Dim>
CurvatureErrors compare_curvatures(const std::vector<PrincipalCurvature<Dim>>& found,
                                   const std::vector<PrincipalCurvature<Dim>>& expected, double diagonal);

/// The results on the grid of one level of the cascade.
struct CurvatureLevel {
  int level = 0;
  double side = 0;  ///< side of its finest cells, in units of the diagonal
  Index n_nodes = 0, n_free_nodes = 0;
  double distance_seconds = 0, coefficient_seconds = 0;
  CurvatureErrors to_mesh_fit = {};
  std::optional<CurvatureErrors> to_formula = {};
  std::optional<CurvatureErrors> formula_to_formula = {};  ///< with the distance by formula instead of the mesh's
};

template <int Dim>
struct CurvatureComparison {
  Surface<Dim> surface;                           ///< after repair, user's coordinates
  double diagonal = 0;                            ///< length in the user's coordinates
  std::vector<PrincipalCurvature<Dim>> grid;      ///< of the finest level, at the surface's vertices
  std::vector<PrincipalCurvature<Dim>> mesh_fit;  ///< CGAL's jet fitting, or parabolas in the plane
  std::vector<PrincipalCurvature<Dim>> formula;   ///< empty without a formula
  std::vector<CurvatureLevel> levels;
  std::optional<CurvatureErrors> mesh_fit_to_formula;
};

/// Compares on grids from options.cascade.min_level to max_level, refined at the surface, with the placement of
/// options.input and the coefficients of options.coefficients. `finished` is called after each level and may throw.
/// \throws InputError for placement as-is of a shape that reaches beyond the domain
template <int Dim>
CurvatureComparison<Dim> compare_curvatures(const Shape<Dim>& shape, const std::optional<ExactShape<Dim>>& formula,
                                            const ExperimentOptions& options, const MeshFit& fit,
                                            const std::function<void(const CurvatureLevel&)>& finished);

}  // namespace shellmatch
