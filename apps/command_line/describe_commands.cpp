#include "apps/command_line/describe_commands.h"

#include "apps/command_line/help_text.h"
#include "apps/command_line/shared_options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace shellmatch {

namespace {

// An option with one value, of which `type` says what it is.
template <class Value>
CLI::Option* add_value(CLI::App& command, const char* name, Value& value, const char* type, const char* meaning) {
  return command.add_option(name, value, meaning)->type_name(type);
}

// The same that may stand there several times.
void add_repeatable(CLI::App& command, const char* name, std::vector<std::string>& values, const char* type,
                    const char* meaning) {
  add_value(command, name, values, type, meaning)->allow_extra_args(false);
}

// A word that must be there.
void add_word(CLI::App& command, const char* name, std::string& word, const char* meaning) {
  add_value(command, name, word, "", meaning)->required();
}

void add_run_settings(CLI::App& command, RunSettings& settings, const std::string& output_meaning) {
  add_output_settings(command, settings, output_meaning);
  add_value(command, "--fail-on", settings.fail_on, "look-here|not-matched",
            "exit code 1 for this verdict or a worse one; the result is written all the same");
  command.add_flag("--restart", settings.restart, "begin anew where the same command was stopped before");
}

}  // namespace

void describe(CLI::App& app, MatchCommand& match) {
  CLI::App* command =
      add_command(app, "match", help_text::match, std::string(help_text::match_footer) + help_text::output_footer);
  add_word(*command, "REFERENCE", match.reference, "the shape that is deformed");
  add_word(*command, "TEMPLATE", match.template_shape, "the shape it is to match");
  add_run_settings(*command, match.settings, "output folder (required)");
}

void describe(CLI::App& app, RunCommand& run) {
  CLI::App* command =
      add_command(app, "run", help_text::run, std::string(help_text::run_footer) + help_text::output_footer);
  add_word(*command, "CONFIG", run.config, "the YAML file");
  add_run_settings(*command, run.settings, "output folder; without it out/NAME for NAME.yaml");
}

void describe(CLI::App& app, StudyCommand& study) {
  CLI::App* command = add_command(app, "study", help_text::study, help_text::study_footer);
  add_word(*command, "STUDY", study.study, "the YAML file");
  add_value(*command, "-o,--output", study.output, "DIR", "output folder; without it out/NAME for NAME.yaml");
  add_value(*command, "-j,--jobs", study.jobs, "N", "runs at the same time (1)");
  add_repeatable(*command, "--set", study.assignments, "KEY.SUB=VALUE",
                 "an option of an experiment for all runs, or limits.seconds and the like; repeatable");
  command->add_flag("--retry", study.retry, "run again what has a result but did not finish");
  command->add_flag("--list", study.list, "print the names of the runs; with -v also threads, seconds and MB of each");
  add_repeatable(*command, "--only", study.only, "RUN", "this run alone, without tables; repeatable");
  command->add_flag("--collect", study.collect, "run nothing: tables and plots from the results that there are");
  add_value(*command, "--program", study.program, "FILE", "another build of shellmatch to run");
  add_verbosity(*command, study.verbosity, "more, where there is more");
}

