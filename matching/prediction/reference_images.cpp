#include "matching/prediction/reference_images.h"

#include "base/error.h"
#include "geometry/io/read_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace shellmatch {

namespace {

// Fewer vertices that face the template are no ground for anything.
constexpr std::size_t least_pairs = 10;
// Another pose has to end farther away by this factor.
constexpr double clear_prediction = 1.3;
// In diagonals of the template: about a cell of level 3, as wide as the band in which the cascade begins. A shape of
// which a part ends farther away may have limbs that belong elsewhere.
constexpr double most_apart = 0.125;

auto coordinates(const Vec<3>& x) { return std::tuple(x.x(), x.y(), x.z()); }

/// From the vertices of the file to those of the surface, which repair has joined, left out or added; those that it has
/// added are not a number.
std::vector<std::vector<Vec<3>>> on_surface(const Shape<3>& reference, const ReferenceImages<3>& images) {
  const std::vector<Vec<3>>& file = reference.original.vertices;
  std::vector<std::size_t> order(file.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto at = [&](std::size_t v) { return coordinates(file[v]); };
  std::ranges::stable_sort(order, {}, at);
  const Vec<3> none = Vec<3>::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<std::vector<Vec<3>>> result(images.size());
  for (const Vec<3>& x : reference.surface.vertices) {
    const auto found = std::ranges::lower_bound(order, coordinates(x), {}, at);
    const bool is_there = found != order.end() && at(*found) == coordinates(x);
    for (std::size_t i = 0; i < images.size(); ++i) result[i].push_back(is_there ? images[i][*found] : none);
  }
  return result;
}

}  // namespace

template <int Dim>
ReferenceImages<Dim> read_reference_images(const std::vector<std::string>& folders, std::size_t n_vertices) {
  ReferenceImages<Dim> images;
  for (const std::string& folder : folders) {
    OriginalShape<Dim> deformed;
    try {
      if constexpr (Dim == 3) deformed = read_points_or_mesh_3d(folder + "/deformed.ply");
      else deformed = read_points_or_outline_2d(folder + "/deformed.csv");
    } catch (const InputError& error) {
      throw_input_error("start.images: {}; expected output folders of earlier runs", error.what());
    }
    if (deformed.vertices.size() != n_vertices)
      throw_input_error(
          "start.images: {}: has {} vertices where the reference has {}; expected runs with the same reference", folder,
          deformed.vertices.size(), n_vertices);
    images.push_back(std::move(deformed.vertices));
  }
  return images;
}

template <>
std::optional<PredictedPose> clear_pose<2>(const ShapePair<2>&, const ReferenceImages<2>&, const AlignmentOptions&,
                                           Observer&) {
  return std::nullopt;
}

template <>
std::optional<PredictedPose> clear_pose<3>(const ShapePair<3>& shapes, const ReferenceImages<3>& images,
                                           const AlignmentOptions& options, Observer& observer) {
  if (images.empty() || shapes.one_is_part()) return std::nullopt;
  const auto none = [&](const std::string& why) {
    observer.note(fmt::format("alignment: not predicted from {} earlier results: {}", images.size(), why));
    return std::optional<PredictedPose>();
  };
  PredictedPose found = predict_pose(shapes.reference.surface, on_surface(shapes.reference, images),
                                     shapes.template_shape.surface, options);
  if (found.pairs.size() < least_pairs) return none("their surfaces have nothing to face");
  if (!(found.margin >= clear_prediction))
    return none(fmt::format("another pose is nearly as good ({:.2f})", found.margin));
  if (!(found.farthest <= most_apart))
    return none(fmt::format("a part of them ends {:.2g} diagonals away", found.farthest));
  return found;
}

SHELLMATCH_2D_3D(read_reference_images);

}  // namespace shellmatch
