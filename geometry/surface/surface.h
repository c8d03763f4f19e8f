#pragma once
/// \file
/// The two representations of a shape: the simplicial hypersurface of the computations, and the shape as read
/// from the file, in which results are returned.

#include "base/types.h"
#include "geometry/surface/plane_frame.h"
#include "geometry/surface/space.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace shellmatch {

/// A hypersurface of simplices: triangles in space, segments in the plane. Orientation: facet normals point
/// outward; that is (b - a) x (c - a) for triangles, and for a segment a -> b the direction rotated
/// clockwise, (dy, -dx), so that outer rings run counter-clockwise.
template <int Dim>
struct Surface {
  std::vector<Vec<Dim>> vertices;
  std::vector<std::array<Index, Dim>> facets;
};

/// Values at the vertices of a shape as read from the file: colours, texture coordinates, labels.
struct VertexAttribute {
  std::string name;                     ///< as in the file, "red" or "quality"
  std::string type = "float";           ///< PLY type of the values in the output: "uchar", "int", "double"
  std::vector<double> values;           ///< one for each original vertex
  std::vector<std::string> texts = {};  ///< in place of values, where the type is "text"
};

struct MeshDetails;

/// A shape as read from the file: vertices in their order, polygons not triangulated, attributes kept.
template <int Dim>
struct OriginalShape {
  std::vector<Vec<Dim>> vertices;
  std::vector<std::vector<Index>> polygons;  ///< in the plane: the rings, without repeating the first point
  std::vector<VertexAttribute> attributes;
  std::shared_ptr<const MeshDetails> details = {};  ///< what else is in the file (geometry/surface/mesh_details.h)
  Space space = Space::unsaid;                      ///< the frame of the coordinates, where the file names it
  PlaneFrame frame = {};                            ///< in the plane: how the file's coordinates became these
};

/// What of a closed surface is known to bound the body, and what is not.
template <int Dim>
struct Evidence {
  /// The file's own facets, and others: those that were made up to fill or bridge gaps, and the file's own that lie
  /// inside other parts of the body (geometry/distance/buried_parts.h). Both are empty where all are observed.
  Surface<Dim> observed, unobserved;
  bool is_complete() const { return unobserved.facets.empty(); }
};

/// A shape ready for matching. `surface` is closed, welded and oriented outward.
template <int Dim>
struct Shape {
  std::string source;  ///< the file it came from, for messages
  OriginalShape<Dim> original;
  Surface<Dim> surface;
  std::vector<std::string> notes;  ///< repairs in words: "12 duplicate vertices welded"
  Evidence<Dim> evidence = {};     ///< for `surface`, in its coordinates
  double invented_share = 0;       ///< of the surface's area: what was made up to close it, in [0, 1]
  double buried_share = 0;         ///< of the surface's area: what the evidence leaves out as buried, in [0, 1]
  std::string unit = {};           ///< of the coordinates, where the file names it: "mm"
  /// Facets of `surface` that cross or touch others (geometry/surface/self_intersections.h); not searched beyond
  /// self_intersection_limit.
  std::vector<Index> crossing = {};
};

/// An axis-parallel box.
template <int Dim>
struct Box {
  Vec<Dim> min = Vec<Dim>::Constant(std::numeric_limits<double>::infinity());
  Vec<Dim> max = Vec<Dim>::Constant(-std::numeric_limits<double>::infinity());
  void add(const Vec<Dim>& x) {
    min = min.cwiseMin(x);
    max = max.cwiseMax(x);
  }
  double diagonal() const { return (max - min).norm(); }
};

template <int Dim>
Box<Dim> bounding_box(const std::vector<Vec<Dim>>& points) {
  Box<Dim> box;
  for (const Vec<Dim>& x : points) box.add(x);
  return box;
}

/// Facet normal, whose norm is the facet's length (plane) or twice its area (space).
inline Vec<2> facet_normal(const Surface<2>& s, Index f) {
  const auto& [a, b] = s.facets[f];
  const Vec<2> e = s.vertices[b] - s.vertices[a];
  return {e.y(), -e.x()};
}
Vec<3> facet_normal(const Surface<3>& s, Index f);

/// Length (plane) or area (space).
template <int Dim>
double facet_measure(const Surface<Dim>& s, Index f) {
  return facet_normal(s, f).norm() / (Dim - 1);
}

/// Length (plane) or area (space) of all facets.
template <int Dim>
double surface_measure(const Surface<Dim>& s);

/// For each vertex the area (length) that it stands for: its share of the facets around it, which adds up to
/// surface_measure.
template <int Dim>
std::vector<double> vertex_measures(const Surface<Dim>& s);

/// Unit normals at the vertices, the mean over the facets around by their length (plane) or area (space); zero where
/// there is none.
template <int Dim>
std::vector<Vec<Dim>> vertex_normals(const Surface<Dim>& s);

/// Enclosed area (plane) or volume (space), signed by the orientation. Unit: length^Dim.
template <int Dim>
double enclosed_measure(const Surface<Dim>& s);

}  // namespace shellmatch
