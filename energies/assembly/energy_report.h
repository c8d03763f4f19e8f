#pragma once
/// \file
/// The energy of a result by a finer quadrature than the one it was minimised with: a minimiser may overfit its
/// quadrature points.

#include "energies/assembly/band_report.h"
#include "energies/assembly/matching_energy.h"

#include <span>

namespace shellmatch {

struct EnergyReport {
  TermValues values;  ///< weighted values of the terms; NaN where the energy cannot be evaluated
  BandReport band;
};

/// Evaluates with `points_per_direction` Gauss points, some thousand elements at a time, because the finer band of all
/// elements would need more memory than the rest of a run.
/// \param sigma half width of the band
/// \param phi positions of all nodes
/// \param mask null for none
template <int Dim>
EnergyReport report_energy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                           const EnergyOptions& options, double sigma, int points_per_direction,
                           std::span<const Vec<Dim>> phi, const TermValues& weights,
                           const BandMask<Dim>* mask = nullptr);

}  // namespace shellmatch