void describe(CLI::App& app, CohortCommand& cohort) {
  CLI::App* command = add_command(app, "cohort", help_text::cohort, help_text::cohort_footer);
  add_value(*command, "SHAPES", cohort.shapes, "", "files of subjects or patterns, or the YAML file of a cohort");
  add_value(*command, "-o,--output", cohort.output, "DIR", "output folder; without it out/NAME for NAME.yaml");
  add_value(*command, "--atlas", cohort.atlas, "SHAPE",
            "the shape that is deformed onto all: a file, or the id of a subject");
  add_value(*command, "--kind", cohort.kind, "given|medoid|mean",
            "what becomes of the atlas; given with --atlas and without a file of the cohort, otherwise mean");
  add_value(*command, "--atlas-landmarks", cohort.atlas_landmarks, "FILE",
            "points of the atlas, which are carried to all subjects");
  add_value(*command, "--table", cohort.table, "FILE",
            "CSV with the columns file, id, landmarks, group, reflect, instead of SHAPES");
  add_value(*command, "--levels", cohort.levels, "MIN:MAX", "coarsest and finest level; cells have side 2^-level");
  add_value(*command, "-j,--jobs", cohort.jobs, "N", "matchings at the same time; without it one for each core");
  add_repeatable(*command, "--set", cohort.assignments, "KEY.SUB=VALUE",
                 "an option of the cohort, as statistics.modes, or of the matchings; repeatable");
  command->add_flag("--retry", cohort.retry, "match again what has a result but did not finish");
  command->add_flag("--list", cohort.list,
                    "print the ids of the subjects; with -v also threads, seconds and MB of a matching");
  command->add_flag(
      "--list-stages", cohort.list_stages,
      "print the stages: the rounds that the search for the atlas may take, or the first subjects, and last");
  add_repeatable(*command, "--only", cohort.only, "ID",
                 "match this subject alone, in the first stage that is not closed; repeatable");
  add_value(*command, "--shard", cohort.shard, "I/N", "match the I-th, (I+N)-th, ... subject alone, likewise");
  add_value(*command, "--stage", cohort.stage, "ROUND|last",
            "with --only, --shard or --collect: this stage; nothing where the atlas is found before it");
  command->add_flag("--collect", cohort.collect,
                    "match nothing: close the rounds that are complete, and write tables, model and report");
  add_value(*command, "--program", cohort.program, "FILE", "another build of shellmatch to run");
  command->add_flag("--options", cohort.options, "print every option of a cohort's file");
  add_verbosity(*command, cohort.verbosity, "more, where there is more");
}

void describe(CLI::App& app, CurvatureCommand& curvature) {
  CLI::App* command = add_command(app, "curvature", help_text::curvature, help_text::curvature_footer);
  add_word(*command, "SHAPE", curvature.shape, "the shape");
  add_output_settings(*command, curvature.settings, "output folder (required)");
  add_value(*command, "--degree", curvature.degree, "N", "of the polynomials fitted to a mesh, 2 to 4; 2 if not given");
  add_value(*command, "--rings", curvature.rings, "N",
            "of neighbours that the fit to the mesh takes in, 1 to 10; 2 if not given");
}

void describe(CLI::App& app, CheckGradientCommand& check_gradient) {
  CLI::App* command = add_command(app, "check-gradient", help_text::check_gradient, help_text::check_gradient_footer);
  add_word(*command, "CONFIG", check_gradient.config, "the YAML file");
  add_value(*command, "--level", check_gradient.level, "L",
            "level of the grid; 5, in the plane 7, where the cascade has it");
  add_value(*command, "--state", check_gradient.state, "identity|random:A[:SEED]|DIR",
            "the deformation to check at; random:0.03:1 where not given");
  add_value(*command, "--directions", check_gradient.directions, "N",
            "random directions for the Taylor remainder; 2 where not given");
  add_value(*command, "--json", check_gradient.json, "FILE", "write all figures to this file");
  add_experiment_settings(*command, check_gradient.settings, "replace the file of --json if it exists", "every phase");
}

void describe(CLI::App& app, GenerateCommand& generate) {
  CLI::App* command = add_command(app, "generate", help_text::generate, help_text::generate_footer);
  add_value(*command, "SHAPE", generate.shape, "", "name, or name/variant");
  add_value(*command, "-o,--output", generate.output, "FILE", "the file to write");
  add_value(*command, "--edge-length", generate.edge_length, "X", "length of edges in sides of the domain");
  add_repeatable(*command, "--set", generate.assignments, "PARAMETER=VALUE", "a parameter of the shape; repeatable");
  command->add_flag("--list", generate.list, "list all shapes, or the variants and parameters of one");
  command->add_flag("--force", generate.force, "replace the file if it exists");
}

