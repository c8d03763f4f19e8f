#include "matching/result/deformed_shape.h"

#include "geometry/distance/surface_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

/// Area of a polygon, or length of an edge of a ring.
double polygon_measure(const std::vector<Vec<3>>& x, const std::vector<Index>& polygon) {
  Vec<3> area = Vec<3>::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    area += 0.5 * (x[polygon[k]] - x[polygon[0]]).cross(x[polygon[k + 1]] - x[polygon[0]]);
  return area.norm();
}

/// For each vertex the measure of the polygons around it.
template <int Dim>
std::vector<double> vertex_measures(const OriginalShape<Dim>& shape) {
  std::vector<double> sum(shape.vertices.size(), 0.0);
  for (const auto& polygon : shape.polygons) {
    if constexpr (Dim == 3) {
      const double area = polygon_measure(shape.vertices, polygon);
      for (const Index v : polygon) sum[v] += area;
    } else {
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Index a = polygon[k], b = polygon[(k + 1) % polygon.size()];
        const double length = (shape.vertices[a] - shape.vertices[b]).norm();
        sum[a] += length;
        sum[b] += length;
      }
    }
  }
  return sum;
}

}  // namespace

template <int Dim>
void set_attribute(OriginalShape<Dim>& shape, VertexAttribute attribute) {
  std::erase_if(shape.attributes, [&](const VertexAttribute& a) { return a.name == attribute.name; });
  shape.attributes.push_back(std::move(attribute));
}

template <int Dim>
OriginalShape<Dim> deformed_original(const OriginalShape<Dim>& reference, std::vector<Vec<Dim>> carried,
                                     const Deformation<Dim>& deformation,
                                     const SignedDistance<Dim>& template_distance) {
  OriginalShape<Dim> moved = reference;
  moved.vertices = std::move(carried);
  // Backward the template is the shape that the pose has moved.
  const Similarity<Dim> pose = deformation.is_backward ? deformation.pose : Similarity<Dim>{};
  std::vector<Vec<Dim>> placed = moved.vertices;
  for (Vec<Dim>& y : placed) y = deformation.placement(pose(y));
  std::vector<double> distance = distances_to(placed, template_distance);
  for (double& d : distance) d /= deformation.placement.scale * pose.scale;
  const std::vector<double> before = vertex_measures(reference), after = vertex_measures(moved);
  std::vector<double> ratio(before.size());
  for (std::size_t i = 0; i < ratio.size(); ++i) ratio[i] = before[i] > 0 ? after[i] / before[i] : 1.0;
  set_attribute(moved, {"distance_to_template", "float", std::move(distance)});
  set_attribute(moved, {Dim == 3 ? "area_ratio" : "length_ratio", "float", std::move(ratio)});
  return moved;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                    \
  template void set_attribute<Dim>(OriginalShape<Dim>&, VertexAttribute);                              \
  template OriginalShape<Dim> deformed_original<Dim>(const OriginalShape<Dim>&, std::vector<Vec<Dim>>, \
                                                     const Deformation<Dim>&, const SignedDistance<Dim>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
