#include "matching/report/surface_figures.h"

#include "base/parallel.h"
#include "geometry/curvature/curvature.h"
#include "geometry/distance/distortion.h"
#include "geometry/distance/surface_distance.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace shellmatch {

namespace {

// Values for vertices that have none, from others of their facets, where these have some by then; again and again, as
// long as that finds any.
void spread(const Surface<3>& surface, std::vector<double>& values) {
  for (bool is_found = true; std::exchange(is_found, false);) {
    const std::vector<double> before = values;  // a value moves by a facet at a time
    for (const std::array<Index, 3>& facet : surface.facets)
      for (const Index given : facet) {
        if (std::isnan(before[given])) continue;
        for (const Index v : facet)
          if (std::isnan(values[v])) {
            values[v] = before[given];
            is_found = true;
          }
      }
  }
}

// Mean curvature at the vertices: 1/R on a sphere or circle of radius R.
std::vector<double> mean_curvatures(const Surface<3>& surface, std::size_t enough_fits) {
  const std::size_t every = 1 + surface.vertices.size() / enough_fits;
  std::vector<double> mean;
  for (const VertexCurvature& c : vertex_curvatures(surface, {.every = every})) mean.push_back((c.k1 + c.k2) / 2);
  if (every > 1) spread(surface, mean);
  return mean;
}
std::vector<double> mean_curvatures(const Surface<2>& curve, std::size_t) { return curve_curvatures(curve); }

// The nearest corner is near enough for a colour.
template <int Dim>
Index nearest_corner(const Surface<Dim>& surface, const ClosestPoint<Dim>& closest) {
  Index best = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (const Index v : surface.facets[closest.facet])
    if (const double d = (surface.vertices[v] - closest.point).squaredNorm(); d < least) {
      best = v;
      least = d;
    }
  return best;
}

// Means over the facets around each vertex, weighted by their measure.
template <int Dim>
std::vector<double> at_vertices(const Surface<Dim>& surface, const std::vector<double>& of_facets) {
  std::vector<double> sum(surface.vertices.size(), 0.0), weight(surface.vertices.size(), 0.0);
  for (std::size_t f = 0; f < of_facets.size(); ++f) {
    if (!std::isfinite(of_facets[f])) continue;
    const double measure = facet_measure(surface, static_cast<Index>(f));
    for (const Index v : surface.facets[f]) {
      sum[v] += measure * of_facets[f];
      weight[v] += measure;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] = weight[v] > 0 ? sum[v] / weight[v] : std::numeric_limits<double>::quiet_NaN();
  return sum;
}

}  // namespace

template <int Dim>
SurfaceFigures surface_figures(const MatchResult<Dim>& result, std::size_t enough_fits) {
  const auto& [reference, template_shape, deformed, distance, template_deviation] = result.surfaces;
  const double unit = unit_of_template<Dim>(result.map);
  SurfaceFigures figures;
  figures.distance_to_template = distance;
  figures.distance_to_deformed = template_deviation;
  for (std::vector<double>* lengths : {&figures.distance_to_template, &figures.distance_to_deformed})
    for (double& d : *lengths) d *= unit;
  figures.measure_ratio = vertex_measure_ratios(reference, deformed);
  if constexpr (Dim == 3) figures.angle_change = at_vertices(reference, turned_directions(reference, deformed));
  // Nothing holds the map where a shape has no data.
  for (std::vector<double>* values : {&figures.measure_ratio, &figures.angle_change})
    for (std::size_t v = 0; v < values->size(); ++v)
      if (std::isnan(distance[v])) (*values)[v] = distance[v];
  std::array<std::vector<double>, 2> curvatures;
  for_both([&](int i) {
    curvatures[static_cast<std::size_t>(i)] = mean_curvatures(i == 0 ? reference : template_shape, enough_fits);
  });
  const SignedDistance<Dim> template_distance(template_shape);
  figures.curvature_change.resize(deformed.vertices.size());
  parallel_chunks(deformed.vertices.size(), 256, [&](const Chunk& chunk) {
    std::vector<ClosestPoint<Dim>> closest(chunk.end - chunk.begin);
    template_distance.closest(std::span(deformed.vertices).subspan(chunk.begin, closest.size()), closest);
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      const Index there = nearest_corner(template_shape, closest[v - chunk.begin]);
      figures.curvature_change[v] = std::isnan(distance[v])
                                        ? distance[v]
                                        : (curvatures[1][static_cast<std::size_t>(there)] - curvatures[0][v]) / unit;
    }
  });
  return figures;
}

SHELLMATCH_2D_3D(surface_figures);

}  // namespace shellmatch
