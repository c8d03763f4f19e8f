#include "matching/run_matching.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/distance/surface_distance.h"
#include "matching/alignment/prepare_as_before.h"
#include "matching/cascade/level_memory.h"
#include "matching/cascade/size_estimate.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/yaml_options.h"
#include "matching/map_file/deformation_file.h"
#include "matching/match_placed_shapes.h"
#include "matching/pairs/landmark_file.h"
#include "matching/prediction/reference_images.h"
#include "matching/output/summary.h"
#include "matching/pictures/level_picture.h"
#include "matching/progress/process_info.h"
#include "matching/run_checkpoints.h"
#include "matching/write_result.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <utility>
#include <variant>

namespace shellmatch {

namespace {

/// One run, from the placed shapes to the output folder.
template <int Dim>
class Run {
 public:
  Run(const ExperimentOptions& options, ShapePair<Dim> shapes, OutputFolder& folder, Observer& observer,
      RunClock& clock)
      : options_(options),
        folder_(folder),
        recorder_(observer),
        clock_(clock),
        checkpoints_(options.resume, recorder_, clock) {
    inputs_.shapes = std::move(shapes);
  }

  MatchResult<Dim> go(bool restart) {
    try {
      return match(restart);
    } catch (const LevelTooLarge& stopped) {
      throw Stopped(fmt::format("{}: {}", stopped.what(), keep_and_tell()), stopped.cause());
    } catch (const Stopped& stopped) {
      throw Stopped(keep_and_tell(), stopped.cause());
    } catch (const MemoryError& want) {
      if (memory_limit_bytes() == 0) throw;
      throw Stopped(fmt::format("{}: {}", want.what(), keep_and_tell()), StopCause::memory_limit);
    } catch (const std::bad_alloc&) {
      if (memory_limit_bytes() > 0) throw Stopped(keep_and_tell(), StopCause::memory_limit);
      throw MemoryError(
          fmt::format("not enough memory: {}; a lower finest level (--levels) needs less", keep_and_tell()));
    }
  }

 private:
  MatchResult<Dim> match(bool restart) {
    std::vector<std::string> notes;
    inputs_.landmarks =
        read_landmarks<Dim>(options_.landmarks, inputs_.shapes.reference.original.vertices,
                            inputs_.shapes.template_shape.original.vertices, landmark_spaces(inputs_.shapes), &notes);
    for (const std::string& note : notes) recorder_.note(note);
    const InputOptions& input = options_.input;
    inputs_.truth =
        input.correspondence.empty()
            ? generated_correspondence<Dim>(input.reference, input.template_file)
            : read_correspondence<Dim>(input.correspondence, inputs_.shapes.reference.original.vertices.size());
    // A uniform grid of the coarsest level, which all grids hold: what cannot fit is refused before alignment tries
    // starts on it.
    check_size<Dim>({}, options_.cascade.min_level, options_.cascade.max_level, folder_.final_path());
    const Shape<Dim>&reference = inputs_.shapes.reference, &template_shape = inputs_.shapes.template_shape;
    // With earlier results there are no checkpoints: the identity of a run does not cover the contents of their files.
    if (options_.resume.enabled && options_.start.map.empty() && options_.start.images.empty()) {
      checkpoints_.open(folder_.final_path(),
                        run_identity(options_, reference.original, template_shape.original, inputs_.landmarks));
      if (!restart) {
        auto [findings, levels] = checkpoints_.read(reference.surface.vertices.size(), folder_.path_of("pictures"));
        findings_ = std::move(findings);
        inputs_.checkpoint = std::move(levels);
      }
    }
    findings_.images = read_reference_images<Dim>(options_.start.images, reference.original.vertices.size());
    prepare();
    check_size<Dim>(refined_measures(reference.surface, template_shape.surface, options_), options_.cascade.min_level,
                    options_.cascade.max_level, folder_.final_path());
    if (options_.pictures == Pictures::all || checkpoints_.is_open())
      inputs_.finished = [this](const LevelEnd<Dim>& end) {
        if (options_.pictures == Pictures::all) picture(end);
        checkpoints_.write(end, findings_, folder_.path_of("pictures"));
      };
    MatchResult<Dim> result = match_placed_shapes(std::move(inputs_), options_, recorder_, clock_);
    write(result);
    return result;
  }

  void prepare() {
    PhaseClock phase(clock_.phases);
    if (!options_.start.map.empty() && begin_with(start_map())) return;
    if (align_mode(options_) != AlignMode::none || options_.align.direction == MatchDirection::automatic)
      phase.start("alignment");
    aligning_ = true;
    inputs_.prepared = prepare_pair(inputs_.shapes, inputs_.landmarks, options_, recorder_, findings_);
    aligning_ = false;
    checkpoints_.write(findings_, 1);
  }

  Deformation<Dim> start_map() const {
    try {
      return read_deformation<Dim>(options_.start.map);
    } catch (const InputError& error) {
      throw_input_error("start.map: {}", error.what());
    }
  }

