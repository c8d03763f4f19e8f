#include "matching/run_matching.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/io/write_shape.h"
#include "matching/cascade/cascade.h"
#include "matching/experiment/generated_source.h"
#include "matching/output/grid_picture.h"
#include "matching/derivative_check/gradient_report.h"
#include "matching/output/history_file.h"
#include "matching/checkpoint/checkpoints.h"
#include "matching/output/level_picture.h"
#include "matching/output/output_folder.h"
#include "matching/cascade/phase_clock.h"
#include "matching/output/process_info.h"
#include "matching/output/run_report.h"
#include "matching/experiment/shape_pair.h"
#include "matching/cascade/size_estimate.h"
#include "matching/experiment/yaml_options.h"
#include "render/canvas/plot.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <variant>

namespace shellmatch {

namespace {

/// Passes everything on and keeps the history.
class Recorder final : public Observer {
 public:
  explicit Recorder(Observer& next) : next_(next) {
    for (const auto& name : term_names()) history.term_names.emplace_back(name);
  }
  void note(const std::string& text) override { next_.note(text); }
  void phase(const std::string& name) override { next_.phase(name); }
  void level_started(const LevelStart& start) override {
    level = start.level;
    next_.level_started(start);
  }
  bool iterated(const LevelStart& start, const IterationRecord& record) override {
    history.rows.push_back({start.level, start.substep, start.nu, record});
    return next_.iterated(start, record);
  }
  void gradient_checked(const LevelStart& start, const GradientReport& report) override {
    GradientCheckSummary s{start.level, start.substep, report.iteration, report.passed(), report.failed_terms()};
    for (const TermCheck& t : report.terms) {
      s.worst_functor_error = std::max(s.worst_functor_error, t.gradient_error);
      for (const DirectionCheck& d : t.directions)
        for (const double order : d.orders)
          if (std::abs(order - 2) > std::abs(s.worst_order - 2)) s.worst_order = order;
    }
    gradient_checks.push_back(std::move(s));
    next_.gradient_checked(start, report);
  }
  void level_finished(const LevelStart& start, const MinimizerSummary& summary) override {
    next_.level_finished(start, summary);
  }
  History history;
  std::vector<GradientCheckSummary> gradient_checks;
  int level = 0;  // the one that was started last; 0 is none

 private:
  Observer& next_;
};

template <int Dim>
double measure(const Surface<Dim>& s) {
  double sum = 0;
  for (std::size_t f = 0; f < s.facets.size(); ++f) sum += facet_measure(s, static_cast<Index>(f));
  return sum;
}

ShapeSummary shape_summary(const auto& shape) {
  return {shape.source, shape.surface.vertices.size(), shape.surface.facets.size(), shape.notes};
}

/// One run, from the shapes as read to the output folder.
template <int Dim>
class Run {
 public:
  Run(const ExperimentOptions& options, ShapePair<Dim> shapes, OutputFolder& folder, Observer& observer,
      PhaseSeconds seconds)
      : options_(options),
        shapes_(std::move(shapes)),
        folder_(folder),
        recorder_(observer),
        seconds_(std::move(seconds)),
        seconds_before_(seconds_["reading"]) {}

  void go(bool restart) {
    try {
      match(restart);
    } catch (const Stopped&) {
      throw Stopped(stopped_text());
    }
  }

 private:
  void match(bool restart) {
    placement_ = shapes_.place(options_);
    const double first = measure(reference_.surface), both = first + measure(template_.surface);
    const bool smooth = options_.coefficients.interpolation == FieldInterpolation::smooth;
    check_size<Dim>({.phi = refines_at_template(options_) ? both : first, .fields = smooth ? both : 0},
                    options_.cascade.min_level, options_.cascade.max_level, folder_.final_path());
    const SignedDistance<Dim> d1(reference_.surface), d2(template_.surface);
    const InputOptions& input = options_.input;
    const Correspondence<Dim> truth =
        input.correspondence.empty()
            ? generated_correspondence<Dim>(input.reference, input.template_file)
            : read_correspondence<Dim>(input.correspondence, reference_.original.vertices.size());
    summary_.distance_before = two_sided_distance(reference_.surface, d2);

    std::optional<FinishedLevel<Dim>> before;
    if (options_.resume.enabled) {
      keeper_.emplace(folder_.final_path(), run_identity(options_, reference_.surface, template_.surface));
      if (keeper_->is_foreign()) {
        recorder_.note(fmt::format("{}: no run has written this, and it is left alone: levels are not kept for the case "
                                   "that this run is stopped", keeper_->path()));
        keeper_.reset();
      } else if (!restart) {
        before = take_up();
      }
    }
    recorder_.phase("matching");
    auto result = run_cascade<Dim>(d1, d2, options_, recorder_,
                                   [&](const LevelResult& level, const LevelState<Dim>& state) { finish_level(level, state, d2); },
                                   seconds_, std::move(before));
    summary_.interrupted = result.interrupted;
    writing_ = true;
    recorder_.phase("writing");
    PhaseClock clock(seconds_);
    clock.start("output");
    write(result, d2, truth);
    clock.stop();
    write_summary(complete_summary(), folder_.path_of("summary.json"));
    folder_.commit();
    if (keeper_ && !result.interrupted) keeper_->remove();
  }

