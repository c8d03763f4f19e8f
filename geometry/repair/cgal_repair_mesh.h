#pragma once
/// \file
/// Our triangles as CGAL's mesh, for the cgal_*.cpp files alone.

#include "base/stop.h"
#include "geometry/surface/surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <vector>

namespace shellmatch {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

/// The mesh of the triangles `facets` of a surface; faces that would make it non-manifold are left out.
inline CgalMesh cgal_mesh(const Surface<3>& surface, const std::vector<std::array<Index, 3>>& facets) {
  CgalMesh mesh;
  std::vector<CgalMesh::Vertex_index> vertex(surface.vertices.size(), CgalMesh::null_vertex());
  StopCheck stop_check;
  for (const std::array<Index, 3>& facet : facets) {
    stop_check();
    std::array<CgalMesh::Vertex_index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(facet[k]);
      const Vec<3>& x = surface.vertices[i];
      if (vertex[i] == CgalMesh::null_vertex()) vertex[i] = mesh.add_vertex({x.x(), x.y(), x.z()});
      corners[k] = vertex[i];
    }
    mesh.add_face(corners);
  }
  return mesh;
}

/// Points and triangles by themselves.
struct CgalSoup {
  std::vector<CgalKernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  explicit CgalSoup(const Surface<3>& surface) {
    for (const Vec<3>& x : surface.vertices) points.emplace_back(x.x(), x.y(), x.z());
    for (const auto& [a, b, c] : surface.facets)
      triangles.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  }
};

/// The surface of a mesh. \pre nothing was removed from it since its last collect_garbage()
inline Surface<3> surface_of(const CgalMesh& mesh) {
  Surface<3> surface;
  for (const CgalMesh::Vertex_index v : mesh.vertices())
    surface.vertices.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  for (const CgalMesh::Face_index f : mesh.faces()) {
    std::array<Index, 3>& facet = surface.facets.emplace_back();
    std::size_t k = 0;
    for (const CgalMesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      facet[k++] = static_cast<Index>(v.idx());
  }
  return surface;
}

}  // namespace shellmatch
