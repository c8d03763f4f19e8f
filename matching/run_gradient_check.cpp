#include "matching/run_gradient_check.h"

#include "base/error.h"
#include "base/parallel.h"
#include "matching/map_file/deformation_file.h"
#include "matching/experiment/yaml_options.h"
#include "matching/pair_level.h"
#include "matching/pairs/landmark_file.h"

#include <algorithm>
#include <utility>

namespace shellmatch {

namespace {

template <int Dim>
int level_of(const ExperimentOptions& options, const GradientCheckRequest& request,
             const std::optional<Deformation<Dim>>& found) {
  const auto [least, most] = std::pair(options.cascade.min_level, options.cascade.max_level);
  const auto check = [&](int level, const std::string& origin) {
    if (level < least || level > most)
      throw_input_error("{}: the cascade of this experiment has the levels {} to {}", origin, least, most);
    return level;
  };
  if (request.level) return check(*request.level, fmt::format("--level {}", *request.level));
  if (found)
    return check(found->grid.finest_level(),
                 fmt::format("{}: a deformation of level {}", request.state.folder, found->grid.finest_level()));
  return std::clamp(Dim == 2 ? 7 : 5, least, most);
}

template <int Dim>
GradientReport check(const ExperimentOptions& options, const GradientCheckRequest& request, ShapePair<Dim> shapes,
                     Observer& observer) {
  auto landmarks = read_landmarks<Dim>(options.landmarks, shapes.reference.original.vertices,
                                       shapes.template_shape.original.vertices, landmark_spaces(shapes));
  std::optional<Deformation<Dim>> found;
  if (request.state.kind == CheckState::Kind::folder) found = read_deformation<Dim>(request.state.folder);
  PairLevel<Dim> level(std::move(shapes), std::move(landmarks), options, level_of(options, request, found), observer,
                       [&](const MapFrame<Dim>& frame) {
                         if (found && !same_frame<Dim>(*found, frame))
                           throw_input_error(
                               "--state {}: was found for shapes that lie elsewhere in the domain than those of this "
                               "experiment, or in the other "
                               "direction (align.direction)",
                               request.state.folder);
                       });
  const std::vector<Vec<Dim>> phi = positions_of(request.state, level.energy(), options.energy, found);
  level.energy().refresh(phi);
  const ScheduleStep step = level.step();
  GradientReport report =
      check_gradient<Dim>(level.energy(), CheckedEnergy<Dim>(level.energy()), phi, level.weights(), request.settings,
                          [&](const std::string& term) { observer.stage(fmt::format("checking {}", term)); });
  report.state = request.state.text();
  report.nu = step.nu;
  report.volume_weight = step.volume_weight;
  return report;
}

}  // namespace

GradientReport run_gradient_check(const ExperimentOptions& options, const GradientCheckRequest& request,
                                  Observer& observer) {
  check_experiment(options);
  set_n_threads(options.threads);
  observer.stage("reading");
  AnyShapePair shapes = open_shape_pair(options.input, options.landmarks, observer);
  return std::visit(
      [&]<int Dim>(ShapePair<Dim>& pair) { return check<Dim>(options, request, std::move(pair), observer); }, shapes);
}

}  // namespace shellmatch
