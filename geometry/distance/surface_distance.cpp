#include "geometry/distance/surface_distance.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/nearest_facets.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/morton_curve.h"
#include "geometry/surface/subdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace shellmatch {

namespace {

/// Points of a surface at which distances are measured.
template <int Dim>
struct MeasuredPoints {
  std::vector<Index> vertices;
  std::vector<Vec<Dim>> points = {};
  std::vector<double> areas = {};  ///< around each
  std::vector<Index> facets = {};  ///< of the other surface, nearest to each, or none
};

/// Vertices that have facets. \param most of many, every second, third, ... is taken
template <int Dim>
MeasuredPoints<Dim> used_vertices(const Surface<Dim>& surface, std::size_t most) {
  const std::vector<double> area = vertex_measures(surface);
  std::vector<bool> used(surface.vertices.size(), false);
  for (const auto& facet : surface.facets)
    for (const Index v : facet) used[v] = true;
  MeasuredPoints<Dim> found;
  const std::size_t step = 1 + (static_cast<std::size_t>(std::ranges::count(used, true)) - 1) / most;
  for (std::size_t v = 0, n = 0; v < used.size(); ++v) {
    if (!used[v] || n++ % step != 0) continue;
    found.vertices.push_back(static_cast<Index>(v));
    found.points.push_back(surface.vertices[v]);
    found.areas.push_back(area[v]);
  }
  return found;
}

/// \param measured one entry for each; empty for all
template <int Dim>
MeasuredPoints<Dim> measured_ones(const MeasuredPoints<Dim>& all, const std::vector<char>& measured) {
  if (measured.empty()) return all;
  MeasuredPoints<Dim> some;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!measured[i]) continue;
    some.vertices.push_back(all.vertices[i]);
    some.points.push_back(all.points[i]);
    some.areas.push_back(all.areas[i]);
    if (!all.facets.empty()) some.facets.push_back(all.facets[i]);
  }
  return some;
}

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

/// Share of the area around vertices that are farther away than `most`.
double share_beyond(const std::vector<double>& areas, const std::vector<double>& distances, double most) {
  double beyond = 0, all = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    all += areas[i];
    if (distances[i] > most) beyond += areas[i];
  }
  return all > 0 ? beyond / all : areas.empty() ? std::numeric_limits<double>::quiet_NaN() : 0;
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

DistanceStatistics weighted_statistics(const std::vector<double>& values, const std::vector<double>& weights) {
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += weights[i] * values[i];
    total += weights[i];
  }
  if (!(total > 0)) return statistics(values);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(values[i], i); });
  double passed = 0;
  const auto at = std::ranges::find_if(order, [&](std::size_t i) { return (passed += weights[i]) >= 0.95 * total; });
  return {sum / total, values[at == order.end() ? order.back() : *at], values[order.back()]};
}

template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const SignedDistance<Dim>& surface) {
  constexpr std::size_t chunk_size = 256;
  const std::vector<Index> order = along_morton_curve<Dim>(points);
  std::vector<double> distances(points.size());
  parallel_chunks(points.size(), chunk_size, [&](const Chunk& chunk) {
    std::array<Vec<Dim>, chunk_size> some;
    std::array<double, chunk_size> signed_distances;
    const std::size_t n = chunk.end - chunk.begin;
    for (std::size_t i = 0; i < n; ++i) some[i] = points[order[chunk.begin + i]];
    surface(std::span(some).first(n), std::span(signed_distances).first(n));
    for (std::size_t i = 0; i < n; ++i) distances[order[chunk.begin + i]] = std::abs(signed_distances[i]);
  });
  return distances;
}

namespace {

template <int Dim>
std::vector<double> distances_from_facets(const std::vector<Vec<Dim>>& points, const Surface<Dim>& surface,
                                          const std::vector<Index>& facets) {
  std::vector<double> distances(points.size());
  parallel_for(
      points.size(),
      [&](std::size_t i) {
        SHELLMATCH_CHECK(facets[i] != no_index, "a point whose distance is asked for is not finite");
        distances[i] = (points[i] - closest_point_on_facet(surface, facets[i], points[i]).point).norm();
      },
      256);
  return distances;
}

}  // namespace

template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const Surface<Dim>& surface) {
  SHELLMATCH_CHECK(!surface.facets.empty(), "the distance to a surface without facets is not defined");
  return distances_from_facets(points, surface, nearest_facets(FacetTree<Dim>(surface), points));
}

template <int Dim>
MatchQuality<Dim> match_quality(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance,
                                const MeasuredParts<Dim>& parts, double spacing, std::size_t most_points) {
  const Surface<Dim> fine = subdivided(template_distance.surface(), spacing);
  MeasuredPoints<Dim> of_deformed = used_vertices(deformed, most_points),
                      of_template = used_vertices(fine, most_points);
  of_template.facets = nearest_facets(FacetTree<Dim>(deformed), of_template.points);
  if (!parts.is_all()) {
    of_deformed = measured_ones(of_deformed, parts.of_deformed(deformed, of_deformed.vertices));
    of_template = measured_ones(of_template, parts.of_template(of_template.points, deformed, of_template.facets));
  }
  // Of the whole template, whatever is measured.
  const double diagonal = bounding_box(used_vertices(template_distance.surface(), unlimited).points).diagonal();
  const auto summary = [&](const MeasuredPoints<Dim>& of, const std::vector<double>& distances) {
    const DistanceStatistics s = weighted_statistics(distances, of.areas);
    return DistanceStatistics{s.mean / diagonal, s.p95 / diagonal, s.max / diagonal};
  };
  const auto farthest = [](const std::vector<Vec<Dim>>& points, const std::vector<double>& distances) -> Vec<Dim> {
    if (points.empty()) return Vec<Dim>::Constant(std::numeric_limits<double>::quiet_NaN());
    return points[static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin())];
  };
  const std::vector<double> there = distances_to(of_deformed.points, template_distance);
  const std::vector<double> back = distances_from_facets(of_template.points, deformed, of_template.facets);
  return {summary(of_deformed, there), summary(of_template, back),
          share_beyond(of_template.areas, back, covered_within * diagonal), farthest(of_deformed.points, there),
          farthest(of_template.points, back)};
}

template std::vector<double> distances_to(const std::vector<Vec<2>>&, const SignedDistance<2>&);
template std::vector<double> distances_to(const std::vector<Vec<3>>&, const SignedDistance<3>&);
template std::vector<double> distances_to(const std::vector<Vec<2>>&, const Surface<2>&);
template std::vector<double> distances_to(const std::vector<Vec<3>>&, const Surface<3>&);
SHELLMATCH_2D_3D(match_quality);

}  // namespace shellmatch
