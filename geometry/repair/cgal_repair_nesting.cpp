#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/repair_steps.h"

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

// The surface in the unit box, by a power of two, which rounds nothing. Where the vertical ray from a point meets an edge, CGAL
// tries rays to the point plus a random vector of length 1 until one meets none: beyond 2^53 that is the point itself, for ever.
Surface<3> scaled_to_unit(const Surface<3>& surface) {
  const Box<3> box = bounding_box(surface.vertices);
  const double largest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
  Surface<3> scaled = surface;
  if (largest > 0)
    for (Vec<3>& x : scaled.vertices) x *= std::ldexp(1.0, -std::ilogb(largest));
  return scaled;
}

}  // namespace

std::vector<int> nesting_depths(const Surface<3>& original, const std::vector<std::vector<Index>>& parts) {
  std::vector<int> depths(parts.size(), 0);
  if (parts.size() == 1) return depths;
  const Surface<3> surface = scaled_to_unit(original);
  std::vector<Part> all;
  for (const std::vector<Index>& facets : parts) all.push_back(part_of(surface, facets));
  for (std::size_t outer = 0; outer < all.size(); ++outer) {
    std::vector<std::size_t> candidates;
    for (std::size_t inner = 0; inner < all.size(); ++inner)
      if (inner != outer && within(all[inner].box, all[outer].box)) candidates.push_back(inner);
    if (candidates.empty()) continue;
    const CgalMesh mesh = cgal_mesh(surface, all[outer].facets);
    const CGAL::Side_of_triangle_mesh<CgalMesh, CgalKernel> side(mesh);
    for (const std::size_t inner : candidates) {
      const auto inside = [&](Index v) {
        const Vec<3>& x = surface.vertices[v];
        return side({x.x(), x.y(), x.z()}) == CGAL::ON_BOUNDED_SIDE;
      };
      depths[inner] += std::all_of(all[inner].vertices.begin(), all[inner].vertices.end(), inside) ? 1 : 0;
    }
  }
  return depths;
}

}  // namespace shellmatch
