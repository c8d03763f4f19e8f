#include "geometry/distance/measured_parts.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/nearest_facets.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

template <int Dim>
double longest_edge(const Surface<Dim>& surface) {
  double longest = 0;
  for (const auto& facet : surface.facets)
    for (std::size_t k = 0; k < Dim; ++k)
      longest = std::max(longest, (surface.vertices[facet[k]] - surface.vertices[facet[(k + 1) % Dim]]).norm());
  return longest;
}

}  // namespace

// Only the sign of a margin matters, and of a mean over the corners of a facet. Where a margin is larger than twice the
// longest edge, no corner of its facets has a negative one, as the margin's Lipschitz constant is 2.
template <int Dim>
MeasuredParts<Dim>::MeasuredParts(ObservedPart<Dim> reference, const Surface<Dim>& its_surface,
                                  ObservedPart<Dim> template_part)
    : reference_part_(std::move(reference)), template_part_(std::move(template_part)) {
  if (reference_part_.is_all()) return;
  const std::vector<Vec<Dim>>& vertices = its_surface.vertices;
  const double most = 2.01 * longest_edge(its_surface) + 2 * reference_part_.least_margin();
  margins_.resize(vertices.size());
  parallel_for(
      vertices.size(), [&](std::size_t v) { margins_[v] = reference_part_.margin_up_to(vertices[v], most); }, 256);
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::of_facets(const Surface<Dim>& reference, const Surface<Dim>& deformed) const {
  if (is_all()) return {};
  std::vector<char> measured(reference.facets.size());
  const auto centre = [](const Surface<Dim>& surface, std::size_t f) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const Index v : surface.facets[f]) sum += surface.vertices[static_cast<std::size_t>(v)] / Dim;
    return sum;
  };
  parallel_for(
      measured.size(),
      [&](std::size_t f) {
        measured[f] = reference_part_.contains(centre(reference, f)) && template_part_.contains(centre(deformed, f));
      },
      256);
  return measured;
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::of_deformed(const Surface<Dim>& deformed) const {
  if (is_all()) return {};
  std::vector<Index> all(deformed.vertices.size());
  std::iota(all.begin(), all.end(), 0);
  return of_deformed(deformed, all);
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::of_deformed(const Surface<Dim>& deformed,
                                                  const std::vector<Index>& vertices) const {
  SHELLMATCH_CHECK(margins_.empty() || margins_.size() == deformed.vertices.size(),
                   "margins are those of other vertices");
  std::vector<char> measured(vertices.size());
  parallel_for(
      measured.size(),
      [&](std::size_t i) {
        const Index v = vertices[i];
        measured[i] = (margins_.empty() || margins_[v] > reference_part_.least_margin()) &&
                      template_part_.contains(deformed.vertices[v]);
      },
      256);
  return measured;
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::near_observed(const std::vector<Vec<Dim>>& points,
                                                    const Surface<Dim>& deformed) const {
  if (margins_.empty()) return std::vector<char>(points.size(), 1);
  return near_observed(points, deformed, nearest_facets(FacetTree<Dim>(deformed), points));
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::near_observed(const std::vector<Vec<Dim>>& points, const Surface<Dim>& deformed,
                                                    const std::vector<Index>& facets) const {
  std::vector<char> observed(points.size(), 1);
  if (margins_.empty()) return observed;
  parallel_for(
      points.size(),
      [&](std::size_t i) {
        const Index f = facets[i];
        double margin = 0;  // interpolated, as it is 0 along the edge of a gap
        if (f != no_index) {
          const auto weights = barycentric_coordinates(deformed, f, closest_point_on_facet(deformed, f, points[i]));
          const auto& facet = deformed.facets[static_cast<std::size_t>(f)];
          for (std::size_t k = 0; k < Dim; ++k) margin += weights[k] * margins_[static_cast<std::size_t>(facet[k])];
        }
        observed[i] = margin > reference_part_.least_margin();
      },
      256);
  return observed;
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::of_template(const std::vector<Vec<Dim>>& points,
                                                  const Surface<Dim>& deformed) const {
  if (is_all()) return {};
  return of_template(points, deformed,
                     margins_.empty() ? std::vector<Index>{} : nearest_facets(FacetTree<Dim>(deformed), points));
}

template <int Dim>
std::vector<char> MeasuredParts<Dim>::of_template(const std::vector<Vec<Dim>>& points, const Surface<Dim>& deformed,
                                                  const std::vector<Index>& facets) const {
  if (is_all()) return {};
  std::vector<char> measured = near_observed(points, deformed, facets);
  parallel_for(
      points.size(), [&](std::size_t i) { measured[i] = measured[i] && template_part_.contains(points[i]); }, 256);
  return measured;
}

template class MeasuredParts<2>;
template class MeasuredParts<3>;

}  // namespace shellmatch
