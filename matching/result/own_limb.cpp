#include "matching/result/own_limb.h"

#include "alignment/spectrum/edge_graph.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/distance/nearest_facets.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_set>
#include <utility>

namespace shellmatch {

namespace {

// In square roots of areas. Maps that are right have errors of a few hundredths; along the surface touching limbs are
// farther apart than the first, and nearer to each other than the second.
constexpr double other_limb = 0.15, touching = 0.05;
constexpr double near_pair = 0.1;
constexpr double most_beside = 1.0 / 3;

/// Nearest vertices of a surface's facets.
class VertexTree {
 public:
  explicit VertexTree(const Surface<3>& surface) : points_{surface.vertices, {}} {
    std::vector<char> is_used(surface.vertices.size(), 0);
    for (const auto& facet : surface.facets)
      for (const Index v : facet)
        if (!std::exchange(is_used[v], 1)) points_.facets.push_back({v, v, v});
    tree_.emplace(points_);
  }
  Index nearest(const Vec<3>& x) const {
    const Index f = tree_->nearest(x);
    return f == no_index ? no_index : points_.facets[f][0];
  }

 private:
  Surface<3> points_;  ///< each a facet without extent
  std::optional<FacetTree<3>> tree_;
};

Index nearest_corner(const Surface<3>& surface, Index facet, const Vec<3>& x) {
  if (facet == no_index) return no_index;
  return *std::ranges::min_element(surface.facets[facet], {},
                                   [&](Index v) { return (surface.vertices[v] - x).squaredNorm(); });
}

/// A surface whose nearest facets are asked for several times.
class SearchedSurface {
 public:
  explicit SearchedSurface(const Surface<3>& surface) : surface_(surface), tree_(surface) {}

  // Of each point the corner of the nearest facet that is nearest to it.
  std::vector<Index> nearest_corners(const std::vector<Vec<3>>& points) const {
    std::vector<Index> corners = nearest_facets(tree_, points);
    for (std::size_t i = 0; i < points.size(); ++i) corners[i] = nearest_corner(surface_, corners[i], points[i]);
    return corners;
  }

 private:
  const Surface<3>& surface_;
  FacetTree<3> tree_;
};

/// What the template has near one vertex along its surface.
class OwnLimb {
 public:
  OwnLimb(const Surface<3>& surface, const EdgeGraph& graph, Index centre, double reach)
      : is_near_(surface.vertices.size(), 0) {
    graph.for_each_within(centre, reach, [&](Index v, double) { return is_near_[v] = 1, true; });
    facets_.vertices = surface.vertices;
    for (const auto& facet : surface.facets)
      if (std::ranges::all_of(facet, [&](Index v) { return is_near_[v] != 0; })) facets_.facets.push_back(facet);
    if (!facets_.facets.empty()) tree_.emplace(facets_);
  }

  bool has(Index vertex) const { return is_near_[vertex] != 0; }

  /// The nearest point on it; none where it has no facets.
  std::optional<Vec<3>> nearest(const Vec<3>& x) const {
    if (!tree_) return std::nullopt;
    return closest_point_on_facet(facets_, tree_->nearest(x), x).point;
  }

  /// x moved towards the corner of the nearest facet until of all vertices that one is the nearest.
  Vec<3> moved_to_vertex(Vec<3> x, const VertexTree& vertices) const {
    const Vec<3> own = facets_.vertices[nearest_corner(facets_, tree_->nearest(x), x)];
    for (int step = 0; step < 8; ++step) {
      const Index v = vertices.nearest(x);
      if (has(v)) return x;
      // Equally far from both: what differs between the squared distances is linear along the way.
      const Vec<3>& other = facets_.vertices[v];
      const double ahead = (x - own).squaredNorm() - (x - other).squaredNorm();
      x += (own - x) * std::min(1.0, 1.001 * ahead / (ahead + (own - other).squaredNorm()));
    }
    return own;
  }

