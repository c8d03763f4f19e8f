#pragma once
/// \file
/// The energy of an experiment on one grid, together with all objects that it refers to.

#include <Eigen/SparseCore>

#include "energies/assembly/matching_energy.h"
#include "energies/hessian/energy_hessian.h"
#include "grid/fields/mass.h"
#include "matching/experiment/options.h"
#include "matching/level/observed_mask.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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
  std::shared_ptr<EnergyTerms<Dim>> terms;
  MatchingEnergy<Dim> energy;
  EnergyHessian<Dim> hessian;
  std::optional<ObservedMask<Dim>> mask;  ///< where a shape has gaps

  /// \param observed what the shapes have data of: the terms of the band are masked elsewhere
  LevelEnergy(const Octree<Dim>& g, GeometryPair<Dim> shapes, const ExperimentOptions& options,
              const ObservedPair<Dim>& observed = {})
      : grid(g),
        sigma(band_half_width(options.cascade, g.finest_side())),
        unknowns(g, options.energy.boundary),
        geometry(std::move(shapes)),
        terms(std::make_shared<EnergyTerms<Dim>>(options.energy)),
        energy(unknowns, geometry, terms, sigma, options.energy.quadrature_order),
        hessian(energy, unknowns) {
    if (!observed.is_all()) energy.set_mask(mask.emplace(observed, sigma));
  }
  LevelEnergy(const LevelEnergy&) = delete;
  LevelEnergy& operator=(const LevelEnergy&) = delete;

  /// Weights of all terms at one step of the schedule.
  TermValues weights(const ExperimentOptions& options, double nu, double volume_weight) const {
    return terms->weights({.nu = nu, .volume = volume_weight, .delta = options.energy.delta});
  }

  /// Lumped mass of each unknown node, in the order of unknowns.nodes().
  std::vector<double> unknown_mass() const {
    const std::vector<double> all = lumped_mass(grid);
    std::vector<double> mass;
    mass.reserve(unknowns.nodes().size());
    for (const Index node : unknowns.nodes()) mass.push_back(all[grid.free_index(node)]);
    return mass;
  }

  /// What is made anew as phi moves becomes that for this phi: the mask, and the points of terms that follow it.
  void refresh(const std::vector<Vec<Dim>>& phi) {
    energy.refresh_mask(phi);
    terms->refresh(phi);
  }
};

/// Matrix of the metric h1 or h1_band on the unknown nodes (energies/assembly/metric_matrix.h).
/// \param weights of the terms in the minimisation that uses the metric
template <int Dim>
Eigen::SparseMatrix<double> level_metric(const LevelEnergy<Dim>& level, const SolverOptions& solver,
                                         const TermValues& weights, Metric metric);

}  // namespace shellmatch
