#include "matching/result/deformed_shape.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_point.h"

#include <Eigen/Geometry>

#include <array>
#include <utility>

namespace shellmatch {

namespace {

/// Facets of a shape as it was read, and the polygon (ring) of each.
template <int Dim>
struct FileFacets {
  Surface<Dim> surface;
  std::vector<Index> polygon;
};

template <int Dim>
FileFacets<Dim> facets_of_file(const OriginalShape<Dim>& shape, const Similarity<Dim>& placement) {
  FileFacets<Dim> facets;
  for (const Vec<Dim>& x : shape.vertices) facets.surface.vertices.push_back(placement(x));
  if constexpr (Dim == 3) {
    facets.surface.facets = triangulate(shape, &facets.polygon);
  } else {
    for (std::size_t p = 0; p < shape.polygons.size(); ++p)
      for (std::size_t k = 0; k < shape.polygons[p].size(); ++k) {
        facets.surface.facets.push_back({shape.polygons[p][k], shape.polygons[p][(k + 1) % shape.polygons[p].size()]});
        facets.polygon.push_back(static_cast<Index>(p));
      }
  }
  return facets;
}

}  // namespace

template <int Dim>
void add_correspondence(OriginalShape<Dim>& deformed, const OriginalShape<Dim>& template_shape,
                        const Similarity<Dim>& placement) {
  const FileFacets<Dim> facets = facets_of_file(template_shape, placement);
  if (facets.surface.facets.empty()) return;
  const FacetTree<Dim> tree(facets.surface);
  const std::size_t n = deformed.vertices.size();
  std::vector<double> face(n), corner[Dim], weight[Dim];
  for (int k = 0; k < Dim; ++k) {
    corner[k].resize(n);
    weight[k].resize(n);
  }
  parallel_chunks(n, 256, [&](const Chunk& chunk) {
    std::vector<Vec<Dim>> points;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) points.push_back(placement(deformed.vertices[i]));
    std::vector<Index> nearest(points.size());
    tree.nearest(points, nearest);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Index f = nearest[i - chunk.begin];
      SHELLMATCH_CHECK(f != no_index, "a vertex has a nearest face");
      const std::array<double, Dim> weights = barycentric_coordinates(
          facets.surface, f, closest_point_on_facet(facets.surface, f, points[i - chunk.begin]));
      face[i] = facets.polygon[f];
      for (int k = 0; k < Dim; ++k)
        corner[k][i] = facets.surface.facets[f][k], weight[k][i] = weights[static_cast<std::size_t>(k)];
    }
  });
  set_attribute(deformed, {Dim == 3 ? "template_face" : "template_ring", "int", std::move(face)});
  for (int k = 0; k < Dim; ++k) set_attribute(deformed, {fmt::format("template_v{}", k), "int", std::move(corner[k])});
  for (int k = 0; k < Dim; ++k)
    set_attribute(deformed, {fmt::format("template_b{}", k), "double", std::move(weight[k])});
}

template <int Dim>
OriginalShape<Dim> template_with_distance(const OriginalShape<Dim>& template_shape, const MapFrame<Dim>& frame,
                                          const SignedDistance<Dim>& distance_to_deformed) {
  OriginalShape<Dim> covered = template_shape;
  // Backward the template is the shape that the pose has moved.
  const Similarity<Dim> pose = frame.is_backward ? frame.pose : Similarity<Dim>{};
  std::vector<Vec<Dim>> placed = covered.vertices;
  for (Vec<Dim>& y : placed) y = frame.placement(pose(y));
  std::vector<double> distance = distances_to(placed, distance_to_deformed);
  for (double& d : distance) d /= frame.placement.scale * pose.scale;
  set_attribute(covered, {"distance_to_deformed", "float", std::move(distance)});
  return covered;
}

SHELLMATCH_2D_3D(add_correspondence);
SHELLMATCH_2D_3D(template_with_distance);

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

SHELLMATCH_2D_3D(set_attribute);
SHELLMATCH_2D_3D(deformed_original);

}  // namespace shellmatch
