#include "matching/input/shape_pair.h"

#include "base/error.h"
#include "matching/input/shape_source.h"

namespace shellmatch {

template <int Dim>
Similarity<Dim> ShapePair<Dim>::place(const ExperimentOptions& options, const Similarity<Dim>& pose) {
  if (!pose.is_identity()) apply_placement(pose, reference.surface);
  const double clearance = 1.0 / static_cast<double>(1 << options.cascade.max_level);
  const Similarity<Dim> placement = options.input.placement == PlacementKind::fit
                                        ? fit_placement(reference, template_shape, options.input.margin)
                                        : as_is_placement(reference, template_shape, clearance);
  apply_placement(placement, reference.surface);
  apply_placement(placement, template_shape.surface);
  return placement;
}

template <int Dim>
void share_space(ShapePair<Dim>& pair, Observer& observer) {
  OriginalShape<Dim>&reference = pair.reference.original, &template_shape = pair.template_shape.original;
  const auto adopt = [&](const Shape<Dim>& silent, const Shape<Dim>& other) {
    observer.note(fmt::format("{}: names no frame; taken to be {}, as {} is", silent.source, space_name(other.original.space), other.source));
    return other.original.space;
  };
  if (reference.space == Space::unsaid && template_shape.space != Space::unsaid) reference.space = adopt(pair.reference, pair.template_shape);
  if (template_shape.space == Space::unsaid && reference.space != Space::unsaid) template_shape.space = adopt(pair.template_shape, pair.reference);
  pair.reference_file_space = reference.space;
  if constexpr (Dim == 3) {
    // A turn by half a circle about the z axis: facets stay outward.
    if (!change_space(reference.vertices, reference.space, template_shape.space)) return;
    change_space(pair.reference.surface.vertices, reference.space, template_shape.space);
    observer.note(fmt::format("{}: from {} to {}, the frame of {}: x and y change their sign", pair.reference.source,
                              space_name(reference.space), space_name(template_shape.space), pair.template_shape.source));
    reference.space = template_shape.space;
  }
}

AnyShapePair open_shape_pair(const InputOptions& input, Observer& observer) {
  AnyShape reference = open_shape(input.reference, input.close);
  AnyShape template_shape = open_shape(input.template_file, input.close);
  for (const AnyShape* shape : {&reference, &template_shape})
    std::visit([&](const auto& s) {
      for (const std::string& n : s.notes) observer.note(fmt::format("{}: {}", s.source, n));
    }, *shape);
  if (reference.index() != template_shape.index())
    throw_input_error("{} is {}-dimensional and {} is {}-dimensional; both shapes must have the same dimension",
                      input.reference, reference.index() + 2, input.template_file, template_shape.index() + 2);
  if (reference.index() == 0)
    return ShapePair<2>{std::get<0>(std::move(reference)), std::get<0>(std::move(template_shape))};
  ShapePair<3> pair{std::get<1>(std::move(reference)), std::get<1>(std::move(template_shape))};
  share_space(pair, observer);
  return pair;
}

template struct ShapePair<2>;
template struct ShapePair<3>;
template void share_space<2>(ShapePair<2>&, Observer&);
template void share_space<3>(ShapePair<3>&, Observer&);

}  // namespace shellmatch
