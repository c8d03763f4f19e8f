#include "geometry/distance/distortion.h"

#include "base/error.h"
#include "base/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double ratio_or_nan(double deformed, double reference) { return reference > 0 ? deformed / reference : nan; }

template <int Dim>
void require_same_facets(const Surface<Dim>& reference, const Surface<Dim>& deformed) {
  SHELLMATCH_CHECK(reference.facets == deformed.facets && reference.vertices.size() == deformed.vertices.size(),
                   "distortion compares a surface with the same surface deformed");
}

}  // namespace

template <int Dim>
std::vector<double> facet_measure_ratios(const Surface<Dim>& reference, const Surface<Dim>& deformed) {
  require_same_facets(reference, deformed);
  std::vector<double> ratios(reference.facets.size());
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const auto f = static_cast<Index>(i);
    ratios[i] = ratio_or_nan(facet_measure(deformed, f), facet_measure(reference, f));
  }
  return ratios;
}

template <int Dim>
std::vector<double> vertex_measure_ratios(const Surface<Dim>& reference, const Surface<Dim>& deformed) {
  require_same_facets(reference, deformed);
  std::vector<double> before(reference.vertices.size(), 0.0), after = before;
  for (std::size_t i = 0; i < reference.facets.size(); ++i) {
    const auto f = static_cast<Index>(i);
    for (const Index v : reference.facets[i]) {
      before[v] += facet_measure(reference, f);
      after[v] += facet_measure(deformed, f);
    }
  }
  for (std::size_t v = 0; v < before.size(); ++v) after[v] = ratio_or_nan(after[v], before[v]);
  return after;
}

// In an orthonormal frame of the reference triangle, its edges are (l, 0) and (x, y). With the deformed edges
// g1 and g2, the columns of the map are g1 / l and (g2 - x g1 / l) / y. s1^2 + s2^2 is its squared norm and
// s1 s2 the ratio of areas; s1 -+ s2 follow from these without cancellation in s2.
std::vector<Stretch> principal_stretches(const Surface<3>& reference, const Surface<3>& deformed) {
  require_same_facets(reference, deformed);
  std::vector<Stretch> stretches;
  stretches.reserve(reference.facets.size());
  for (std::size_t i = 0; i < reference.facets.size(); ++i) {
    const auto f = static_cast<Index>(i);
    const auto& [a, b, c] = reference.facets[i];
    const Vec<3> e1 = reference.vertices[b] - reference.vertices[a];
    const Vec<3> e2 = reference.vertices[c] - reference.vertices[a];
    const double l = e1.norm(), area = facet_normal(reference, f).norm();
    if (!(area > 0)) {
      stretches.push_back({nan, nan});
      continue;
    }
    const double x = e1.dot(e2) / l, y = area / l;
    const Vec<3> column_1 = (deformed.vertices[b] - deformed.vertices[a]) / l;
    const Vec<3> column_2 = (deformed.vertices[c] - deformed.vertices[a] - x * column_1) / y;
    const double sum_of_squares = column_1.squaredNorm() + column_2.squaredNorm();
    const double product = column_1.cross(column_2).norm();
    const double sum = std::sqrt(sum_of_squares + 2 * product);
    const double difference = std::sqrt(std::max(sum_of_squares - 2 * product, 0.0));
    const double s1 = (sum + difference) / 2;
    stretches.push_back({s1, s1 > 0 ? product / s1 : 0});
  }
  return stretches;
}

template <int Dim>
std::vector<double> angle_distortions(const Surface<Dim>& reference, const Surface<Dim>& deformed) {
  if constexpr (Dim == 2) {
    require_same_facets(reference, deformed);
    return std::vector<double>(reference.facets.size(), 1.0);
  } else {
    std::vector<double> result;
    for (const auto& [s1, s2] : principal_stretches(reference, deformed))
      result.push_back(std::isnan(s1) ? nan : s2 > 0 ? s1 / s2 : std::numeric_limits<double>::infinity());
    return result;
  }
}

template <int Dim>
std::vector<double> turned_directions(const Surface<Dim>& reference, const Surface<Dim>& deformed) {
  std::vector<double> degrees = angle_distortions(reference, deformed);
  for (double& a : degrees) a = (2 * std::atan(std::sqrt(a)) - std::acos(0.0)) * 90 / std::acos(0.0);
  return degrees;
}

template <int Dim>
std::vector<char> facing_away(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance) {
  std::vector<char> away(deformed.facets.size());
  parallel_chunks(deformed.facets.size(), 256, [&](const Chunk& chunk) {
    std::vector<Vec<Dim>> centres(chunk.end - chunk.begin, Vec<Dim>::Zero());
    for (std::size_t i = 0; i < centres.size(); ++i)
      for (const Index v : deformed.facets[chunk.begin + i]) centres[i] += deformed.vertices[v] / Dim;
    std::vector<ClosestPoint<Dim>> closest(centres.size());
    template_distance.closest(centres, closest);
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const std::size_t f = chunk.begin + i;
      away[f] = facet_normal(deformed, static_cast<Index>(f))
                    .dot(facet_normal(template_distance.surface(), closest[i].facet)) < 0;
    }
  });
  return away;
}

SHELLMATCH_2D_3D(facet_measure_ratios);
SHELLMATCH_2D_3D(vertex_measure_ratios);
SHELLMATCH_2D_3D(angle_distortions);
SHELLMATCH_2D_3D(turned_directions);
SHELLMATCH_2D_3D(facing_away);

}  // namespace shellmatch
