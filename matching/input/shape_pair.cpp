#include "matching/input/shape_pair.h"

#include "base/error.h"
#include "geometry/volume/declared_space.h"
#include "geometry/volume/volume_name.h"
#include "matching/input/shape_source.h"

namespace shellmatch {

namespace {

std::string_view name_of(Space space) { return space == Space::lps ? "LPS" : "RAS"; }

// The frame of volumes: the user's word, or that of a mesh.
Space chosen_space(const InputOptions& input, Observer& observer) {
  std::optional<Space> chosen;
  if (input.space != SpaceKind::automatic) chosen = input.space == SpaceKind::lps ? Space::lps : Space::ras;
  for (const std::string* file : {&input.reference, &input.template_file}) {
    if (parse_volume_name(*file)) continue;
    const std::optional<Space> declared = declared_space(*file);
    if (declared && chosen && *declared != *chosen)
      observer.note(fmt::format("{}: says that it is in {}; it is taken as it is, beside what is in {}", *file, name_of(*declared), name_of(*chosen)));
    if (!chosen) chosen = declared;
  }
  return chosen.value_or(Space::ras);
}

}  // namespace

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
  const Space space = chosen_space(input, observer);
  AnyShape reference = open_shape(input.reference, space);
  AnyShape template_shape = open_shape(input.template_file, space);
  for (const AnyShape* shape : {&reference, &template_shape})
    std::visit([&](const auto& s) {
      for (const std::string& n : s.notes) observer.note(fmt::format("{}: {}", s.source, n));
    }, *shape);
  if (reference.index() != template_shape.index())
    throw_input_error("{} is {}-dimensional and {} is {}-dimensional; both shapes must have the same dimension",
                      input.reference, reference.index() + 2, input.template_file, template_shape.index() + 2);
  if (reference.index() == 0)
    return ShapePair<2>{std::get<0>(std::move(reference)), std::get<0>(std::move(template_shape)), space};
  return ShapePair<3>{std::get<1>(std::move(reference)), std::get<1>(std::move(template_shape)), space};
}

template struct ShapePair<2>;
template struct ShapePair<3>;

}  // namespace shellmatch
