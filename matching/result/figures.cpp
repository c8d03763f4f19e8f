#include "matching/result/figures.h"

#include "geometry/distance/distortion.h"
#include "geometry/distance/measured_parts.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/surface/subdivision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

/// A deformation has no finer detail than its cells, over which distances from coarse meshes rise and fall: at half a
/// side the fish's mean is 10 % too large, at a quarter 1 %. A mean over 20000 points is within 6 % of that over ten
/// times as many (fish, hands, boxes).
template <int Dim>
double measured_spacing(const Surface<Dim>& template_surface, const Surface<Dim>& reference, double side) {
  constexpr double enough = 20000;
  // A reference that is much larger than the template has ten times as many points at most.
  const double area = std::max(surface_measure(template_surface), 0.1 * surface_measure(reference));
  return std::max(0.25 * side, std::pow(area / enough, 1.0 / (Dim - 1)));
}

}  // namespace

template <int Dim>
LocatedDistance<Dim> two_sided_distance(const Surface<Dim>& reference,
                                        const std::function<Surface<Dim>(const Surface<Dim>&)>& deform,
                                        const SignedDistance<Dim>& template_distance, const ObservedPair<Dim>& observed,
                                        double side, std::size_t most_points) {
  const double spacing = measured_spacing(template_distance.surface(), reference, side);
  const Surface<Dim> fine = subdivided(reference, spacing);
  const MeasuredParts<Dim> parts(observed.reference, fine, observed.template_shape);
  const MatchQuality<Dim> quality = match_quality(deform(fine), template_distance, parts, spacing, most_points);
  const auto one_sided = [](const DistanceStatistics& s) { return OneSidedDistance{s.mean, s.p95, s.max}; };
  return {{one_sided(quality.deformed_to_template), one_sided(quality.template_to_deformed), quality.uncovered},
          quality.farthest_of_deformed,
          quality.farthest_of_template};
}

LevelSummary level_summary(const LevelResult& r, const IterationRecord& last) {
  const auto named = [&](const TermValues& values) {
    NamedValues list;
    for (std::size_t t = 0; t < values.size(); ++t) list.emplace_back(r.term_names[t], values[t]);
    list.emplace_back("total", values.sum());
    return list;
  };
  LevelSummary s;
  s.level = r.start.level;
  s.sigma = r.start.sigma;
  s.nu = r.start.nu;
  s.volume_weight = r.start.volume_weight;
  s.n_substeps = r.start.n_substeps;
  s.n_nodes = r.start.n_nodes;
  s.n_free_nodes = r.start.n_free_nodes;
  s.n_cells = r.start.n_cells;
  s.n_band_cells = r.n_band_cells;
  s.energy_minimised = named(r.minimised);
  s.energy_reported = named(r.reported);
  s.iterations = r.iterations;
  s.value_evaluations = r.value_evaluations;
  s.gradient_evaluations = r.gradient_evaluations;
  s.linear_iterations = r.linear_iterations;
  s.regularised_systems = r.regularised_systems;
  s.gradient_norm = last.gradient_norm;
  s.l2_gradient_norm = last.l2_gradient_norm;
  s.solver = r.last.solver;
  s.fallbacks = r.fallbacks;
  if (!r.library_reports.empty()) s.library_reports = r.library_reports;
  s.stop_reason = enum_name(r.last.reason);
  s.stop_message = r.last.message;
  s.folds = r.folds;
  s.band = r.band;
  return s;
}

template <int Dim>
Surface<Dim> measured_facets(const Surface<Dim>& surface, const std::vector<char>& measured) {
  if (measured.empty()) return surface;
  Surface<Dim> some{surface.vertices, {}};
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (measured[f]) some.facets.push_back(surface.facets[f]);
  return some;
}

template <int Dim>
void add_distortion(MatchSummary& summary, const Surface<Dim>& reference, const Surface<Dim>& deformed,
                    const SignedDistance<Dim>& template_distance) {
  if (reference.facets.empty()) return;
  const auto weighted = [&](const std::vector<double>& values) {
    std::vector<std::pair<double, double>> shares;  // value and area
    double total = 0, sum = 0;
    for (std::size_t f = 0; f < values.size(); ++f) {
      if (!std::isfinite(values[f])) continue;
      shares.emplace_back(values[f], facet_measure(reference, static_cast<Index>(f)));
      total += shares.back().second;
      sum += shares.back().first * shares.back().second;
    }
    std::ranges::sort(shares);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto quantile_of = [&](double q) {
      double area = 0;
      for (const auto& [value, share] : shares)
        if ((area += share) >= q * total) return value;
      return shares.empty() ? nan : shares.back().first;
    };
    return DistortionSummary{sum / total, shares.empty() ? nan : shares.front().first,
                             shares.empty() ? nan : shares.back().first, quantile_of(0.05), quantile_of(0.95)};
  };
  summary.area_distortion = weighted(facet_measure_ratios(reference, deformed));
  if constexpr (Dim == 3) summary.angle_distortion = weighted(turned_directions(reference, deformed));
  const std::vector<char> flipped = facing_away(deformed, template_distance);
  double area = 0, flipped_area = 0;
  for (std::size_t f = 0; f < flipped.size(); ++f) {
    const double share = facet_measure(reference, static_cast<Index>(f));
    area += share;
    if (flipped[f]) flipped_area += share;
  }
  summary.n_flipped_facets = static_cast<std::size_t>(std::ranges::count(flipped, 1));
  summary.flipped_share = flipped_area / area;
}

template <int Dim>
Vec<Dim> most_distorted_place(const Surface<Dim>& reference, const Surface<Dim>& deformed) {
  const std::vector<double> ratios = facet_measure_ratios(reference, deformed),
                            angles = angle_distortions(reference, deformed);
  std::vector<double> sum(reference.vertices.size(), 0.0), area(reference.vertices.size(), 0.0);
  for (std::size_t f = 0; f < ratios.size(); ++f) {
    const double change = std::max(std::abs(std::log(ratios[f])), std::log(angles[f]));
    const double share = facet_measure(reference, static_cast<Index>(f));
    for (const Index v : reference.facets[f]) {
      // A facet that has collapsed counts as one that has shrunk to a millionth.
      sum[v] += share * (std::isfinite(change) ? std::min(change, 14.0) : 14.0);
      area[v] += share;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = area[v] > 0 ? sum[v] / area[v] : 0;
  return deformed.vertices[static_cast<std::size_t>(std::ranges::max_element(sum) - sum.begin())];
}

SHELLMATCH_2D_3D(two_sided_distance);
SHELLMATCH_2D_3D(measured_facets);
SHELLMATCH_2D_3D(most_distorted_place);
SHELLMATCH_2D_3D(add_distortion);

}  // namespace shellmatch