 private:
  std::vector<char> is_near_;
  Surface<3> facets_;
  std::optional<FacetTree<3>> tree_;
};

/// The facet's corner and the vertex of the template that are nearest to a carried point.
struct Neighbours {
  Index corner, vertex;
};

// Of the points, those with a neighbour that is no nearer to the centre than `reach` along the surface.
std::vector<std::size_t> those_beside(const EdgeGraph& graph, Index centre, double reach,
                                      std::vector<std::size_t> points, const std::vector<Neighbours>& neighbours) {
  std::unordered_set<Index> not_reached;
  for (const std::size_t i : points) not_reached.insert({neighbours[i].corner, neighbours[i].vertex});
  graph.for_each_within(centre, reach, [&](Index v, double) {
    not_reached.erase(v);
    return !not_reached.empty();
  });
  std::erase_if(points, [&](std::size_t i) {
    return !not_reached.contains(neighbours[i].corner) && !not_reached.contains(neighbours[i].vertex);
  });
  return points;
}

std::size_t total_size(const std::vector<std::vector<std::size_t>>& lists) {
  return std::accumulate(lists.begin(), lists.end(), std::size_t{0},
                         [](std::size_t n, const auto& list) { return n + list.size(); });
}

}  // namespace

std::size_t lay_on_own_limbs(const Surface<3>& reference, const Surface<3>& template_shape,
                             const std::vector<SurfacePair>& pairs, const std::vector<Vec<3>>& points,
                             std::vector<Vec<3>>& carried) {
  if (pairs.empty() || reference.facets.empty() || template_shape.facets.empty()) return 0;
  std::vector<Vec<3>> here, there;
  for (const SurfacePair& pair : pairs) here.push_back(pair.on_reference), there.push_back(pair.on_template);
  const double reference_unit = std::sqrt(surface_measure(reference)),
               unit = std::sqrt(surface_measure(template_shape));
  const SearchedSurface of_reference(reference), of_template(template_shape);
  const std::vector<std::size_t> nearest_pair =
      EdgeGraph(reference).nearest_of(of_reference.nearest_corners(here), near_pair * reference_unit);
  const std::vector<Index> starts = of_reference.nearest_corners(points), centres = of_template.nearest_corners(there),
                           corners = of_template.nearest_corners(carried);
  const VertexTree vertices(template_shape);
  std::vector<Neighbours> neighbours(carried.size());
  parallel_for(
      carried.size(),
      [&](std::size_t i) {
        neighbours[i] = {corners[i], vertices.nearest(carried[i])};
      },
      64);
  std::vector<std::vector<std::size_t>> of_pair(pairs.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (starts[i] != no_index && corners[i] != no_index && nearest_pair[starts[i]] != EdgeGraph::none)
      of_pair[nearest_pair[starts[i]]].push_back(i);
  const auto n_known = static_cast<double>(total_size(of_pair));
  const EdgeGraph graph(template_shape);
  const double reach = other_limb * unit;
  parallel_for(
      pairs.size(),
      [&](std::size_t k) {
        if (!of_pair[k].empty()) of_pair[k] = those_beside(graph, centres[k], reach, std::move(of_pair[k]), neighbours);
      },
      16);
  if (static_cast<double>(total_size(of_pair)) > most_beside * n_known) return 0;
  std::vector<std::size_t> n_moved(pairs.size(), 0);
  parallel_for(
      pairs.size(),
      [&](std::size_t k) {
        if (of_pair[k].empty()) return;
        const OwnLimb limb(template_shape, graph, centres[k], reach);
        for (const std::size_t i : of_pair[k]) {
          const std::optional<Vec<3>> nearest = limb.nearest(carried[i]);
          if (!nearest || (*nearest - carried[i]).norm() > touching * unit) continue;
          carried[i] = limb.moved_to_vertex(limb.has(corners[i]) ? carried[i] : *nearest, vertices);
          ++n_moved[k];
        }
      },
      16);
  return std::accumulate(n_moved.begin(), n_moved.end(), std::size_t{0});
}

std::size_t lay_on_own_limbs(const MapFrame<3>& frame, const std::vector<Landmark<3>>& pairs,
                             const PlacedSurfaces& surfaces, const std::vector<Vec<3>>& points,
                             std::vector<Vec<3>>& carried) {
  // The pose moves the shape that phi deforms.
  const auto of_reference = [&](const Vec<3>& x) { return frame.placement(frame.is_backward ? x : frame.pose(x)); };
  const auto of_template = [&](const Vec<3>& y) { return frame.placement(frame.is_backward ? frame.pose(y) : y); };
  std::vector<SurfacePair> placed;
  for (const Landmark<3>& pair : pairs)
    placed.push_back({of_reference(frame.is_backward ? pair.on_template : pair.on_reference),
                      of_template(frame.is_backward ? pair.on_reference : pair.on_template)});
  std::vector<Vec<3>> from(points.size()), images(points.size());
  std::ranges::transform(points, from.begin(), of_reference);
  std::ranges::transform(carried, images.begin(), of_template);
  const std::vector<Vec<3>> before = images;
  const std::size_t n = lay_on_own_limbs(surfaces.reference, surfaces.template_shape, placed, from, images);
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (images[i] == before[i]) continue;
    carried[i] = frame.placement.inverse(images[i]);
    if (frame.is_backward) carried[i] = frame.pose.inverse(carried[i]);
  }
  return n;
}

}  // namespace shellmatch