void describe(CLI::App& app, ApplyCommand& apply) {
  CLI::App* command = add_command(app, "apply", help_text::apply, help_text::apply_footer);
  add_word(*command, "DIR", apply.deformation, "output folder of a run, or its deformation.vtu");
  add_value(*command, "FILE", apply.file, "", "mesh, contour, points or volume to move");
  add_value(*command, "-o,--output", apply.output, "FILE", "the file to write (required with FILE)");
  add_value(*command, "--like", apply.like, "VOLUME",
            "the volume whose voxels the written ones have; those of FILE if not given");
  add_value(*command, "--sampling", apply.sampling, "nearest|label|linear",
            "of a volume between its voxels; by its values if not given");
  add_value(*command, "--displacement", apply.displacement, "VOLUME",
            "write the displacements as vectors in LPS, as ANTs and ITK read them");
  add_value(*command, "--jacobian", apply.jacobian, "VOLUME", "write the factors by which volumes change");
  add_value(*command, "--log-jacobian", apply.log_jacobian, "VOLUME", "write their logarithms");
  command->add_flag("--inverse", apply.inverse, "by the inverse map, from the template back to the reference");
  command->add_flag("--keep-pose", apply.keep_pose,
                    "without the motion that alignment took out: what is on the template is where the reference lies");
  command->add_flag("--force", apply.force, "replace the file if it exists");
}

void describe(CLI::App& app, InspectCommand& inspect) {
  CLI::App* command = add_command(app, "inspect", help_text::inspect, help_text::inspect_footer);
  add_word(*command, "FILE", inspect.file, "the shape");
  command->add_flag("--json", inspect.json, "for machines");
}

void describe(CLI::App& app, ViewCommand& view) {
  CLI::App* command = add_command(app, "view", help_text::view, help_text::view_footer);
  add_word(*command, "DIR", view.folder, "output folder of a run, or its report.html");
  command->add_flag("--print", view.print_only, "print the name of the page, and open nothing");
}

void describe(CLI::App& app, RenderCommand& render) {
  CLI::App* command = add_command(app, "render", help_text::render, help_text::render_footer);
  add_word(*command, "DIR", render.folder, "output folder of a run");
  add_value(*command, "-o,--output", render.output, "FILE|DIR",
            "the picture (.png, .svg, .pdf); with --motion an animation (.webp), or a folder of PNGs");
  add_value(*command, "--show", render.show, "result|reference|template|overlay|all",
            "which shapes; all is three panels");
  add_value(*command, "--color", render.colors, "checker|distance|distortion|plain",
            "distance and distortion have a scale with its unit");
  add_value(*command, "--azimuth", render.azimuth, "DEGREES",
            "of the view, around the up axis; a good one is chosen if not given");
  add_value(*command, "--elevation", render.elevation, "DEGREES", "of the view, above the horizon");
  add_value(*command, "--time", render.time, "T", "t of phi_t = (1 - t) id + t phi, 0 to 1");
  add_value(*command, "--size", render.size, "PIXELS", "side of a panel (800)");
  add_value(*command, "--motion", render.motion, "morph|turntable",
            "an animation: the way from reference to result, or a turn around them");
  add_value(*command, "--frames", render.frames, "N", "how many pictures (60)");
  add_value(*command, "--seconds", render.seconds, "SECONDS",
            "how long a .webp moves; 25 pictures a second if not given");
  add_value(*command, "--quality", render.quality, "Q", "of a .webp, 1 to 100 (80); 100 keeps every pixel");
  command->add_flag("--force", render.force, "replace the file, or the folder of an earlier animation");
}

void describe(CLI::App& app, ConfigCommand& config) {
  CLI::App* command = add_command(app, "config", help_text::config, help_text::config_footer);
  add_value(*command, "--profile", config.profile, "default|paper", "whose defaults to print");
  command->add_flag("--markdown", config.markdown, "as Markdown tables");
}

void describe(CLI::App& app, SelfTestCommand& self_test) {
  CLI::App* command = add_command(app, "self-test", help_text::self_test, help_text::self_test_footer);
  add_value(*command, "--threads", self_test.threads, "N", "0 uses all of the machine");
  add_verbosity(*command, self_test.verbosity, "each group as it begins");
}

}  // namespace shellmatch
