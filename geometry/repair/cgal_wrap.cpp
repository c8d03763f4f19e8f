// The wrap of a set of triangles by CGAL.
#include "geometry/repair/close_surface.h"
#include "geometry/repair/cgal_repair_mesh.h"

#include <CGAL/alpha_wrap_3.h>

namespace shellmatch {

Surface<3> wrapped(const Surface<3>& triangles, double alpha, double offset) try {
  const CgalSoup soup(triangles);
  CgalMesh mesh;
  CGAL::alpha_wrap_3(soup.points, soup.triangles, alpha, offset, mesh);
  mesh.collect_garbage();
  return surface_of(mesh);
} catch (const CGAL::Failure_exception&) {
  return {};
}

}  // namespace shellmatch
