// The wrap of a set of triangles by CGAL.
#include "geometry/repair/close_surface.h"
#include "geometry/repair/cgal_repair_mesh.h"

#include <CGAL/alpha_wrap_3.h>

namespace shellmatch {

Surface<3> wrapped(const Surface<3>& triangles, double alpha, double offset) try {
  std::vector<CgalKernel::Point_3> points;
  for (const Vec<3>& x : triangles.vertices) points.emplace_back(x.x(), x.y(), x.z());
  std::vector<std::array<std::size_t, 3>> facets;
  for (const auto& [a, b, c] : triangles.facets)
    facets.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  CgalMesh mesh;
  CGAL::alpha_wrap_3(points, facets, alpha, offset, mesh);
  mesh.collect_garbage();
  return surface_of(mesh);
} catch (const CGAL::Failure_exception&) {
  return {};
}

}  // namespace shellmatch
