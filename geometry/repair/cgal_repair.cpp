// Consistent orientation through CGAL's Polygon Mesh Processing.

#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_edges.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

struct Part {
  Triangles facets;
  std::vector<Index> vertices;
  Box<3> box;
};

Part part_of(const Surface<3>& surface, const std::vector<Index>& facets) {
  Part part;
  for (const Index f : facets) {
    part.facets.push_back(surface.facets[f]);
    for (const Index v : surface.facets[f]) part.vertices.push_back(v);
  }
  std::sort(part.vertices.begin(), part.vertices.end());
  part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
  for (const Index v : part.vertices) part.box.add(surface.vertices[v]);
  return part;
}

bool within(const Box<3>& inner, const Box<3>& outer) {
  return (inner.min.array() >= outer.min.array()).all() && (inner.max.array() <= outer.max.array()).all();
}

// The surface in the unit box, by a power of two, which rounds nothing. Where the vertical ray from a point meets an
// edge, CGAL tries rays to the point plus a random vector of length 1 until one meets none: beyond 2^53 that is the
// point itself, for ever.
Surface<3> scaled_to_unit(const Surface<3>& surface) {
  const Box<3> box = bounding_box(surface.vertices);
  const double largest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
  Surface<3> scaled = surface;
  if (largest > 0)
    for (Vec<3>& x : scaled.vertices) x *= std::ldexp(1.0, -std::ilogb(largest));
  return scaled;
}

using Side = CGAL::Side_of_triangle_mesh<CgalMesh, CgalKernel>;

// Nothing of the part is outside. It may touch the other with vertices and edges, not with a facet: that is no cavity
// in it.
bool is_inside(const Part& part, const Surface<3>& surface, const Side& side_of_other) {
  const auto side = [&](const Vec<3>& x) { return side_of_other({x.x(), x.y(), x.z()}); };
  std::vector<Index> free;  // vertices that do not touch
  StopCheck stop_check;
  for (const Index v : part.vertices) {
    stop_check();
    const CGAL::Bounded_side where = side(surface.vertices[v]);
    if (where == CGAL::ON_UNBOUNDED_SIDE) return false;
    if (where == CGAL::ON_BOUNDED_SIDE) free.push_back(v);
  }
  return std::ranges::all_of(part.facets, [&](const std::array<Index, 3>& facet) {
    if (std::ranges::any_of(facet, [&](Index v) { return std::ranges::binary_search(free, v); })) return true;
    const auto& [a, b, c] = facet;
    return side((surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3) == CGAL::ON_BOUNDED_SIDE;
  });
}

}  // namespace

std::vector<int> nesting_depths(const Surface<3>& original, const std::vector<std::vector<Index>>& parts) {
  std::vector<int> depths(parts.size(), 0);
  if (parts.size() == 1) return depths;
  const Surface<3> surface = scaled_to_unit(original);
  const auto point = [&](Index v) {
    return CgalKernel::Point_3(surface.vertices[v].x(), surface.vertices[v].y(), surface.vertices[v].z());
  };
  std::vector<Part> all;
  for (const std::vector<Index>& facets : parts) all.push_back(part_of(surface, facets));
  for (std::size_t outer = 0; outer < all.size(); ++outer) {
    stop_if_wanted();
    std::vector<std::size_t> candidates;
    for (std::size_t inner = 0; inner < all.size(); ++inner)
      if (inner != outer && within(all[inner].box, all[outer].box)) candidates.push_back(inner);
    if (candidates.empty()) continue;
    // Every ray that meets a triangle without area is tried again, for ever; without them the same is inside.
    Triangles solid = all[outer].facets;
    std::erase_if(solid, [&](const auto& f) { return CGAL::collinear(point(f[0]), point(f[1]), point(f[2])); });
    const CgalMesh mesh = cgal_mesh(surface, solid);
    const Side side(mesh);
    for (const std::size_t inner : candidates) depths[inner] += is_inside(all[inner], surface, side) ? 1 : 0;
  }
  return depths;
}

namespace {

using Kernel = CgalKernel;

// Do two triangles with the same corners run the same way round? New copies of vertices count as the old.
bool same_turn(const std::array<Index, 3>& before, const std::array<std::size_t, 3>& after,
               const std::vector<Kernel::Point_3>& points) {
  const auto at = [&](Index v) { return points[static_cast<std::size_t>(v)]; };
  for (std::size_t k = 0; k < 3; ++k)
    if (points[after[k]] == at(before[0]))
      return points[after[(k + 1) % 3]] == at(before[1]) && points[after[(k + 2) % 3]] == at(before[2]);
  return false;
}

}  // namespace

Orientation orient_consistently(Surface<3>& surface) {
  if (is_oriented_manifold(surface.facets, surface.vertices.size())) return {};
  auto [points, triangles] = CgalSoup(surface);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles);
  Orientation result;
  result.n_split = points.size() - surface.vertices.size();
  for (std::size_t k = surface.vertices.size(); k < points.size(); ++k)
    surface.vertices.emplace_back(points[k].x(), points[k].y(), points[k].z());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.n_turned += same_turn(surface.facets[t], triangles[t], points) ? 0 : 1;
    for (std::size_t k = 0; k < 3; ++k) surface.facets[t][k] = static_cast<Index>(triangles[t][k]);
  }
  return result;
}

}  // namespace shellmatch
