#pragma once
/// \file
/// The energy of an experiment on one grid, together with all objects that it refers to.

#include "energies/hessian/energy_hessian.h"
#include "energies/assembly/matching_energy.h"
#include "matching/experiment/options.h"

#include <cmath>
#include <utility>

namespace shellmatch {

/// The half width sigma of the band on a grid whose finest cells have this side.
inline double band_half_width(const CascadeOptions& o, double finest_side) {
  const bool finest = finest_side <= std::ldexp(1.0, -o.max_level);
  return (finest ? o.sigma_cells : o.coarse_sigma_cells) * finest_side;
}

/// `grid`, and a grid to which the geometry refers, must outlive this object. It cannot be moved, because its members
/// refer to each other.
template <int Dim>
struct LevelEnergy {
  const Octree<Dim>& grid;
  double sigma;  ///< half width of the band
  Unknowns<Dim> unknowns;
  GeometryPair<Dim> geometry;
  MatchingEnergy<Dim> energy;
  EnergyHessian<Dim> hessian;

  LevelEnergy(const Octree<Dim>& g, GeometryPair<Dim> shapes, const ExperimentOptions& options)
      : grid(g),
        sigma(band_half_width(options.cascade, g.finest_side())),
        unknowns(g, options.energy.boundary),
        geometry(std::move(shapes)),
        energy(unknowns, geometry, options.energy, sigma, options.energy.quadrature_order),
        hessian(energy, unknowns) {}
  LevelEnergy(const LevelEnergy&) = delete;
  LevelEnergy& operator=(const LevelEnergy&) = delete;
};

}  // namespace shellmatch
