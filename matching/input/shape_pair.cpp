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
  return ShapePair<3>{std::get<1>(std::move(reference)), std::get<1>(std::move(template_shape))};
}

template struct ShapePair<2>;
template struct ShapePair<3>;

}  // namespace shellmatch
