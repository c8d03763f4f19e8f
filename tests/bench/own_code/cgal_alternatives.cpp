#include "tests/bench/own_code/alternatives.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <cmath>
#include <fstream>

namespace shellmatch::own_code {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
#if __has_include(<CGAL/AABB_traits_3.h>)
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>>>;
#else
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;
#endif

struct Built {
  Triangles triangles;
  Tree tree;
};

}  // namespace

Distance cgal_distance(const Surface<3>& surface) {
  const auto built = std::make_shared<Built>();
  const auto point = [](const Vec<3>& x) { return Kernel::Point_3(x.x(), x.y(), x.z()); };
  for (const auto& f : surface.facets)
    built->triangles.emplace_back(point(surface.vertices[f[0]]), point(surface.vertices[f[1]]),
                                  point(surface.vertices[f[2]]));
  built->tree.insert(built->triangles.begin(), built->triangles.end());
  built->tree.build();
  built->tree.accelerate_distance_queries();
  return [built, point](const Vec<3>& x) { return std::sqrt(built->tree.squared_distance(point(x))); };
}

std::optional<OriginalShape<3>> cgal_ply(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_PLY(in, points, polygons)) return std::nullopt;
  OriginalShape<3> shape;
  for (const auto& p : points) shape.vertices.emplace_back(p.x(), p.y(), p.z());
  for (const auto& polygon : polygons) shape.polygons.emplace_back(polygon.begin(), polygon.end());
  return shape;
}

}  // namespace shellmatch::own_code
