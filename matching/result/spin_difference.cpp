#include "matching/result/spin_difference.h"

#include "alignment/spectrum/spin_images.h"
#include "base/parallel.h"
#include "geometry/surface/subdivision.h"
#include "matching/pairs/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shellmatch {

namespace {

// In roots of the area.
constexpr double image_radius = 0.2, smoothing_radius = 0.04, common_reach = 0.05;
constexpr std::size_t n_points = 4000, n_compared = 500, n_least_compared = 50;
constexpr std::size_t n_least_vertices = 100;
constexpr std::size_t n_dense = 500;  // with fewer vertices edges are cut, or an image has few points

using Samples = std::vector<SurfaceSample<3>>;

/// Points of a surface with smoothed normals, in a unit of length of its own.
struct PointCloud {
  PointCloud(Samples points, double unit) : samples(std::move(points)) {
    const auto n = static_cast<Eigen::Index>(samples.size());
    x.resize(n, 3);
    normals.resize(n, 3);
    areas.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const SurfaceSample<3>& s = samples[static_cast<std::size_t>(i)];
      x.row(i) = s.x / unit;
      areas[i] = s.area / (unit * unit);
    }
    parallel_for(samples.size(), [&](std::size_t i) {
      Vec<3> sum = Vec<3>::Zero();
      for (std::size_t j = 0; j < samples.size(); ++j)
        if ((samples[j].x - samples[i].x).squaredNorm() < smoothing_radius * smoothing_radius * unit * unit)
          sum += samples[j].area * samples[j].normal;
      normals.row(static_cast<Eigen::Index>(i)) = sum.squaredNorm() > 0 ? sum.normalized() : samples[i].normal;
    });
  }

  Samples samples;
  Rows3 x, normals;
  Eigen::VectorXd areas;
};

/// The sample that is nearest to y and faces the side of n; none where there is none.
std::optional<std::size_t> nearest_facing(const Samples& samples, const Vec<3>& y, const Vec<3>& n) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (const double d = (samples[i].x - y).squaredNorm(); d < least && samples[i].normal.dot(n) > 0) {
      least = d;
      best = i;
    }
  return best;
}

/// Leaves the samples that the other shape has, too: next to which, at most `reach` away and on the same side, one of
/// its samples lies that is known.
void keep_common(Samples& from, Samples& to, const Surface<3>& deformed, const std::vector<Vec<3>>& normals,
                 const ObservedPair<3>& observed, double reach) {
  std::erase_if(from, [&](const auto& s) { return !observed.reference.contains(s.x); });
  std::erase_if(to, [&](const auto& s) { return !observed.template_shape.contains(s.x); });
  std::vector<char> of_from(from.size(), 0), of_to(to.size(), 0);
  parallel_for(from.size(), [&](std::size_t i) {
    const Vec<3>& y = deformed.vertices[from[i].vertex];
    for (const auto& s : to)
      if ((s.x - y).squaredNorm() < reach * reach && s.normal.dot(normals[from[i].vertex]) > 0) of_from[i] = 1;
  });
  parallel_for(to.size(), [&](std::size_t j) {
    for (const auto& s : from)
      if ((to[j].x - deformed.vertices[s.vertex]).squaredNorm() < reach * reach &&
          to[j].normal.dot(normals[s.vertex]) > 0)
        of_to[j] = 1;
  });
  const auto keep = [](Samples& samples, const std::vector<char>& kept) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (kept[i]) samples[n++] = samples[i];
    samples.resize(n);
  };
  keep(from, of_from);
  keep(to, of_to);
}

}  // namespace

template <>
std::optional<double> spin_difference<2>(const Surface<2>&, const Surface<2>&, const Surface<2>&,
                                         const ObservedPair<2>&, bool) {
  return std::nullopt;
}

template <>
std::optional<double> spin_difference<3>(const Surface<3>& reference, const Surface<3>& deformed,
                                         const Surface<3>& template_surface, const ObservedPair<3>& observed,
                                         bool one_is_part) {
  if (std::min(reference.vertices.size(), template_surface.vertices.size()) < n_least_vertices) return std::nullopt;
  if (reference.vertices.size() < n_dense) {
    Surface<3> finer = reference, finer_deformed = deformed;
    if (!cut_long_edges(finer, 0) || !cut_long_edges(finer_deformed, 0)) return std::nullopt;
    if (finer.facets != finer_deformed.facets) return std::nullopt;  // some edges have collapsed
    return spin_difference<3>(finer, finer_deformed, template_surface, observed, one_is_part);
  }
  if (template_surface.vertices.size() < n_dense) {
    Surface<3> finer = template_surface;
    if (!cut_long_edges(finer, 0)) return std::nullopt;
    return spin_difference<3>(reference, deformed, finer, observed, one_is_part);
  }
  double unit[] = {std::sqrt(surface_measure(reference)), std::sqrt(surface_measure(template_surface))};
  if (one_is_part) unit[0] = unit[1] = std::max(unit[0], unit[1]);
  const std::vector<Vec<3>> normals = vertex_normals(deformed);
  const auto all = [](const Surface<3>& surface) {
    return sample_vertices<3>(surface, n_points, [](const Vec<3>&) { return true; });
  };
  Samples on_reference = all(reference), on_template = all(template_surface);
  // Surroundings that one shape lacks are left out of the other's, too. What lies inside other parts leaves no hole.
  if (one_is_part) keep_common(on_reference, on_template, deformed, normals, observed, common_reach * unit[0]);
  const PointCloud from(std::move(on_reference), unit[0]), to(std::move(on_template), unit[1]);
  const SpinImages images[] = {{from.x, from.normals, from.areas, image_radius},
                               {to.x, to.normals, to.areas, image_radius}};
  std::vector<double> squares(std::min(n_compared, from.samples.size()), -1);  // -1: is left out
  parallel_for(squares.size(), [&](std::size_t k) {
    const std::size_t i = k * from.samples.size() / squares.size();
    const SurfaceSample<3>& sample = from.samples[i];
    if (!observed.reference.contains(sample.x)) return;
    const auto j = nearest_facing(to.samples, deformed.vertices[sample.vertex], normals[sample.vertex]);
    if (!j || !observed.template_shape.contains(to.samples[*j].x)) return;
    Eigen::VectorXf image(SpinImages::n_entries), other(SpinImages::n_entries);
    images[0].compute(static_cast<Index>(i), image);
    images[1].compute(static_cast<Index>(*j), other);
    squares[k] = (image - other).squaredNorm();
  });
  double sum = 0;
  std::size_t n = 0;
  for (const double square : squares)
    if (square >= 0) {
      sum += square;
      ++n;
    }
  if (n < n_least_compared) return std::nullopt;
  return sum / static_cast<double>(n);
}

}  // namespace shellmatch
