#include "energies/assembly/energy_report.h"

#include "base/parallel.h"

#include <limits>

namespace shellmatch {

namespace {

struct ChunkReport {
  TermValues values;
  BandSums band;
  bool is_evaluable = true;
  ChunkReport& operator+=(const ChunkReport& o) {
    values += o.values;
    band += o.band;
    is_evaluable = is_evaluable && o.is_evaluable;
    return *this;
  }
};

}  // namespace

template <int Dim>
EnergyReport report_energy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                           const EnergyOptions& options, double sigma, int points_per_direction,
                           std::span<const Vec<Dim>> phi, const TermValues& weights, const BandMask<Dim>* mask) {
  constexpr std::size_t elements_at_a_time = 1024;  // the band of so many elements fits the second-level cache
  const auto elements = unknowns.elements();
  const auto terms = std::make_shared<const EnergyTerms<Dim>>(options);
  const ChunkReport all = parallel_sum(elements.size(), elements_at_a_time, ChunkReport{}, [&](const Chunk& chunk) {
    const auto some = elements.subspan(chunk.begin, chunk.end - chunk.begin);
    MatchingEnergy<Dim> energy(some, geometry, terms, sigma, points_per_direction);
    if (mask) energy.set_mask(*mask);
    energy.refresh_mask(phi);
    ChunkReport report;
    report.is_evaluable = energy.report(phi, weights, report.values, report.band);
    return report;
  });
  EnergyReport result{all.values, all.band.means()};
  if (!all.is_evaluable)
    for (std::size_t t = 0; t < result.values.size(); ++t) result.values[t] = std::numeric_limits<double>::quiet_NaN();
  return result;
}

SHELLMATCH_2D_3D(report_energy);

}  // namespace shellmatch
