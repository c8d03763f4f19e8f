#include "matching/run_gradient_check.h"

#include "base/error.h"
#include "base/parallel.h"
#include "matching/cascade/schedule.h"
#include "matching/map_file/deformation_file.h"
#include "matching/level/shape_fields.h"
#include "matching/input/shape_pair.h"
#include "matching/experiment/yaml_options.h"
#include "matching/alignment/known_pairs.h"
#include "matching/alignment/prepare_pair.h"
#include "matching/pairs/coverage.h"
#include "matching/pairs/landmark_file.h"

#include <algorithm>
#include <utility>

namespace shellmatch {

namespace {

template <int Dim>
bool same_place(const Similarity<Dim>& a, const Similarity<Dim>& b) {
  return std::abs(a.scale - b.scale) <= 1e-9 * b.scale && (a.offset - b.offset).norm() <= 1e-9 * (1 + b.offset.norm());
}

template <int Dim>
bool same_frame(const MapFrame<Dim>& a, const MapFrame<Dim>& b) {
  return a.is_backward == b.is_backward && same_place(a.placement, b.placement) && same_place(a.pose, b.pose);
}

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
  if (found) return check(found->grid.finest_level(), fmt::format("{}: a deformation of level {}", request.state.folder,
                                                                  found->grid.finest_level()));
  return std::clamp(Dim == 2 ? 7 : 5, least, most);
}

template <int Dim>
GradientReport check(const ExperimentOptions& options, const GradientCheckRequest& request, ShapePair<Dim> shapes,
                     Observer& observer) {
  auto landmarks = read_landmarks<Dim>(options.landmarks, shapes.reference.original.vertices,
                                       shapes.template_shape.original.vertices, landmark_spaces(shapes));
  const PreparedPair<Dim> prepared = prepare_pair(shapes, landmarks, options, observer);
  if (prepared.is_backward()) {  // the energy is that of the map from template to reference
    std::swap(shapes.reference, shapes.template_shape);
    landmarks = exchanged(std::move(landmarks));
  }
  std::optional<Deformation<Dim>> found;
  if (request.state.kind == CheckState::Kind::folder) {
    found = read_deformation<Dim>(request.state.folder);
    if (!same_frame<Dim>(*found, prepared.frame()))
      throw_input_error("--state {}: was found for shapes that lie elsewhere in the domain than those of this experiment, or in the other "
                        "direction (align.direction)", request.state.folder);
  }
  const int level_number = level_of(options, request, found);

  observer.stage("coefficients");
  const SignedDistance<Dim> d1(shapes.reference.surface), d2(shapes.template_shape.surface);
  ShapeFields<Dim> fields(d1, d2, options);
  Octree<Dim> grid(options.cascade.min_level);
  fields.compute_distances(grid);
  for (int l = options.cascade.min_level; l < level_number; ++l) {
    observer.stage(fmt::format("level {}", l + 1));
    fields.refine(grid);
    fields.compute_distances(grid);
  }
  LevelEnergy<Dim> level(grid, fields.geometry(grid), options,
                         known_pairs(landmarks, prepared.alignment, options, prepared.placement, d1, d2));
  const std::vector<Vec<Dim>> phi = positions_of(request.state, level, options.energy, found);
  const ScheduleStep step = schedule_of_level(options.cascade, level_number).back();
  if (level.coverage && level.covers(options)) {
    const Coverage<Dim> coverage(shapes.reference.surface, shapes.template_shape.surface, options.coverage);
    level.energy.replace_pairs(*level.coverage, PairTerm<Dim>(grid, coverage.pairs(grid, phi)));
  }
  const TermValues weights = level.weights(options, step.nu, step.volume_weight);
  GradientReport report = check_gradient<Dim>(level, CheckedEnergy<Dim>(level), phi, weights, request.settings,
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
  AnyShapePair shapes = open_shape_pair(options.input, observer);
  return std::visit([&]<int Dim>(ShapePair<Dim>& pair) { return check<Dim>(options, request, std::move(pair), observer); },
                    shapes);
}

}  // namespace shellmatch
