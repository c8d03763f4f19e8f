#pragma once
/// \file
/// The energy of a result with another quadrature than the one that was minimised: a solution overfits its
/// own Gauss points.

#include "energies/assembly/band_report.h"
#include "energies/assembly/matching_energy.h"

#include <span>

namespace shellmatch {

struct EnergyReport {
  TermValues values;  ///< weighted; zero where the energy cannot be evaluated
  BandReport band;
};

/// With Gauss points of `points_per_direction`, for some thousand elements at a time: the band of all of them
/// would take more memory than the rest of a run. sigma: half width of the band. phi: positions of all nodes.
template <int Dim>
EnergyReport report_energy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                           const EnergyOptions& options, double sigma, int points_per_direction,
                           std::span<const Vec<Dim>> phi, const TermValues& weights);

}  // namespace shellmatch
