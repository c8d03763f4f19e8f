#include "geometry/distance/nearest_facets.h"

#include "base/parallel.h"
#include "geometry/surface/morton_curve.h"

#include <array>
#include <span>
#include <utility>

namespace shellmatch {

template <int Dim>
OrientedFacets<Dim>::OrientedFacets(const Surface<Dim>& surface) : surface_(&surface), sides_(2 * Dim) {
  for (Index f = 0; f < static_cast<Index>(surface.facets.size()); ++f) {
    const Vec<Dim> normal = facet_normal(surface, f);
    int axis = 0;
    if (!(normal.cwiseAbs().maxCoeff(&axis) > 0)) continue;
    sides_[static_cast<std::size_t>(2 * axis + (normal[axis] < 0 ? 1 : 0))].facets.push_back(f);
  }
  Surface<Dim> part{surface.vertices, {}};
  for (Side& side : sides_) {
    part.facets.clear();
    for (const Index f : side.facets) part.facets.push_back(surface.facets[static_cast<std::size_t>(f)]);
    if (!part.facets.empty()) side.tree.emplace(part);
  }
}

template <int Dim>
std::optional<typename OrientedFacets<Dim>::Nearest> OrientedFacets<Dim>::nearest(const Vec<Dim>& x,
                                                                                  const Vec<Dim>& normal) const {
  std::optional<Nearest> best;
  for (int s = 0; s < 2 * Dim; ++s) {
    const Side& side = sides_[static_cast<std::size_t>(s)];
    if (!side.tree || !((s % 2 ? -1 : 1) * normal[s / 2] > 0)) continue;
    const Index at = side.tree->nearest(x);
    if (at == no_index) continue;
    const Index f = side.facets[static_cast<std::size_t>(at)];
    if (!(facet_normal(*surface_, f).dot(normal) > 0)) continue;
    const FacetPoint<Dim> point = closest_point_on_facet(*surface_, f, x);
    const double distance = (point.point - x).norm();
    if (!best || distance < best->distance) best = Nearest{f, point, distance};
  }
  return best;
}

template class OrientedFacets<2>;
template class OrientedFacets<3>;

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

SHELLMATCH_2D_3D(nearest_facets);

}  // namespace shellmatch
