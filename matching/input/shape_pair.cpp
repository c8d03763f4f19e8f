#include "matching/input/shape_pair.h"

#include "base/error.h"
#include "geometry/distance/buried_parts.h"
#include "geometry/io/picture_height.h"
#include "matching/input/downward_outline.h"
#include "matching/pairs/point_frame.h"

#include <optional>
#include <utility>

namespace shellmatch {

namespace {

// The frame of volumes: the user's word, or that of a mesh that names one.
Space space_of_volumes(const InputOptions& input, const std::array<std::optional<AnyShape>, 2>& meshes) {
  if (input.space != SpaceKind::automatic) return wanted_space(input);
  for (const std::optional<AnyShape>& shape : meshes) {
    if (!shape || shape->index() != 1) continue;
    if (std::get<1>(*shape).original.space != Space::unsaid) return std::get<1>(*shape).original.space;
  }
  return default_space;
}

// The frame of a mesh that names none: the user's word, or that in which 3D Slicer's points lie on it.
void settle_space(Shape<3>& shape, const InputOptions& input, const std::string& points, Observer& observer) {
  Space& space = shape.original.space;
  if (space != Space::unsaid) return;
  if (input.space != SpaceKind::automatic) {
    space = wanted_space(input);
    observer.note(fmt::format("{}: names no frame; {} by input.space", shape.source, space_name(space)));
    return;
  }
  if (!is_slicer_file(points)) return;
  space = frame_of_points(shape.surface, read_slicer_points(points));
  if (space != Space::unsaid)
    observer.note(fmt::format("{}: names no frame; taken to be {}, in which the points of {} lie on it", shape.source,
                              space_name(space), points));
}

// Both shapes; volumes last, as meshes may name the frame.
std::pair<AnyShape, AnyShape> open_both(std::array<ShapeInput, 2> sources, const InputOptions& input,
                                        const LandmarkOptions& landmarks, Observer& observer) {
  std::array<std::optional<AnyShape>, 2> shapes;
  const std::array points = {landmarks.file, landmarks.template_file};
  for (std::size_t i = 0; i < 2; ++i) {
    if (sources[i].is_volume()) continue;
    shapes[i] = open_shape(std::move(sources[i]), input.close);
    if (auto* mesh = std::get_if<1>(&*shapes[i])) settle_space(*mesh, input, points[i], observer);
  }
  const Space space = space_of_volumes(input, shapes);
  for (std::size_t i = 0; i < 2; ++i)
    if (!shapes[i]) shapes[i] = open_shape(std::move(sources[i]), input.close, space);
  return {std::move(*shapes[0]), std::move(*shapes[1])};
}

// An outline and the picture that it was drawn in, whose rows programs count downward.
void share_picture_frame(ShapePair<2>& pair, bool are_files, Observer& observer) {
  if (!are_files) return;
  Shape<2>&reference = pair.reference, &template_shape = pair.template_shape;
  const double height = picture_height(reference.source), other_height = picture_height(template_shape.source);
  if ((height > 0) == (other_height > 0)) return;
  const std::string note = height > 0 ? turn_downward_outline(template_shape, reference, height)
                                      : turn_downward_outline(reference, template_shape, other_height);
  if (!note.empty()) observer.note(note);
}

// Where nothing else tells the frame, that which 3D Slicer gives to meshes.
void take_slicers_space(ShapePair<3>& pair, const LandmarkOptions& landmarks, Observer& observer) {
  Space &reference = pair.reference.original.space, &template_shape = pair.template_shape.original.space;
  if (reference != Space::unsaid || template_shape != Space::unsaid) return;
  if (!is_slicer_file(landmarks.file) && !is_slicer_file(landmarks.template_file)) return;
  reference = template_shape = slicer_default_space;
  observer.note(
      fmt::format("{}, {}: name no frame, and their points do not tell it; taken to be {}, as 3D Slicer does (--set "
                  "input.space=ras takes the other)",
                  pair.reference.source, pair.template_shape.source, space_name(slicer_default_space)));
}

}  // namespace

template <int Dim>
Similarity<Dim> ShapePair<Dim>::place(const ExperimentOptions& options, const Similarity<Dim>& pose,
                                      const SurfaceBend<Dim>* bend) {
  if (bend != nullptr) bend->apply(reference);
  if (!pose.is_identity()) apply_similarity(pose, reference);
  const double clearance = 1.0 / static_cast<double>(1 << options.cascade.max_level);
  const Similarity<Dim> placement = options.input.placement == PlacementKind::fit
                                        ? fit_placement(reference, template_shape, options.input.margin)
                                        : as_is_placement(reference, template_shape, clearance);
  apply_similarity(placement, reference);
  apply_similarity(placement, template_shape);
  return placement;
}

template <int Dim>
void share_space(ShapePair<Dim>& pair, Observer& observer) {
  OriginalShape<Dim>&reference = pair.reference.original, &template_shape = pair.template_shape.original;
  const auto adopt = [&](const Shape<Dim>& silent, const Shape<Dim>& other) {
    observer.note(fmt::format("{}: names no frame; taken to be {}, as {} is", silent.source,
                              space_name(other.original.space), other.source));
    return other.original.space;
  };
  if (reference.space == Space::unsaid && template_shape.space != Space::unsaid)
    reference.space = adopt(pair.reference, pair.template_shape);
  if (template_shape.space == Space::unsaid && reference.space != Space::unsaid)
    template_shape.space = adopt(pair.template_shape, pair.reference);
  pair.reference_file_space = reference.space;
  if constexpr (Dim == 3) {
    // A turn by half a circle about the z axis: facets stay outward.
    if (!change_space(reference.vertices, reference.space, template_shape.space)) return;
    for (Surface<3>* surface :
         {&pair.reference.surface, &pair.reference.evidence.observed, &pair.reference.evidence.unobserved})
      change_space(surface->vertices, reference.space, template_shape.space);
    observer.note(fmt::format("{}: from {} to {}, the frame of {}: x and y change their sign", pair.reference.source,
                              space_name(reference.space), space_name(template_shape.space),
                              pair.template_shape.source));
    reference.space = template_shape.space;
  }
}

template <int Dim>
void leave_out_buried(ShapePair<Dim>& pair, const InputOptions& input, Observer& observer) {
  if constexpr (Dim == 3) {  // outlines that cross themselves are refused
    if (input.buried == Burial::kept) return;
    for (Shape<3>* shape : {&pair.reference, &pair.template_shape}) {
      const BuriedParts parts = buried_parts(shape->surface, shape->crossing);
      if (parts.facets.empty()) continue;
      shape->evidence = without_buried(shape->surface, shape->evidence, parts.facets);
      shape->buried_share = parts.share;
      observer.note(
          fmt::format("{}: {:.2g} % of the area lies inside other parts, up to {:.2g} deep: that part weighs nothing "
                      "(--set input.buried=keep "
                      "matches it)",
                      shape->source, 100 * parts.share, parts.depth));
    }
  }
}

AnyShapePair open_shape_pair(const InputOptions& input, const LandmarkOptions& landmarks, Observer& observer) {
  return open_shape_pair({ShapeInput{input.reference}, ShapeInput{input.template_file}}, input, landmarks, observer);
}

AnyShapePair open_shape_pair(std::array<ShapeInput, 2> shapes, const InputOptions& input,
                             const LandmarkOptions& landmarks, Observer& observer) {
  const std::array<std::string, 2> names{shapes[0].name, shapes[1].name};
  const bool are_files = shapes[0].contents.index() == 0 && shapes[1].contents.index() == 0;
  auto [reference, template_shape] = open_both(std::move(shapes), input, landmarks, observer);
  for (const AnyShape* shape : {&reference, &template_shape})
    std::visit(
        [&](const auto& s) {
          for (const std::string& n : s.notes) observer.note(fmt::format("{}: {}", s.source, n));
        },
        *shape);
  if (reference.index() != template_shape.index())
    throw_input_error("{} is {}-dimensional and {} is {}-dimensional; both shapes must have the same dimension",
                      names[0], reference.index() + 2, names[1], template_shape.index() + 2);
  if (reference.index() == 0) {
    ShapePair<2> pair{std::get<0>(std::move(reference)), std::get<0>(std::move(template_shape))};
    share_picture_frame(pair, are_files, observer);
    return pair;
  }
  ShapePair<3> pair{std::get<1>(std::move(reference)), std::get<1>(std::move(template_shape))};
  take_slicers_space(pair, landmarks, observer);
  share_space(pair, observer);
  leave_out_buried(pair, input, observer);
  return pair;
}

template struct ShapePair<2>;
template struct ShapePair<3>;
SHELLMATCH_2D_3D(leave_out_buried);
SHELLMATCH_2D_3D(share_space);

}  // namespace shellmatch
