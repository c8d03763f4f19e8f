#include "matching/result/spin_difference.h"

#include "alignment/spectrum/spin_images.h"
#include "base/parallel.h"
#include "matching/pairs/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shellmatch {

namespace {

// In roots of the area.
constexpr double image_radius = 0.2, smoothing_radius = 0.04;
constexpr std::size_t n_points = 4000, n_compared = 500, n_least_compared = 50;
constexpr std::size_t n_least_vertices = 500;

/// Points all over a surface with smoothed normals, in a unit of length of its own.
struct PointCloud {
  PointCloud(const Surface<3>& surface, double unit)
      : samples(sample_vertices<3>(surface, n_points, [](const Vec<3>&) { return true; })) {
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

  std::vector<SurfaceSample<3>> samples;
  Rows3 x, normals;
  Eigen::VectorXd areas;
};

bool is_known_around(const ObservedPart<3>& part, const Vec<3>& x, double radius) {
  return part.is_all() || part.margin(x) > std::max(radius, part.least_margin());
}

/// The sample of the template that is nearest to y and faces the side of n; none where there is none.
std::optional<std::size_t> nearest_facing(const PointCloud& cloud, const Vec<3>& y, const Vec<3>& n) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cloud.samples.size(); ++i)
    if (const double d = (cloud.samples[i].x - y).squaredNorm(); d < least && cloud.samples[i].normal.dot(n) > 0) {
      least = d;
      best = i;
    }
  return best;
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
  double unit[] = {std::sqrt(surface_measure(reference)), std::sqrt(surface_measure(template_surface))};
  if (one_is_part) unit[0] = unit[1] = std::max(unit[0], unit[1]);
  // What lies inside other parts leaves no hole in the surroundings.
  const double beside = one_is_part ? image_radius * unit[0] : 0;
  const PointCloud from(reference, unit[0]), to(template_surface, unit[1]);
  const std::vector<Vec<3>> normals = vertex_normals(deformed);
  const SpinImages images[] = {{from.x, from.normals, from.areas, image_radius},
                               {to.x, to.normals, to.areas, image_radius}};
  // Of a part, few points lie far from its borders.
  const std::size_t n_looked_at = one_is_part ? from.samples.size() : std::min(n_compared, from.samples.size());
  std::vector<double> squares(n_looked_at, -1);  // -1: is left out
  parallel_for(squares.size(), [&](std::size_t k) {
    const std::size_t i = k * from.samples.size() / squares.size();
    const SurfaceSample<3>& sample = from.samples[i];
    if (!is_known_around(observed.reference, sample.x, beside)) return;
    const auto j = nearest_facing(to, deformed.vertices[sample.vertex], normals[sample.vertex]);
    if (!j || !is_known_around(observed.template_shape, to.samples[*j].x, beside)) return;
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
