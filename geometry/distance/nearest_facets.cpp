#include "geometry/distance/nearest_facets.h"

#include "base/parallel.h"
#include "geometry/surface/morton_curve.h"

#include <array>
#include <span>

namespace shellmatch {

template <int Dim>
std::vector<Index> nearest_facets(const FacetTree<Dim>& tree, const std::vector<Vec<Dim>>& points) {
  constexpr std::size_t chunk_size = 256;
  const std::vector<Index> order = along_morton_curve<Dim>(points);
  std::vector<Index> facets(points.size());
  parallel_chunks(points.size(), chunk_size, [&](const Chunk& chunk) {
    std::array<Vec<Dim>, chunk_size> some;
    std::array<Index, chunk_size> nearest;
    const std::size_t n = chunk.end - chunk.begin;
    for (std::size_t i = 0; i < n; ++i) some[i] = points[static_cast<std::size_t>(order[chunk.begin + i])];
    tree.nearest(std::span(some).first(n), std::span(nearest).first(n));
    for (std::size_t i = 0; i < n; ++i) facets[static_cast<std::size_t>(order[chunk.begin + i])] = nearest[i];
  });
  return facets;
}

template std::vector<Index> nearest_facets(const FacetTree<2>&, const std::vector<Vec<2>>&);
template std::vector<Index> nearest_facets(const FacetTree<3>&, const std::vector<Vec<3>>&);

}  // namespace shellmatch
