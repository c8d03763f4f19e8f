#include "geometry/surface/surface.h"

#include "base/parallel.h"

#include <Eigen/Geometry>

namespace shellmatch {

Vec<3> facet_normal(const Surface<3>& s, Index f) {
  const auto& [a, b, c] = s.facets[f];
  return (s.vertices[b] - s.vertices[a]).cross(s.vertices[c] - s.vertices[a]);
}

template <int Dim>
double surface_measure(const Surface<Dim>& s) {
  double sum = 0;
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) sum += facet_measure(s, f);
  return sum;
}

template <int Dim>
std::vector<double> vertex_measures(const Surface<Dim>& s) {
  std::vector<double> measure(s.vertices.size(), 0.0);
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    const double share = facet_measure(s, static_cast<Index>(f)) / Dim;
    for (const Index v : s.facets[f]) measure[v] += share;
  }
  return measure;
}

template <int Dim>
std::vector<Vec<Dim>> vertex_normals(const Surface<Dim>& s) {
  std::vector<Vec<Dim>> normals(s.vertices.size(), Vec<Dim>::Zero());
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) {
    const Vec<Dim> normal = facet_normal(s, f);
    for (const Index v : s.facets[f]) normals[v] += normal;
  }
  for (Vec<Dim>& n : normals) n.normalize();  // keeps zero vectors
  return normals;
}

// The divergence theorem for the field (x - origin)/Dim. The origin is a vertex of the surface, which avoids
// cancellation for surfaces far from 0.
template <int Dim>
double enclosed_measure(const Surface<Dim>& s) {
  if (s.facets.empty()) return 0;
  const Vec<Dim> origin = s.vertices[s.facets[0][0]];
  const double flux = parallel_sum(s.facets.size(), 4096, 0.0, [&](const Chunk& chunk) {
    double sum = 0;
    for (std::size_t f = chunk.begin; f < chunk.end; ++f)
      sum += (s.vertices[s.facets[f][0]] - origin).dot(facet_normal(s, static_cast<Index>(f)));
    return sum;
  });
  return flux / (Dim * (Dim - 1));
}

SHELLMATCH_2D_3D(surface_measure);
SHELLMATCH_2D_3D(vertex_measures);
SHELLMATCH_2D_3D(vertex_normals);
SHELLMATCH_2D_3D(enclosed_measure);

}  // namespace shellmatch
