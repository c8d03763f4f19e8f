#include "matching/shape_report/inspection.h"

#include "base/printable.h"
#include "base/text.h"
#include "geometry/distance/buried_parts.h"
#include "geometry/surface/placement.h"
#include "geometry/surface/pseudonormals.h"
#include "geometry/surface/topology.h"
#include "matching/experiment/level_overrides.h"
#include "matching/experiment/options.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// The curvature of a part of the shape, and the measure of that part.
struct Bend {
  double curvature, weight;
};

template <int Dim>
constexpr int n_edges = Dim == 2 ? 1 : 3;  // edges of a facet

// Largest change of the normal along a facet's edges, divided by their length. The normal of a vertex is the mean of
// those of the surrounding facets, weighted by measure.
template <int Dim>
std::vector<Bend> bends(const Surface<Dim>& s) {
  std::vector<Vec<Dim>> normals(s.vertices.size(), Vec<Dim>::Zero());
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f)
    for (const Index v : s.facets[f]) normals[v] += facet_normal(s, f);
  for (Vec<Dim>& n : normals) n = unit_or_zero(n);
  std::vector<Bend> result;
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) {
    double curvature = 0;
    for (int k = 0; k < n_edges<Dim>; ++k) {
      const Index a = s.facets[f][k], b = s.facets[f][(k + 1) % Dim];
      const double length = (s.vertices[a] - s.vertices[b]).norm();
      if (length > 0) curvature = std::max(curvature, (normals[a] - normals[b]).norm() / length);
    }
    result.push_back({curvature, facet_measure(s, f)});
  }
  return result;
}

// The quantile `share` of the curvature, weighted by measure.
double quantile(std::vector<Bend> all, double share) {
  if (all.empty()) return 0;
  std::sort(all.begin(), all.end(), [](const Bend& a, const Bend& b) { return a.curvature < b.curvature; });
  double total = 0, sum = 0;
  for (const Bend& b : all) total += b.weight;
  for (const Bend& b : all)
    if ((sum += b.weight) >= share * total) return b.curvature;
  return all.back().curvature;
}

template <int Dim>
double mean_edge_length(const Surface<Dim>& s) {
  double sum = 0;
  std::size_t n = 0;
  for (const auto& facet : s.facets)
    for (int k = 0; k < n_edges<Dim>; ++k, ++n) sum += (s.vertices[facet[k]] - s.vertices[facet[(k + 1) % Dim]]).norm();
  return n == 0 ? 0 : sum / static_cast<double>(n);
}

// Coarsest level with 2^-level <= length, at most the finest one.
int level_of_length(double length) {
  return std::isfinite(length) ? std::clamp(static_cast<int>(std::ceil(-std::log2(length))), 1, finest_level) : 1;
}

}  // namespace

template <int Dim>
Inspection inspect_shape(const Shape<Dim>& shape) {
  const Surface<Dim>& s = shape.surface;
  Inspection result;
  result.source = shape.source;
  result.dimension = Dim;
  if constexpr (Dim == 3) result.frame = space_name(shape.original.space);
  result.n_original_vertices = shape.original.vertices.size();
  result.n_original_polygons = shape.original.polygons.size();
  for (const VertexAttribute& attribute : shape.original.attributes) result.attributes.push_back(attribute.name);
  result.notes = shape.notes;

  result.n_facets = s.facets.size();
  const Topology shape_topology = topology(s);
  result.n_vertices = shape_topology.n_vertices;
  result.n_components = shape_topology.n_components;
  result.genus = shape_topology.genus;
  if constexpr (Dim == 3) {  // outlines that cross themselves are refused
    const BuriedParts buried = buried_parts(s, shape.crossing);
    result.n_buried_vertices = buried.n_vertices;
    result.buried_share = buried.share;
    result.burial_depth = buried.depth;
  }
  result.measure = surface_measure(s);
  result.enclosed = enclosed_measure(s);
  const Box<Dim> box = bounding_box(s.vertices);
  result.box_min.assign(box.min.data(), box.min.data() + Dim);
  result.box_max.assign(box.max.data(), box.max.data() + Dim);
  result.mean_edge = mean_edge_length(s);
  result.curvature_radius = 1 / quantile(bends(s), 0.95);

  result.scale = fit_placement(shape, shape, InputOptions{}.margin).scale;
  result.level_of_curvature = level_of_length(result.curvature_radius * result.scale / 2);
  result.level_of_edges = level_of_length(result.mean_edge * result.scale);
  return result;
}

namespace {

// Six digits of the box's size, however far from the origin it lies: formats of fmt's join take no digits of their own.
std::string box_text(const Inspection& r) {
  double largest = 0, size = 0;
  for (std::size_t k = 0; k < r.box_min.size(); ++k) {
    largest = std::max({largest, std::abs(r.box_min[k]), std::abs(r.box_max[k])});
    size = std::max(size, r.box_max[k] - r.box_min[k]);
  }
  const int digits = size > 0 ? std::clamp(6 + static_cast<int>(std::log10(largest / size)), 6, 17) : 6;
  const auto corner = [&](const std::vector<double>& x) {
    std::vector<std::string> numbers;
    for (const double a : x) numbers.push_back(fmt::format("{:.{}g}", a, digits));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
  };
  return corner(r.box_min) + " to " + corner(r.box_max);
}

}  // namespace

std::string inspection_text(const Inspection& r) {
  const bool plane = r.dimension == 2;
  std::string text = fmt::format("{}: {}\n", printable(r.source, max_message_length),
                                 plane ? "a contour in the plane" : "a surface in space");
  const auto row = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<22}{}\n", name, value);
  };
  row("in the file",
      fmt::format("{} vertices, {} {}", r.n_original_vertices, r.n_original_polygons, plane ? "ring(s)" : "polygons"));
  if (!r.attributes.empty()) row("vertex attributes", fmt::format("{}", fmt::join(r.attributes, ", ")));
  row("used for matching",
      fmt::format("{} vertices, {} {}", r.n_vertices, r.n_facets, plane ? "segments" : "triangles"));
  if (!plane) row("frame", r.frame.empty() ? "the file names none; 3D Slicer takes LPS" : r.frame);
  row("components", fmt::format("{}", r.n_components));
  if (!plane) row("genus", fmt::format("{}", r.genus));
  row(plane ? "length" : "area", fmt::format("{:.6g}", r.measure));
  row(plane ? "enclosed area" : "enclosed volume", fmt::format("{:.6g}", r.enclosed));
  row("box", box_text(r));
  row("mean edge", fmt::format("{:.4g}", r.mean_edge));
  if (std::isfinite(r.curvature_radius))
    row("radius of curvature", fmt::format("{:.4g}; 95 % are bent less", r.curvature_radius));
  row("levels", fmt::format("the curvature asks for {} or finer; cells of level {} are about as long as the edges",
                            r.level_of_curvature, r.level_of_edges));
  if (r.buried_share > 0)
    row("buried",
        fmt::format("{:.2g} % of the area, with {}, inside other parts of the shape, up to {:.4g} deep; weighs nothing "
                    "in a matching",
                    100 * r.buried_share, counted(r.n_buried_vertices, "vertex", "vertices"), r.burial_depth));
  for (const std::string& note : r.notes) row("note", printable(note, max_message_length));
  return text;
}

SHELLMATCH_2D_3D(inspect_shape);

}  // namespace shellmatch