  // Goes on where an earlier run was, if there is one and it is the same experiment.
  std::optional<FinishedLevel<Dim>> take_up() {
    std::string obstacle = keeper_->obstacle();
    std::optional<KeptLevels<Dim>> kept;
    try {
      if (obstacle.empty()) kept = keeper_->read<Dim>();
    } catch (const InputError& error) {
      obstacle = fmt::format("it cannot be read ({})", error.what());
    }
    if (!obstacle.empty())
      recorder_.note(fmt::format("{}: {}; the run begins anew and replaces that folder once it keeps a level",
                                 keeper_->path(), obstacle));
    if (!kept) return std::nullopt;
    MatchSummary& s = kept->summary;
    kept_level_ = s.levels.back().level;
    recorder_.note(fmt::format("going on after level {}, kept in {} ({:.3g} s of work)", kept_level_, keeper_->path(),
                               s.run.seconds));
    recorder_.history = std::move(kept->history);
    recorder_.gradient_checks = s.gradient_checks.value_or(std::vector<GradientCheckSummary>{});
    summary_.levels = std::move(s.levels);
    summary_.run = std::move(s.run);
    for (const auto& [phase, t] : summary_.run.phase_seconds) seconds_[phase] += t;
    seconds_before_ += summary_.run.seconds;
    summary_.run.resumed_after = summary_.run.resumed_after.value_or(std::vector<int>{});
    summary_.run.resumed_after->push_back(kept_level_);
    keeper_->copy_pictures(folder_.path_of("pictures"));
    return FinishedLevel<Dim>{kept_level_, std::move(kept->deformation)};
  }

  // A run that cannot keep a level goes on all the same: it may never be stopped.
  void keep(const LevelResult& level, const LevelState<Dim>& state) {
    if (!keeper_ || level.last.reason == StopReason::interrupted) return;
    const double begin = seconds();
    if (begin - last_kept_ < options_.resume.min_seconds) return;
    MatchSummary s = complete_summary();
    s.interrupted = true;
    s.distance = s.levels.back().distance;
    try {
      keeper_->keep<Dim>({state.grid, state.phi, placement_, recorder_.history, s}, folder_.path_of("pictures"));
      kept_level_ = level.start.level;
    } catch (const InputError& error) {
      cannot_keep(level.start.level, error.what());
    } catch (const EnvironmentError& error) {
      cannot_keep(level.start.level, error.what());
    }
    last_kept_ = seconds();
    seconds_["keeping"] += last_kept_ - begin;
    seconds_["output"] -= last_kept_ - begin;  // whose clock is running
  }

  void cannot_keep(int level, const std::string& why) {
    recorder_.note(fmt::format("level {} is not kept for the case that the run is stopped: {}", level, why));
  }

  std::string stopped_text() const {
    const std::string where = writing_               ? "while the result was written"
                              : recorder_.level == 0 ? "before the first level"
                                                     : fmt::format("in level {} of {}", recorder_.level,
                                                                   options_.cascade.max_level);
    if (kept_level_ == 0) return fmt::format("stopped {}; nothing was written", where);
    return fmt::format("stopped {}; level {} is kept in {}: the same command goes on from there", where, kept_level_,
                       keeper_->path());
  }

  // Of this process, since the shapes were read.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  void finish_level(const LevelResult& level, const LevelState<Dim>& state, const SignedDistance<Dim>& d2) {
    LevelSummary s = level_summary(level, recorder_.history.rows.empty() ? IterationRecord{} : recorder_.history.rows.back().record);
    const Surface<Dim> deformed = deformed_surface(reference_.surface, state.grid, state.phi);
    s.distance = two_sided_distance(
        deformed_surface(subdivided(reference_.surface, state.grid.finest_side()), state.grid, state.phi), d2);
    summary_.levels.push_back(s);
    summary_.run.level_seconds.push_back(level.seconds);
    if (options_.pictures == Pictures::all)
      picture(deformed, state, d2, fmt::format("level {}", level.start.level), level_picture_name(level.start.level),
              true);
    keep(level, state);
  }

