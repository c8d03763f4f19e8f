#include "geometry/distance/surface_distance.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

/// Share of the surface's area around vertices that are farther away than `most`. \param distances of used_vertices()
template <int Dim>
double share_beyond(const Surface<Dim>& surface, const std::vector<double>& distances, double most) {
  std::vector<double> area(surface.vertices.size(), 0.0);
  std::vector<bool> used(surface.vertices.size(), false);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (const Index v : surface.facets[f]) {
      area[v] += facet_measure(surface, static_cast<Index>(f));
      used[v] = true;
    }
  double beyond = 0, all = 0;
  for (std::size_t v = 0, i = 0; v < area.size(); ++v) {
    if (!used[v]) continue;
    all += area[v];
    if (distances[i++] > most) beyond += area[v];
  }
  return all > 0 ? beyond / all : 0;
}

template <int Dim>
std::vector<Vec<Dim>> used_vertices(const Surface<Dim>& surface) {
  std::vector<bool> used(surface.vertices.size(), false);
  for (const auto& facet : surface.facets)
    for (const Index v : facet) used[v] = true;
  std::vector<Vec<Dim>> points;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) points.push_back(surface.vertices[v]);
  return points;
}

}  // namespace

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto place = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

DistanceStatistics statistics(std::vector<double> values) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {nan, nan, nan};
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  const double max = *std::max_element(values.begin(), values.end());
  return {mean, quantile(std::move(values), 0.95), max};
}

template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const SignedDistance<Dim>& surface) {
  std::vector<double> distances(points.size());
  parallel_for(
      points.size(), [&](std::size_t i) { distances[i] = std::abs(surface(points[i])); }, 256);
  return distances;
}

template <int Dim>
MatchQuality<Dim> match_quality(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance) {
  const std::vector<Vec<Dim>> template_points = used_vertices(template_distance.surface());
  const double diagonal = bounding_box(template_points).diagonal();
  const auto summary = [&](std::vector<double> distances) {
    const DistanceStatistics s = statistics(std::move(distances));
    return DistanceStatistics{s.mean / diagonal, s.p95 / diagonal, s.max / diagonal};
  };
  const auto farthest = [](const std::vector<Vec<Dim>>& points, const std::vector<double>& distances) {
    return points[static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin())];
  };
  const std::vector<Vec<Dim>> deformed_points = used_vertices(deformed);
  const std::vector<double> there = distances_to(deformed_points, template_distance);
  const std::vector<double> back = distances_to(template_points, SignedDistance<Dim>(deformed));
  return {summary(there), summary(back), share_beyond(template_distance.surface(), back, covered_within * diagonal),
          farthest(deformed_points, there), farthest(template_points, back)};
}

template std::vector<double> distances_to(const std::vector<Vec<2>>&, const SignedDistance<2>&);
template std::vector<double> distances_to(const std::vector<Vec<3>>&, const SignedDistance<3>&);
template MatchQuality<2> match_quality(const Surface<2>&, const SignedDistance<2>&);
template MatchQuality<3> match_quality(const Surface<3>&, const SignedDistance<3>&);

}  // namespace shellmatch
