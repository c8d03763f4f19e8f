// Distances and self-intersections against CGAL's own, on a real mesh where there is one.
#include "geometry/surface/self_intersections.h"
#include "geometry/distance/cgal_triangle_tree.h"
#include "geometry/distance/signed_distance.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <set>

namespace shellmatch {
namespace {

using namespace test;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 to_cgal(const Vec<3>& x) { return {x.x(), x.y(), x.z()}; }

void expect_cgal_distances(const Surface<3>& surface) {
  using Triangles = std::vector<Kernel::Triangle_3>;
  Triangles triangles;
  for (const auto& [a, b, c] : surface.facets)
    triangles.emplace_back(to_cgal(surface.vertices[a]), to_cgal(surface.vertices[b]), to_cgal(surface.vertices[c]));
  const CgalTriangleTree<Kernel, Triangles::const_iterator> tree(triangles.cbegin(), triangles.cend());
  const SignedDistance<3> distance(surface);
  for (const Vec<3>& x : query_points(surface, 1000, 4))
    EXPECT_NEAR(std::abs(distance(x)), std::sqrt(tree.squared_distance(to_cgal(x))), 1e-12);
}

TEST(CgalComparison, DistancesAgree) {
  expect_cgal_distances(torus(0.6, 0.25, 40, 20));
  const auto vertebra = data_surface("vertebra_L1_verse/verse018_aligned_to_016.ply");
  if (!vertebra) GTEST_SKIP() << "set SHELLMATCH_DATA to the data folder";
  expect_cgal_distances(*vertebra);
}

TEST(CgalComparison, SelfIntersectionsAgree) {
  // Two tori that cross, and a sphere whose vertices are moved so far that it folds over.
  const Surface<3> ring = torus(0.6, 0.2, 24, 12);
  const Surface<3> moved = mapped<3>(ring, [](const Vec<3>& x) { return Vec<3>(x.x() + 0.9, x.z(), x.y()); });
  const auto noise = random_points<3>(300, Vec<3>::Constant(-0.2), Vec<3>::Constant(0.2), 2);
  std::size_t i = 0;
  const Surface<3> crumpled =
      mapped<3>(unit_sphere(3), [&](const Vec<3>& x) { return Vec<3>(x + noise[i++ % noise.size()]); });
  for (const Surface<3>& s : {joined(ring, reversed(moved)), crumpled}) {
    CGAL::Surface_mesh<Kernel::Point_3> mesh;
    using Mesh = decltype(mesh);
    for (const Vec<3>& x : s.vertices) mesh.add_vertex(to_cgal(x));
    for (const auto& [a, b, c] : s.facets)
      mesh.add_face(Mesh::Vertex_index(static_cast<unsigned>(a)), Mesh::Vertex_index(static_cast<unsigned>(b)),
                    Mesh::Vertex_index(static_cast<unsigned>(c)));
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    std::set<Index> expected;
    for (const auto& [f, g] : pairs) {
      expected.insert(static_cast<Index>(f.idx()));
      expected.insert(static_cast<Index>(g.idx()));
    }
    EXPECT_GT(expected.size(), 20u);
    EXPECT_EQ(self_intersecting_facets(s), std::vector<Index>(expected.begin(), expected.end()));
  }
}

}  // namespace
}  // namespace shellmatch
