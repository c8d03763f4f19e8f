#pragma once
/// \file
/// The energy of an experiment on one grid, together with all objects that it refers to.

#include "energies/hessian/energy_hessian.h"
#include "energies/assembly/matching_energy.h"
#include "energies/pairs/point_pairs.h"
#include "grid/fields/mass.h"
#include "matching/experiment/options.h"

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
  std::optional<Term> coverage;  ///< its pairs are remade as phi moves; present where the constructor was asked for it

  /// \param pairs terms of their own, on all levels
  /// \param with_coverage adds the term of coverage, without pairs until refresh() gives it some
  LevelEnergy(const Octree<Dim>& g, GeometryPair<Dim> shapes, const ExperimentOptions& options,
              const std::vector<PairSet<Dim>>& pairs = {}, bool with_coverage = false)
      : grid(g),
        sigma(band_half_width(options.cascade, g.finest_side())),
        unknowns(g, options.energy.boundary),
        geometry(std::move(shapes)),
        terms(std::make_shared<EnergyTerms<Dim>>(options.energy)),
        energy(unknowns, geometry, terms, sigma, options.energy.quadrature_order),
        hessian(energy, unknowns) {
    for (const PairSet<Dim>& set : pairs)
      terms->add(set.name, PairTerm<Dim>(g, set.pairs),
                 [weight = set.factor / options.cascade.nu](const TermScales&) { return weight; });
    if (with_coverage)
      coverage = terms->add(
          "coverage", PairTerm<Dim>(),
          [factor = is_covered(options) ? options.coverage.weight : 0](const TermScales& s) { return factor / s.nu; });
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

  /// Does coverage act on this level?
  bool is_covered(const ExperimentOptions& options) const { return covers(options, grid.finest_level()); }
};

}  // namespace shellmatch
