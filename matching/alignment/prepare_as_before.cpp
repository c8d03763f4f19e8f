#include "matching/alignment/prepare_as_before.h"

namespace shellmatch {

namespace {

// Diagonals. Parts of what lies farther from the surface that was bent, as the mean shape of a cohort from the one
// before it, may lie nearest to another limb, with which they would go.
constexpr double same_surface = 1e-3;

template <int Dim>
bool lies_inside(const Surface<Dim>& surface, const Similarity<Dim>& pose, const Similarity<Dim>& placement,
                 double clearance) {
  for (const auto& facet : surface.facets)
    for (const Index v : facet) {
      const Vec<Dim> x = placement(pose(surface.vertices[v]));
      if (!(x.minCoeff() >= clearance && x.maxCoeff() <= 1 - clearance)) return false;
    }
  return true;
}

}  // namespace

template <int Dim>
std::optional<PreparedPair<Dim>> prepare_as_before(ShapePair<Dim>& shapes, const MapFrame<Dim>& frame,
                                                   double clearance) {
  Shape<Dim>&moved = frame.is_backward ? shapes.template_shape : shapes.reference,
  &other = frame.is_backward ? shapes.reference : shapes.template_shape;
  if (frame.space != shapes.template_shape.original.space) return std::nullopt;
  Surface<Dim> bent = moved.surface;
  if (frame.bend) {
    if (frame.bend->farthest(bent) > same_surface * bounding_box(bent.vertices).diagonal()) return std::nullopt;
    frame.bend->apply(bent);
  }
  if (!lies_inside(bent, frame.pose, frame.placement, clearance) ||
      !lies_inside<Dim>(other.surface, {}, frame.placement, clearance))
    return std::nullopt;
  PreparedPair<Dim> pair;
  if (frame.bend) {
    pair.unbent = transformed(moved.surface, frame.pose, frame.placement);
    frame.bend->apply(moved);
  }
  if (!frame.pose.is_identity()) apply_similarity(frame.pose, moved);
  for (Shape<Dim>* shape : {&moved, &other}) apply_similarity(frame.placement, *shape);
  if (frame.is_backward) pair.direction = DirectionSummary{.backward = true};
  pair.alignment.pose = frame.pose;
  pair.alignment.bend = frame.bend;
  pair.placement = frame.placement;
  pair.space = frame.space;
  return pair;
}

SHELLMATCH_2D_3D(prepare_as_before);

}  // namespace shellmatch
