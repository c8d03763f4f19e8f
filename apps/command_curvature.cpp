// `curvature`: compares the curvatures that grids resolve of a shape with those of its mesh and with formulas.

#include "apps/commands.h"
#include "apps/experiment_overrides.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/progress.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/surface/placement.h"
#include "matching/shape_report/curvature_report.h"
#include "matching/write_result.h"
#include "matching/experiment/generated_source.h"
#include "matching/output/output_folder.h"
#include "matching/output/write_file.h"
#include "matching/input/shape_source.h"
#include "matching/cascade/size_estimate.h"
#include "matching/experiment/yaml_options.h"

#include <cmath>
#include <filesystem>
#include <iostream>

namespace shellmatch {

namespace {

template <int Dim>
std::optional<ExactShape<Dim>> formula_of(const std::string& source) {
  if (!is_generated_source(source)) return std::nullopt;
  const auto shape = generated_formula(source);
  if (!shape) return std::nullopt;
  return std::get<ExactShape<Dim>>(*shape);
}

template <int Dim>
void compare(const Shape<Dim>& shape, const ExperimentOptions& options, const CurvatureCommand& command,
             const MeshFit& fit) {
  const bool quiet = command.settings.verbosity == Verbosity::quiet;
  check_inputs_outlive(command.settings.output, {{shape.source}});
  OutputFolder folder(command.settings.output, command.settings.force);
  const double scale =
      options.input.placement == PlacementKind::fit ? fit_placement(shape, shape, options.input.margin).scale : 1;
  check_size<Dim>({.phi = surface_measure(shape.surface) * std::pow(scale, Dim - 1)}, options.cascade.min_level,
                  options.cascade.max_level, folder.final_path());
  const auto comparison =
      compare_curvatures<Dim>(shape, formula_of<Dim>(shape.source), options, fit, [&](const CurvatureLevel& l) {
        stop_if_wanted();
        if (!quiet) std::cerr << fmt::format("level {}: {} nodes\n", l.level, l.n_nodes);
      });
  const CurvatureSubject subject{shape.source, fit, options.coefficients};
  write_file(folder.path_of("summary.json"), curvature_json(comparison, subject));
  write_file(folder.path_of("config.yaml"), to_yaml(with_absolute_paths(options)));
  write_curvature_mesh(comparison, folder.path_of(Dim == 2 ? "curvature.csv" : "curvature.ply"));
  Progress progress(command.settings.verbosity, options.cascade.max_level);
  draw(folder, "pictures/scatter.png", progress,
       [&](const std::string& path) { write_curvature_scatter(comparison, path); });
  const std::string name =
      is_generated_source(shape.source) ? shape.source : std::filesystem::path(shape.source).filename().string();
  draw(folder, "pictures/curvature.png", progress, [&](const std::string& path) {
    write_curvature_picture(comparison, fmt::format("{}, level {}", name, options.cascade.max_level), path);
  });
  folder.commit();
  if (!quiet) std::cout << curvature_text(comparison, subject);
}

}  // namespace

void execute(const CurvatureCommand& command) {
  catch_interrupts();
  std::vector<Override> overrides = {{"input.reference", command.shape, "SHAPE"},
                                     {"input.template", command.shape, "SHAPE"}};
  for (Override& change : overrides_of(command.settings)) overrides.push_back(std::move(change));
  const ExperimentOptions options = make_experiment(overrides);
  const MeshFit defaults;
  const MeshFit fit{command.degree.empty() ? defaults.degree : whole_number(command.degree, "--degree", 2, 4),
                    command.rings.empty() ? defaults.n_rings : whole_number(command.rings, "--rings", 1, 10)};
  set_n_threads(options.threads);
  const AnyShape shape = open_shape(command.shape, options.input.close);
  std::visit(
      [&](const auto& s) {
        if (command.settings.verbosity != Verbosity::quiet)
          for (const std::string& note : s.notes) say_line(fmt::format("{}: {}", s.source, note));
        compare(s, options, command, fit);
      },
      shape);
}

}  // namespace shellmatch
