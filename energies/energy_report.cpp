#include "energies/energy_report.h"

#include <algorithm>

namespace shellmatch {

namespace {

constexpr std::size_t elements_at_a_time = 16384;

}  // namespace

template <int Dim>
EnergyReport report_energy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                           const EnergyOptions& options, double sigma, int points_per_direction,
                           std::span<const Vec<Dim>> phi, const TermValues& weights) {
  EnergyReport report;
  BandSums sums;
  const auto elements = unknowns.elements();
  bool evaluable = true;
  for (std::size_t begin = 0; begin < elements.size(); begin += elements_at_a_time) {
    const auto some = elements.subspan(begin, std::min(elements_at_a_time, elements.size() - begin));
    const MatchingEnergy<Dim> energy(some, geometry, options, sigma, points_per_direction);
    TermValues values;
    evaluable = evaluable && energy.evaluate(phi, weights, values, {});
    if (evaluable) report.values += values;
    sums += sum_band<Dim>(some, energy.band(), energy.shape(), geometry.target, phi);
  }
  if (!evaluable) report.values = {};
  report.band = sums.means();
  return report;
}

template EnergyReport report_energy<2>(const Unknowns<2>&, const GeometryPair<2>&, const EnergyOptions&, double, int,
                                       std::span<const Vec<2>>, const TermValues&);
template EnergyReport report_energy<3>(const Unknowns<3>&, const GeometryPair<3>&, const EnergyOptions&, double, int,
                                       std::span<const Vec<3>>, const TermValues&);

}  // namespace shellmatch
