#include "geometry/label/surface_parts.h"

#include "base/disjoint_sets.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

namespace shellmatch {

std::size_t drop_small_parts(Surface<3>& surface, double least) {
  DisjointSets sets(surface.vertices.size());
  for (const auto& [a, b, c] : surface.facets) {
    sets.join(b, a);
    sets.join(c, a);
  }
  std::vector<double> volume(surface.vertices.size(), 0);
  const Vec<3> origin = surface.vertices.empty() ? Vec<3>::Zero() : surface.vertices[0];
  for (const auto& [a, b, c] : surface.facets)
    volume[sets.find(a)] +=
        (surface.vertices[a] - origin).dot((surface.vertices[b] - origin).cross(surface.vertices[c] - origin)) / 6;
  double largest = 0;
  for (const double v : volume) largest = std::max(largest, std::abs(v));
  // Cavities have a negative volume.
  const auto stays = [&](Index r) { return std::abs(volume[r]) >= std::min(least, largest); };
  std::size_t n_dropped = 0;
  for (Index v = 0; v < static_cast<Index>(surface.vertices.size()); ++v)
    if (sets.find(v) == v && !stays(v)) ++n_dropped;
  if (n_dropped == 0) return 0;
  Surface<3> rest;
  std::vector<Index> number(surface.vertices.size(), no_index);
  for (Index v = 0; v < static_cast<Index>(surface.vertices.size()); ++v)
    if (stays(sets.find(v))) {
      number[v] = static_cast<Index>(rest.vertices.size());
      rest.vertices.push_back(surface.vertices[v]);
    }
  for (const auto& [a, b, c] : surface.facets)
    if (number[a] != no_index) rest.facets.push_back({number[a], number[b], number[c]});
  surface = std::move(rest);
  return n_dropped;
}

}  // namespace shellmatch
