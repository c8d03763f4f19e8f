#include "geometry/surface/placement.h"

#include "base/error.h"

#include <Eigen/LU>

#include <string>
#include <utility>

namespace shellmatch {

namespace {

template <int Dim>
std::string coordinates(const Vec<Dim>& x) {
  std::string text = fmt::format("({:g}", x[0]);
  for (int i = 1; i < Dim; ++i) text += fmt::format(", {:g}", x[i]);
  return text + ")";
}

/// Ignores vertices without a facet: they are not part of the surface.
template <int Dim, class Visit>
void for_each_used_vertex(const Surface<Dim>& surface, Visit&& visit) {
  std::vector<bool> used(surface.vertices.size(), false);
  for (const auto& facet : surface.facets)
    for (const Index v : facet) used[v] = true;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) visit(v, surface.vertices[v]);
}

/// Names a vertex by its number in the file if the file has a vertex at the same point. A vertex of the
/// computational surface may have no counterpart there.
template <int Dim>
std::string vertex_name(const Shape<Dim>& shape, std::size_t v) {
  const Vec<Dim>& x = shape.surface.vertices[v];
  for (std::size_t i = 0; i < shape.original.vertices.size(); ++i)
    if (shape.original.vertices[i] == x) return fmt::format("vertex {}", i);
  return fmt::format("vertex {} of the mended surface", v);
}

template <int Dim>
void require_inside(const Shape<Dim>& shape, double clearance) {
  for_each_used_vertex(shape.surface, [&](std::size_t v, const Vec<Dim>& x) {
    if ((x.array() >= clearance).all() && (x.array() <= 1 - clearance).all()) return;
    throw_input_error(
        "{}: {} at {} is not inside [{:g}, {:g}]^{}, where shapes must lie that are used as they are; scale "
        "and move "
        "both shapes, or use the placement 'fit'",
        shape.source, vertex_name(shape, v), coordinates(x), clearance, 1 - clearance, Dim);
  });
}

}  // namespace

template <int Dim>
Similarity<Dim> fit_placement(const Shape<Dim>& reference, const Shape<Dim>& template_shape, double margin) {
  Box<Dim> box;
  for (const Shape<Dim>* shape : {&reference, &template_shape})
    for_each_used_vertex(shape->surface, [&](std::size_t, const Vec<Dim>& x) { box.add(x); });
  const double side = (box.max - box.min).maxCoeff();
  // Written so that NaN fails.
  if (!(side > 0) || !std::isfinite(side))
    throw_input_error(
        "{} and {}: the shapes have no extent that could be placed in the unit domain; all of their "
        "points coincide or are not finite",
        reference.source, template_shape.source);
  Similarity<Dim> placement;
  placement.scale = (1 - 2 * margin) / side;
  placement.offset = Vec<Dim>::Constant(0.5) - placement.scale * (0.5 * box.min + 0.5 * box.max);
  return placement;
}

template <int Dim>
Similarity<Dim> as_is_placement(const Shape<Dim>& reference, const Shape<Dim>& template_shape, double clearance) {
  require_inside(reference, clearance);
  require_inside(template_shape, clearance);
  return {};
}

template <int Dim>
void apply_similarity(const Similarity<Dim>& placement, Surface<Dim>& surface) {
  for (Vec<Dim>& x : surface.vertices) x = placement(x);
  if (placement.rotation.determinant() < 0)
    for (auto& facet : surface.facets) std::swap(facet[0], facet[1]);
}

template <int Dim>
void apply_similarity(const Similarity<Dim>& placement, Shape<Dim>& shape) {
  for (Surface<Dim>* surface : {&shape.surface, &shape.evidence.observed, &shape.evidence.unobserved})
    apply_similarity(placement, *surface);
}

SHELLMATCH_2D_3D(fit_placement);
SHELLMATCH_2D_3D(as_is_placement);
template void apply_similarity(const Similarity<2>&, Surface<2>&);
template void apply_similarity(const Similarity<3>&, Surface<3>&);
template void apply_similarity(const Similarity<2>&, Shape<2>&);
template void apply_similarity(const Similarity<3>&, Shape<3>&);

}  // namespace shellmatch
