#include "geometry/distance/observed_part.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

template <int Dim>
ObservedPart<Dim>::ObservedPart(const Evidence<Dim>& evidence) {
  if (evidence.is_complete()) return;
  Parts parts{Part(evidence.observed), Part(evidence.unobserved), {}, {}, 0, 0, {}, {}};
  scale_ = bounding_box(evidence.observed.vertices).diagonal();
  const Surface<Dim>& unobserved = parts.unobserved.surface;
  // Patches have their vertices on the edge of the gap: the centres of their facets are farther inside.
  std::vector<double> reach(unobserved.facets.size());
  parallel_for(
      reach.size(),
      [&](std::size_t f) {
        Vec<Dim> centre = Vec<Dim>::Zero();
        for (const Index v : unobserved.facets[f]) {
          centre += unobserved.vertices[v] / Dim;
          reach[f] = std::max(reach[f], parts.observed.nearest(unobserved.vertices[v]).distance);
        }
        reach[f] = std::max(reach[f], parts.observed.nearest(centre).distance);
      },
      64);
  DisjointSets sets(unobserved.vertices.size());
  for (const auto& facet : unobserved.facets)
    for (const Index v : facet) sets.join(v, facet[0]);
  std::vector<double> of_set(unobserved.vertices.size(), 0.0);
  for (std::size_t f = 0; f < reach.size(); ++f) {
    double& largest = of_set[sets.find(unobserved.facets[f][0])];
    largest = std::max(largest, reach[f]);
  }
  for (const auto& facet : unobserved.facets) parts.half_widths.push_back(of_set[sets.find(facet[0])]);
  parts.lay_lattice();
  parts_ = std::make_shared<const Parts>(std::move(parts));
}

template <int Dim>
auto ObservedPart<Dim>::Part::at(Index facet, const Vec<Dim>& x) const -> Nearest {
  if (facet == no_index) return {facet, std::numeric_limits<double>::infinity()};
  return {facet, (closest_point_on_facet(surface, facet, x).point - x).norm()};
}

template <int Dim>
auto ObservedPart<Dim>::nearest_gap(const Vec<Dim>& x) const -> Gap {
  if (is_all()) return {};
  const auto unobserved = parts_->unobserved.nearest(x);
  // So far away that nothing can be told.
  if (unobserved.facet == no_index) return {-std::numeric_limits<double>::infinity(), 0};
  return {unobserved.distance - parts_->observed.nearest(x).distance,
          parts_->half_widths[static_cast<std::size_t>(unobserved.facet)]};
}

template <int Dim>
void ObservedPart<Dim>::nearest_gaps(std::span<const Vec<Dim>> x, double most, std::span<Gap> gaps) const {
  std::ranges::fill(gaps, Gap());
  if (is_all()) return;
  std::vector<Index> facets(x.size());
  std::vector<double> distances, limits;
  parts_->observed.tree.nearest(x, facets);
  for (std::size_t i = 0; i < x.size(); ++i) {
    distances.push_back(parts_->observed.at(facets[i], x[i]).distance);
    limits.push_back(distances[i] + most);
  }
  parts_->unobserved.tree.nearest_within(x, limits, facets);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(distances[i])) gaps[i] = nearest_gap(x[i]);
    else if (facets[i] != no_index)
      gaps[i] = {parts_->unobserved.at(facets[i], x[i]).distance - distances[i],
                 parts_->half_widths[static_cast<std::size_t>(facets[i])]};
  }
}

// The margin changes at most by twice the distance.
template <int Dim>
void ObservedPart<Dim>::Parts::lay_lattice() {
  Box<Dim> box = bounding_box(observed.surface.vertices);
  for (const Vec<Dim>& x : unobserved.surface.vertices) box.add(x);
  side = (box.max - box.min).maxCoeff() / 50;
  reach = 1.001 * side * std::sqrt(Dim);
  corner = box.min.array() - side;
  std::size_t n = 1;
  for (int k = 0; k < Dim; ++k) {
    n_cells[k] = static_cast<int>((box.max[k] - box.min[k]) / side) + 3;
    n *= static_cast<std::size_t>(n_cells[k]);
  }
  margins = std::vector<std::atomic<float>>(n);
  for (std::atomic<float>& margin : margins) margin = std::numeric_limits<float>::quiet_NaN();
}

/// At the centre of the cube that has x, or the most that is asked for; NaN outside.
template <int Dim>
float ObservedPart<Dim>::Parts::margin_near(const Vec<Dim>& x) const {
  std::size_t i = 0;
  Vec<Dim> centre;
  for (int k = Dim - 1; k >= 0; --k) {
    const double t = std::floor((x[k] - corner[k]) / side);
    if (!(t >= 0 && t < n_cells[k])) return std::numeric_limits<float>::quiet_NaN();
    i = i * n_cells[k] + static_cast<std::size_t>(t);
    centre[k] = corner[k] + side * (t + 0.5);
  }
  float margin = margins[i].load(std::memory_order_relaxed);
  if (!std::isnan(margin)) return margin;
  const double distance = observed.nearest(centre).distance, limit = distance + most_margin * side;
  Index facet;
  unobserved.tree.nearest_within(std::span(&centre, 1), std::span(&limit, 1), std::span(&facet, 1));
  margin =
      static_cast<float>(facet == no_index ? most_margin * side : unobserved.at(facet, centre).distance - distance);
  margins[i].store(margin, std::memory_order_relaxed);  // whoever else computes it has the same bits
  return margin;
}

// Any observed facet bounds the distance of the nearest from above; where no gap begins nearer than the margin beyond
// that bound, neither distance has to be known.
template <int Dim>
bool ObservedPart<Dim>::is_beyond(const Vec<Dim>& x, double least) const {
  if (is_surely_beyond(x, least)) return true;
  const Index some = parts_->observed.tree.some_near(x);
  if (some == no_index) return false;
  const double distance = (closest_point_on_facet(parts_->observed.surface, some, x).point - x).norm();
  return std::isfinite(distance) && !parts_->unobserved.tree.reaches(x, distance + least);
}

template class ObservedPart<2>;
template class ObservedPart<3>;

}  // namespace shellmatch
