#pragma once
/// \file
/// A small matching with everything that an energy refers to in one object, and deformations to try it on.

#include "energies/assembly/matching_energy.h"
#include "grid/fits/curvature.h"

#include <functional>
#include <optional>

namespace shellmatch::test {

/// Weight 1 for one term, 0 for the others.
TermValues only(Term term);

/// A grid refined towards the sphere of this radius around the centre, with hanging nodes of every kind.
template <int Dim>
Octree<Dim> hanging_grid(double radius);

/// The sum of element gradients by the unknowns, block by block.
template <int Dim>
std::vector<double> sum_elements(const Unknowns<Dim>& unknowns, std::span<const double> element_gradients);

/// Values of a vector field at the nodes, hanging nodes in their place between their parents.
template <int Dim>
std::vector<Vec<Dim>> at_nodes(const Octree<Dim>& grid, const std::function<Vec<Dim>(const Vec<Dim>&)>& field);

/// A smooth field of size about 1 that is neither symmetric nor affine.
template <int Dim>
std::function<Vec<Dim>(const Vec<Dim>&)> smooth_field(unsigned seed);

/// x + amplitude times a smooth field; with `fixed_boundary` the field is damped to 0 at the domain's boundary.
template <int Dim>
std::vector<Vec<Dim>> deformed(const Octree<Dim>& grid, double amplitude, unsigned seed, bool fixed_boundary = false);

/// Fields of a target that are linear in space and belong to no shape: their interpolation has no kinks, so that the
/// energy is smooth in phi.
template <int Dim>
CoefficientFields<Dim> linear_fields(const Octree<Dim>& grid);

struct ProblemOptions {
  EnergyOptions energy{};
  bool root_is_inverse = false;  ///< what the reference's root is
  double sigma_over_h = 2;
  int points_per_direction = 2;
  bool smooth = false;  ///< splines instead of multilinear fields
};

template <int Dim>
GeometryField<Dim> field(const Octree<Dim>& grid, const CoefficientFields<Dim>& nodal, bool smooth);

template <int Dim>
struct Problem {
  const Octree<Dim>& grid;  ///< must outlive the problem
  CoefficientFields<Dim> reference, target_values;
  EnergyOptions options;
  Unknowns<Dim> unknowns;
  GeometryPair<Dim> geometry;
  double sigma;  ///< half width of the band
  const GeometryField<Dim>& target = geometry.target;
  std::shared_ptr<EnergyTerms<Dim>> terms;
  MatchingEnergy<Dim> energy;

  Problem(const Octree<Dim>& grid, CoefficientFields<Dim> reference, CoefficientFields<Dim> target,
          const ProblemOptions& options = {});
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  /// Weighted values, or nothing where the energy cannot be evaluated.
  std::optional<TermValues> values(const std::vector<Vec<Dim>>& phi, const TermValues& weights) const;
  /// The same for one term.
  double value(const std::vector<Vec<Dim>>& phi, Term term) const;
  /// Gradient by the unknowns; the energy must be evaluable.
  std::vector<double> gradient(const std::vector<Vec<Dim>>& phi, const TermValues& weights) const;
};

}  // namespace shellmatch::test