  void picture(const Surface<Dim>& deformed, const LevelState<Dim>& state, const SignedDistance<Dim>& d2,
               const std::string& title, const std::string& name, bool draft) {
    LevelPicture<Dim> p;
    p.draft = draft;
    p.reference = &reference_.surface;
    p.template_shape = &template_.surface;
    p.deformed = &deformed;
    p.title = title;
    p.distance = distances_to(deformed.vertices, d2);
    if constexpr (Dim == 2) {
      p.grid = &state.grid;
      p.phi = &state.phi;
    }
    write_level_picture(p, folder_.path_of(name));
    if constexpr (Dim == 3) (void)state;
  }

  void write(CascadeResult<Dim>& result, const SignedDistance<Dim>& d2, const Correspondence<Dim>& truth) {
    const Surface<Dim> deformed = deformed_surface(reference_.surface, result.grid, result.phi);
    summary_.distance = summary_.levels.back().distance;
    add_distortion(summary_, reference_.surface, deformed, d2);
    if (options_.pictures != Pictures::none) {
      picture(deformed, {result.grid, result.phi}, d2, "", "pictures/result.png", false);
      if constexpr (Dim == 3)
        write_grid_picture(result.grid, reference_.surface, template_.surface, "", folder_.path_of("pictures/grid.png"));
    }

    const auto cells = cell_fields(result.grid, result.phi, result.reference.distance, summary_.levels.back().sigma);
    const Deformation<Dim> deformation{std::move(result.grid), std::move(result.phi), placement_};
    const OriginalShape<Dim> moved = deformed_original(reference_.original, deformation, d2);
    if constexpr (Dim == 3) write_ply(folder_.path_of("deformed.ply"), moved);
    else write_outline_csv(folder_.path_of("deformed.csv"), moved);
    write_deformation(folder_.path_of(deformation_file_name), deformation,
                      nodal_fields(result.reference, result.target, options_), cells);
    if (!truth.empty()) {
      const double diagonal = bounding_box(template_.original.vertices).diagonal();
      summary_.correspondence_error_before = correspondence_error(truth, reference_.original.vertices) / diagonal;
      summary_.correspondence_error = correspondence_error(truth, moved.vertices) / diagonal;
    }
    write_history(recorder_.history, folder_.path_of("history.csv"));
    if (options_.pictures != Pictures::none)
      write_plot(energy_plot(recorder_.history), folder_.path_of("pictures/energy.png"));
    write_file(folder_.path_of("config.yaml"), to_yaml(with_absolute_paths(options_)));
  }

  // With all that is known so far.
  MatchSummary complete_summary() const {
    MatchSummary s = summary_;
    s.version = program_version();
    s.profile = enum_name(options_.profile);
    s.dimension = Dim;
    s.reference = shape_summary(reference_);
    s.template_shape = shape_summary(template_);
    s.placement = {std::string(enum_name(options_.input.placement)), placement_.scale,
                   {placement_.offset.begin(), placement_.offset.end()}};
    if (options_.check_gradient.every > 0) s.gradient_checks = recorder_.gradient_checks;
    s.run.compiler = compiler_name();
    s.run.threads = n_threads();
    s.run.seconds = seconds() + seconds_before_;
    s.run.phase_seconds = {seconds_.begin(), seconds_.end()};
    s.run.peak_memory_bytes = std::max(s.run.peak_memory_bytes, peak_memory_bytes());
    return s;
  }

  const ExperimentOptions& options_;
  ShapePair<Dim> shapes_;
  const Shape<Dim>&reference_ = shapes_.reference, &template_ = shapes_.template_shape;
  OutputFolder& folder_;
  Recorder recorder_;
  PhaseSeconds seconds_;
  double seconds_before_;  // for reading and by earlier runs that this one goes on from
  Similarity<Dim> placement_;
  MatchSummary summary_;
  std::optional<LevelKeeper> keeper_;
  int kept_level_ = 0;  // 0 is none
  double last_kept_ = 0;
  bool writing_ = false;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

void run_matching(const ExperimentOptions& options, const std::string& output_folder, const EarlierRuns& earlier,
                  Observer& observer) {
  set_n_threads(options.threads);
  PhaseSeconds seconds;
  PhaseClock clock(seconds);
  observer.phase("reading");
  clock.start("reading");
  AnyShapePair shapes = open_shape_pair(options.input, observer);
  clock.stop();
  OutputFolder folder(output_folder, earlier.force);
  std::visit([&]<int Dim>(ShapePair<Dim>& pair) {
    Run<Dim>(options, std::move(pair), folder, observer, seconds).go(earlier.restart);
  }, shapes);
}

}  // namespace shellmatch
