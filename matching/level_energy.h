#pragma once
/// \file
/// The energy of an experiment on one grid, with all that it refers to.

#include "energies/energy_hessian.h"
#include "energies/matching_energy.h"
#include "grid/curvature.h"
#include "matching/options.h"

#include <cmath>

namespace shellmatch {

/// sigma on a grid with finest cells of this side.
inline double band_half_width(const CascadeOptions& o, double finest_side) {
  const bool finest = finest_side <= std::ldexp(1.0, -o.max_level);
  return (finest ? o.sigma_cells : o.coarse_sigma_cells) * finest_side;
}

/// Grid and coefficients must outlive it; it does not move, as its parts refer to each other.
template <int Dim>
struct LevelEnergy {
  const Octree<Dim>& grid;
  double sigma;  ///< half width of the band
  Unknowns<Dim> unknowns;
  TargetField<Dim> target;
  ReferenceFields<Dim> reference;
  MatchingEnergy<Dim> energy;
  EnergyHessian<Dim> hessian;

  LevelEnergy(const Octree<Dim>& g, const CoefficientFields<Dim>& reference_fields,
              const CoefficientFields<Dim>& target_fields, const ExperimentOptions& options)
      : grid(g),
        sigma(band_half_width(options.cascade, g.finest_side())),
        unknowns(g, options.energy.boundary),
        target(g, target_fields.distance, target_fields.normal, target_fields.root),
        reference{reference_fields.distance, reference_fields.normal, reference_fields.root,
                  reads_shape_operators(options.energy) || !options.coefficients.invert_at_point},
        energy(unknowns, reference, target, options.energy, sigma, options.energy.quadrature_order),
        hessian(energy, unknowns, target, options.energy) {}
  LevelEnergy(const LevelEnergy&) = delete;
  LevelEnergy& operator=(const LevelEnergy&) = delete;
};

}  // namespace shellmatch
