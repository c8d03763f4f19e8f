#include "geometry/curvature/curvature.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/curvature/least_squares.h"

// CGAL diagonalises the matrices of the fit with Eigen.
#ifndef CGAL_EIGEN3_ENABLED
#define CGAL_EIGEN3_ENABLED
#endif
#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

/// CGAL's concept SvdTraits, as CGAL::Eigen_svd models it, with the decomposition compiled in a file of its own.
struct LeastSquaresSvd {
  using FT = double;
  using Vector = CGAL::Eigen_vector<double>;
  using Matrix = CGAL::Eigen_matrix<double>;
  /// Replaces b by the solution of m x = b and returns the condition number of m.
  static double solve(const Matrix& m, Vector& b) { return solve_least_squares(m.eigen_object(), b.eigen_object()); }
};

using JetFit = CGAL::Monge_via_jet_fitting<Kernel, Kernel, LeastSquaresSvd>;

Vec<3> to_vec(const Kernel::Vector_3& v) { return {v.x(), v.y(), v.z()}; }

std::vector<std::vector<Index>> vertex_neighbours(const Surface<3>& surface) {
  std::vector<std::vector<Index>> neighbours(surface.vertices.size());
  for (const auto& facet : surface.facets)
    for (const Index v : facet)
      for (const Index w : facet)
        if (v != w) neighbours[v].push_back(w);
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbours;
}

/// Finds the vertices around one after another.
class Neighbourhood {
 public:
  explicit Neighbourhood(const std::vector<std::vector<Index>>& neighbours)
      : neighbours_(neighbours), found_for_(neighbours.size(), no_index) {}

  /// v itself and its neighbours: n_rings of them, and then more until there are n_points.
  std::vector<Index> of(Index v, int n_rings, std::size_t n_points) {
    std::vector<Index> found{v};
    found_for_[v] = v;
    std::size_t begin = 0;  // of the last ring
    for (int r = 0; begin < found.size() && (r < n_rings || found.size() < n_points); ++r)
      for (const std::size_t end = found.size(); begin < end; ++begin)
        for (const Index u : neighbours_[found[begin]])
          if (std::exchange(found_for_[u], v) != v) found.push_back(u);
    return found;
  }

 private:
  const std::vector<std::vector<Index>>& neighbours_;
  std::vector<Index> found_for_;  // the last vertex around which each one was found
};

/// Leaves the first vertex and those that are nearest to it, `most` in all. Two rings of an ordinary mesh have twenty;
/// around a vertex of thousands of edges everybody has thousands, and the fits of all would take the square of that.
void keep_nearest(const Surface<3>& surface, std::size_t most, std::vector<Index>& vertices) {
  if (vertices.size() <= most) return;
  const Vec<3> x = surface.vertices[vertices[0]];
  const auto place = [&](Index v) { return std::pair((surface.vertices[v] - x).squaredNorm(), v); };
  std::partial_sort(vertices.begin() + 1, vertices.begin() + static_cast<std::ptrdiff_t>(most), vertices.end(),
                    [&](Index a, Index b) { return place(a) < place(b); });
  vertices.resize(most);
}

VertexCurvature fit(const std::vector<Kernel::Point_3>& points, const Vec<3>& outward, int degree) {
  JetFit fit;
  auto monge = fit(points.begin(), points.end(), static_cast<std::size_t>(degree), 2);
  monge.comply_wrt_given_normal({outward.x(), outward.y(), outward.z()});
  // In CGAL's form z = (k1 x^2 + k2 y^2)/2 + ..., z along the normal, a convex surface has negative
  // curvatures and the first is the larger one.
  VertexCurvature result;
  result.k1 = -monge.principal_curvatures(1);
  result.k2 = -monge.principal_curvatures(0);
  result.d1 = to_vec(monge.minimal_principal_direction());
  result.normal = to_vec(monge.normal_direction());
  result.d2 = result.normal.cross(result.d1);
  return result;
}

}  // namespace

std::vector<VertexCurvature> vertex_curvatures(const Surface<3>& surface, const CurvatureOptions& options) {
  SHELLMATCH_CHECK(options.degree >= 2 && options.degree <= 4 && options.n_rings >= 1,
                   "jets of degree 2 to 4 are fitted to at least one ring of neighbours");
  const auto n_points = static_cast<std::size_t>((options.degree + 1) * (options.degree + 2) / 2);
  const auto neighbours = vertex_neighbours(surface);
  std::vector<Vec<3>> normals(surface.vertices.size(), Vec<3>::Zero());
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (const Index v : surface.facets[f]) normals[v] += facet_normal(surface, static_cast<Index>(f));

  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec<3> no_vector = Vec<3>::Constant(nan);
  std::vector<VertexCurvature> result(surface.vertices.size(), {nan, nan, no_vector, no_vector, no_vector});
  // Ten times as many as rings of six edges at each vertex have.
  const auto most = static_cast<std::size_t>(std::max(200, 10 * (1 + 3 * options.n_rings * (options.n_rings + 1))));
  // Each chunk has marks of its own for all vertices: of few chunks that is no memory.
  const std::size_t n_vertices = surface.vertices.size(), chunk_size = std::max<std::size_t>(64, n_vertices / 64);
  parallel_chunks(n_vertices, chunk_size, [&](const Chunk& chunk) {
    Neighbourhood neighbourhood(neighbours);
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      if (v % options.every != 0) continue;
      std::vector<Index> vertices = neighbourhood.of(static_cast<Index>(v), options.n_rings, n_points);
      keep_nearest(surface, most, vertices);
      std::vector<Kernel::Point_3> points;
      for (const Index w : vertices) {
        const Vec<3>& x = surface.vertices[w];
        points.emplace_back(x.x(), x.y(), x.z());
      }
      if (points.size() >= n_points) result[v] = fit(points, normals[v], options.degree);
    }
  });
  return result;
}

}  // namespace shellmatch
