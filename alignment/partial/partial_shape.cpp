#include "alignment/partial/partial_shape.h"

#include "alignment/spectrum/spin_images.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

std::vector<Index> border_vertices(const Surface<3>& surface) {
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& facet : surface.facets)
    for (int k = 0; k < 3; ++k) edges.emplace_back(facet[k], facet[(k + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::vector<Index> vertices;
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) vertices.insert(vertices.end(), {a, b});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

PartialShape make_partial_shape(Surface<3> surface, double unit, const AlignmentOptions& options) {
  for (Vec<3>& x : surface.vertices) x /= unit;
  const SurfaceLaplacian laplacian = surface_laplacian(surface, options.mollification);
  const auto n = static_cast<int>(surface.vertices.size());
  Eigenpairs spectrum = least_eigenpairs(laplacian, std::min(options.functions, (n - 1) / 2));
  Rows3 coordinates(n, 3);
  for (int v = 0; v < n; ++v) coordinates.row(v) = surface.vertices[v];
  Rows3 coefficients = spectrum.functions.transpose() * laplacian.mass.asDiagonal() * coordinates;
  Eigen::MatrixXf spin = spin_images(surface, laplacian, part_spin_radius);
  EdgeGraph graph(surface);
  std::vector<double> to_border(surface.vertices.size(), std::numeric_limits<double>::infinity());
  for (const Index v : border_vertices(surface)) graph.lower_distances(v, to_border);
  return {std::move(surface),      std::move(graph), laplacian.mass,      std::move(spectrum),
          std::move(coefficients), std::move(spin),  std::move(to_border)};
}

}  // namespace shellmatch
