// The wrap of a set of triangles by CGAL.
#include "geometry/repair/close_surface.h"
#include "geometry/repair/cgal_repair_mesh.h"

#include <CGAL/alpha_wrap_3.h>

#include <vector>

namespace shellmatch {

Surface<3> wrapped(const Surface<3>& triangles, double alpha, double offset) try {
  CgalSoup soup(triangles);
  // CGAL leaves them out and does not expect that nothing is left.
  std::erase_if(soup.triangles, [&](const auto& t) {
    return CGAL::collinear(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  });
  if (soup.triangles.empty()) return {};
  CgalMesh mesh;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, offset, mesh);
  mesh.collect_garbage();
  return surface_of(mesh);
} catch (const CGAL::Failure_exception&) {
  return {};
}

}  // namespace shellmatch