  // False where the shapes do not lie where those of the earlier map do.
  bool begin_with(Deformation<Dim> map) {
    const auto refuse = [&](const char* why) { throw_input_error("start.map: {}: {}", options_.start.map, why); };
    if (options_.input.placement == PlacementKind::as_is && !map.placement.is_identity())
      refuse("that run has moved and scaled its shapes into the unit domain; leave out input.placement: as-is");
    if (options_.align.direction == MatchDirection::backward && !map.is_backward)
      refuse("that run has deformed its reference, not its template; leave out align.direction: backward");
    if (options_.align.bend == BendMode::never && map.bend)
      refuse("that run has bent its reference's surface, and its map is one of that; leave out align.bend: never");
    const CascadeOptions& c = options_.cascade;
    const int level = options_.start.level > 0 ? options_.start.level
                                               : std::clamp(map.grid.finest_level() + 1, c.min_level, c.max_level);
    std::optional<PreparedPair<Dim>> prepared = prepare_as_before<Dim>(inputs_.shapes, map, 1.0 / (1 << c.max_level));
    if (!prepared) {
      recorder_.warn(fmt::format("start.map: {}: these shapes do not lie where those of that run do: it is not used",
                                 options_.start.map));
      return false;
    }
    inputs_.prepared = std::move(*prepared);
    recorder_.note(fmt::format("begins at level {} with the map of {}{}", level, options_.start.map,
                               map.bend ? ", from the surface that it bends first" : ""));
    inputs_.start = FinishedLevel<Dim>{level - 1, std::move(map), false};
    return true;
  }

  void write(MatchResult<Dim>& result) {
    writing_ = true;
    recorder_.stage("writing");
    PhaseClock phase(clock_.phases);
    phase.start("output");
    write_result_files(result, options_, folder_, recorder_);
    phase.stop();
    clock_.state(result.summary.run);
    if (options_.report) recorder_.stage("writing the page");
    phase.start("page");
    write_result_page(result, options_, folder_, recorder_);
    phase.stop();
    clock_.state(result.summary.run);
    write_summary(result.summary, folder_.path_of("summary.json"));
    folder_.commit();
    if (!result.summary.interrupted) checkpoints_.remove();
  }

  // Where the run is stopped, what is kept and how to go on.
  std::string keep_and_tell() {
    // Of a run that ends here, a tenth of what would be kept on the way. What a level has kept stays.
    checkpoints_.write(findings_, 0.1);
    const std::string where = writing_    ? "while the result was written"
                              : aligning_ ? "in the alignment"
                              : recorder_.level == 0
                                  ? "before the first level"
                                  : fmt::format("in level {} of {}", recorder_.level, options_.cascade.max_level);
    const std::optional<int> level = checkpoints_.level();
    if (!level) return fmt::format("stopped {}; nothing was written", where);
    return fmt::format("stopped {}; {} kept in {}: the same command goes on from there", where,
                       *level > 0  ? fmt::format("level {} is", *level)
                       : aligning_ ? "what was found so far is"
                                   : "the alignment is",
                       checkpoints_.path());
  }

  void picture(const LevelEnd<Dim>& end) {
    const int level = end.level.start.level;
    draw(folder_, level_picture_name(level), recorder_, [&](const std::string& path) { write_picture(end, path); });
  }

  void write_picture(const LevelEnd<Dim>& end, const std::string& path) {
    const int level = end.level.start.level;
    LevelPicture<Dim> p;
    p.draft = true;
    p.reference = end.prepared.alignment.bend ? &end.prepared.unbent : &end.shapes.reference.surface;
    p.template_shape = &end.shapes.template_shape.surface;
    p.deformed = &end.deformed;
    p.title = fmt::format("level {}", level);
    add_distances(p, end.distance, end.summary);
    if constexpr (Dim == 2) {
      if (!end.prepared.is_backward()) {
        p.grid = &end.state.grid;
        p.phi = &end.state.phi;
      }
    }
    write_level_picture(p, path);
  }

  const ExperimentOptions& options_;
  OutputFolder& folder_;
  Recorder recorder_;
  RunClock& clock_;
  MatchInputs<Dim> inputs_;  // moved from when the matching starts
  RunCheckpoints<Dim> checkpoints_;
  AlignmentFindings<Dim> findings_;
  bool aligning_ = false, writing_ = false;
};

}  // namespace

AnyMatchResult run_matching(const ExperimentOptions& options, const std::string& output_folder,
                            const EarlierRuns& earlier, Observer& observer) {
  check_experiment(options);
  std::vector<std::string> inputs = {options.input.reference,         options.input.template_file,
                                     options.input.correspondence,    options.landmarks.file,
                                     options.landmarks.template_file, options.start.map};
  inputs.insert(inputs.end(), options.start.images.begin(), options.start.images.end());
  check_inputs_outlive(output_folder, inputs);
  set_n_threads(options.threads);
  RunClock clock;
  PhaseClock phase(clock.phases);
  observer.stage("reading");
  phase.start("reading");
  AnyShapePair shapes = open_shape_pair(options.input, options.landmarks, observer);
  phase.stop();
  OutputFolder folder(output_folder, earlier.force);
  return std::visit(
      [&]<int Dim>(ShapePair<Dim>& pair) -> AnyMatchResult {
        return Run<Dim>(options, std::move(pair), folder, observer, clock).go(earlier.restart);
      },
      shapes);
}

}  // namespace shellmatch
