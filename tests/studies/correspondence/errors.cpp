#include "tests/studies/correspondence/errors.h"

#include "alignment/spectrum/edge_graph.h"
#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

std::vector<Index> nearest_vertices(std::span<const Vec<3>> vertices, std::span<const Vec<3>> points) {
  std::vector<Index> nearest(points.size());
  parallel_for(
      points.size(),
      [&](std::size_t i) {
        double least = infinity;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
          const double d = (vertices[v] - points[i]).squaredNorm();
          if (d >= least) continue;
          least = d;
          nearest[i] = static_cast<Index>(v);
        }
      },
      64);
  return nearest;
}

std::vector<double> geodesic_errors(const Surface<3>& template_surface, std::span<const Index> ends,
                                    std::span<const Index> belong) {
  const double area = surface_measure(template_surface);
  if (!(area > 0)) throw_input_error("the template has no area: geodesic errors are in roots of it");
  const EdgeGraph graph(template_surface);
  std::vector<double> errors(ends.size());
  parallel_for(
      ends.size(), [&](std::size_t i) { errors[i] = graph.distance(ends[i], belong[i]) / std::sqrt(area); }, 16);
  return errors;
}

std::vector<double> euclidean_errors(std::span<const Vec<3>> template_vertices, std::span<const Vec<3>> ends,
                                     std::span<const Index> belong) {
  const double diagonal = bounding_box<3>({template_vertices.begin(), template_vertices.end()}).diagonal();
  if (!(diagonal > 0)) throw_input_error("the template has no extent: distances are in diagonals of it");
  std::vector<double> errors;
  for (std::size_t i = 0; i < ends.size(); ++i)
    errors.push_back((ends[i] - template_vertices[belong[i]]).norm() / diagonal);
  return errors;
}

}  // namespace shellmatch
