#include "geometry/distance/surface_distance.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/subdivision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shellmatch {

namespace {

/// Points of a surface at which distances are measured.
template <int Dim>
struct MeasuredPoints {
  std::vector<Vec<Dim>> points;
  std::vector<double> areas;  ///< around each
};

/// Vertices that have facets. \param measured one entry for each vertex; empty for all \param most of many, every
/// second, third, ... is taken
template <int Dim>
MeasuredPoints<Dim> measured_points(const Surface<Dim>& surface, const std::vector<char>& measured, std::size_t most) {
  const std::vector<double> area = vertex_measures(surface);
  std::vector<bool> used(surface.vertices.size(), false);
  for (const auto& facet : surface.facets)
    for (const Index v : facet) used[v] = measured.empty() || measured[v] != 0;
  MeasuredPoints<Dim> found;
  const std::size_t step = 1 + (static_cast<std::size_t>(std::ranges::count(used, true)) - 1) / most;
  for (std::size_t v = 0, n = 0; v < used.size(); ++v) {
    if (!used[v] || n++ % step != 0) continue;
    found.points.push_back(surface.vertices[v]);
    found.areas.push_back(area[v]);
  }
  return found;
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
  std::vector<double> distances(points.size());
  parallel_chunks(points.size(), 256, [&](const Chunk& chunk) {
    const std::size_t n = chunk.end - chunk.begin;
    surface(std::span(points).subspan(chunk.begin, n), std::span(distances).subspan(chunk.begin, n));
  });
  for (double& distance : distances) distance = std::abs(distance);
  return distances;
}

template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const Surface<Dim>& surface) {
  SHELLMATCH_CHECK(!surface.facets.empty(), "the distance to a surface without facets is not defined");
  const FacetTree<Dim> tree(surface);
  std::vector<Index> facets(points.size());
  std::vector<double> distances(points.size());
  parallel_chunks(points.size(), 256, [&](const Chunk& chunk) {
    const std::size_t n = chunk.end - chunk.begin;
    tree.nearest(std::span(points).subspan(chunk.begin, n), std::span(facets).subspan(chunk.begin, n));
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      SHELLMATCH_CHECK(facets[i] != no_index, "a point whose distance is asked for is not finite");
      distances[i] = (points[i] - closest_point_on_facet(surface, facets[i], points[i]).point).norm();
    }
  });
  return distances;
}

template <int Dim>
MatchQuality<Dim> match_quality(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance,
                                const MeasuredParts<Dim>& parts, double spacing, std::size_t most_points) {
  const Surface<Dim> fine = subdivided(template_distance.surface(), spacing);
  const MeasuredPoints<Dim> of_deformed = measured_points(deformed, parts.of_deformed(deformed), most_points);
  const MeasuredPoints<Dim> of_template =
      measured_points(fine, parts.of_template(fine.vertices, deformed), most_points);
  // Of the whole template, whatever is measured.
  const double diagonal = bounding_box(measured_points(template_distance.surface(), {}, unlimited).points).diagonal();
  const auto summary = [&](const MeasuredPoints<Dim>& of, const std::vector<double>& distances) {
    const DistanceStatistics s = weighted_statistics(distances, of.areas);
    return DistanceStatistics{s.mean / diagonal, s.p95 / diagonal, s.max / diagonal};
  };
  const auto farthest = [](const std::vector<Vec<Dim>>& points, const std::vector<double>& distances) -> Vec<Dim> {
    if (points.empty()) return Vec<Dim>::Constant(std::numeric_limits<double>::quiet_NaN());
    return points[static_cast<std::size_t>(std::ranges::max_element(distances) - distances.begin())];
  };
  const std::vector<double> there = distances_to(of_deformed.points, template_distance);
  const std::vector<double> back = distances_to(of_template.points, deformed);
  return {summary(of_deformed, there), summary(of_template, back),
          share_beyond(of_template.areas, back, covered_within * diagonal), farthest(of_deformed.points, there),
          farthest(of_template.points, back)};
}

template std::vector<double> distances_to(const std::vector<Vec<2>>&, const SignedDistance<2>&);
template std::vector<double> distances_to(const std::vector<Vec<3>>&, const SignedDistance<3>&);
template std::vector<double> distances_to(const std::vector<Vec<2>>&, const Surface<2>&);
template std::vector<double> distances_to(const std::vector<Vec<3>>&, const Surface<3>&);
template MatchQuality<2> match_quality(const Surface<2>&, const SignedDistance<2>&, const MeasuredParts<2>&, double,
                                       std::size_t);
template MatchQuality<3> match_quality(const Surface<3>&, const SignedDistance<3>&, const MeasuredParts<3>&, double,
                                       std::size_t);

}  // namespace shellmatch
