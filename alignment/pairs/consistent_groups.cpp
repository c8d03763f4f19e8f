#include "alignment/pairs/consistent_groups.h"

#include "base/disjoint_sets.h"

#include <algorithm>

namespace shellmatch {

std::vector<std::vector<std::pair<double, std::size_t>>> nearest_neighbours(const std::vector<Vec<3>>& points,
                                                                            std::size_t n_neighbours) {
  std::vector<std::vector<std::pair<double, std::size_t>>> nearest(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& near = nearest[i];
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i) near.emplace_back((points[j] - points[i]).norm(), j);
    const std::size_t n = std::min(n_neighbours, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(n), near.end());
    near.resize(n);
    near.shrink_to_fit();
  }
  return nearest;
}

std::vector<bool> in_consistent_group(const std::vector<Vec<3>>& from, const std::vector<Vec<3>>& to,
                                      double max_stretch, double error) {
  const auto nearest = nearest_neighbours(from, 6);
  DisjointSets groups(from.size()), parts(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    for (const auto& [distance, j] : nearest[i]) {
      const auto a = static_cast<Index>(i), b = static_cast<Index>(j);
      parts.join(a, b);
      if ((to[j] - to[i]).norm() < max_stretch * (distance + error)) groups.join(a, b);
    }
  std::vector<std::size_t> size(from.size(), 0), largest(from.size(), 0);
  const auto n = static_cast<Index>(from.size());
  for (Index i = 0; i < n; ++i) ++size[groups.find(i)];
  for (Index i = 0; i < n; ++i) largest[parts.find(i)] = std::max(largest[parts.find(i)], size[groups.find(i)]);
  std::vector<bool> consistent(from.size());
  for (Index i = 0; i < n; ++i) consistent[i] = size[groups.find(i)] == largest[parts.find(i)];
  return consistent;
}

}  // namespace shellmatch
