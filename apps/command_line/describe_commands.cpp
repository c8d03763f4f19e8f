#include "apps/command_line/describe_commands.h"

#include "apps/command_line/help_text.h"
#include "apps/command_line/shared_options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace shellmatch {

namespace {

void add_run_settings(CLI::App& command, RunSettings& settings, const std::string& output_meaning) {
  add_output_settings(command, settings, output_meaning);
  command
      .add_option("--fail-on", settings.fail_on,
                  "exit code 1 for this verdict or a worse one; the result is written all the same")
      ->type_name("look-here|not-matched");
  command.add_flag("--restart", settings.restart, "begin anew where the same command was stopped before");
}

}  // namespace

void describe(CLI::App& app, MatchCommand& match) {
  CLI::App* command =
      add_command(app, "match", help_text::match, std::string(help_text::match_footer) + help_text::output_footer);
  command->add_option("REFERENCE", match.reference, "the shape that is deformed")->required()->type_name("");
  command->add_option("TEMPLATE", match.template_shape, "the shape it is to match")->required()->type_name("");
  add_run_settings(*command, match.settings, "output folder (required)");
}

void describe(CLI::App& app, RunCommand& run) {
  CLI::App* command =
      add_command(app, "run", help_text::run, std::string(help_text::run_footer) + help_text::output_footer);
  command->add_option("CONFIG", run.config, "the YAML file")->required()->type_name("");
  add_run_settings(*command, run.settings, "output folder; without it out/NAME for NAME.yaml");
}

void describe(CLI::App& app, StudyCommand& study) {
  CLI::App* command = add_command(app, "study", help_text::study, help_text::study_footer);
  command->add_option("STUDY", study.study, "the YAML file")->required()->type_name("");
  command->add_option("-o,--output", study.output, "output folder; without it out/NAME for NAME.yaml")
      ->type_name("DIR");
  command->add_option("-j,--jobs", study.jobs, "runs at the same time (1)")->type_name("N");
  command
      ->add_option("--set", study.assignments,
                   "an option of an experiment for all runs, or limits.seconds and the like; repeatable")
      ->type_name("KEY.SUB=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--retry", study.retry, "run again what has a result but did not finish");
  command->add_flag("--list", study.list, "print the names of the runs; with -v also threads, seconds and MB of each");
  command->add_option("--only", study.only, "this run alone, without tables; repeatable")
      ->type_name("RUN")
      ->allow_extra_args(false);
  command->add_flag("--collect", study.collect, "run nothing: tables and plots from the results that there are");
  command->add_option("--program", study.program, "another build of shellmatch to run")->type_name("FILE");
  add_verbosity(*command, study.verbosity, "more, where there is more");
}

void describe(CLI::App& app, CohortCommand& cohort) {
  CLI::App* command = add_command(app, "cohort", help_text::cohort, help_text::cohort_footer);
  command->add_option("SHAPES", cohort.shapes, "files of subjects or patterns, or the YAML file of a cohort")
      ->type_name("");
  command->add_option("-o,--output", cohort.output, "output folder; without it out/NAME for NAME.yaml")
      ->type_name("DIR");
  command->add_option("--atlas", cohort.atlas, "the shape that is deformed onto all: a file, or the id of a subject")
      ->type_name("SHAPE");
  command
      ->add_option("--kind", cohort.kind,
                   "what becomes of the atlas; given with --atlas and without a file of the cohort, otherwise mean")
      ->type_name("given|medoid|mean");
  command
      ->add_option("--atlas-landmarks", cohort.atlas_landmarks,
                   "points of the atlas, which are carried to all subjects")
      ->type_name("FILE");
  command
      ->add_option("--table", cohort.table,
                   "CSV with the columns file, id, landmarks, group, reflect, instead of SHAPES")
      ->type_name("FILE");
  command->add_option("--levels", cohort.levels, "coarsest and finest level; cells have side 2^-level")
      ->type_name("MIN:MAX");
  command->add_option("-j,--jobs", cohort.jobs, "matchings at the same time; without it one for each core")
      ->type_name("N");
  command
      ->add_option("--set", cohort.assignments,
                   "an option of the cohort, as statistics.modes, or of the matchings; repeatable")
      ->type_name("KEY.SUB=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--retry", cohort.retry, "match again what has a result but did not finish");
  command->add_flag("--list", cohort.list,
                    "print the ids of the subjects; with -v also threads, seconds and MB of a matching");
  command->add_flag(
      "--list-stages", cohort.list_stages,
      "print the stages: the rounds that the search for the atlas may take, or the first subjects, and last");
  command
      ->add_option("--only", cohort.only, "match this subject alone, in the first stage that is not closed; repeatable")
      ->type_name("ID")
      ->allow_extra_args(false);
  command->add_option("--shard", cohort.shard, "match the I-th, (I+N)-th, ... subject alone, likewise")
      ->type_name("I/N");
  command
      ->add_option("--stage", cohort.stage,
                   "with --only, --shard or --collect: this stage; nothing where the atlas is found before it")
      ->type_name("ROUND|last");
  command->add_flag("--collect", cohort.collect,
                    "match nothing: close the rounds that are complete, and write tables, model and report");
  command->add_option("--program", cohort.program, "another build of shellmatch to run")->type_name("FILE");
  command->add_flag("--options", cohort.options, "print every option of a cohort's file");
  add_verbosity(*command, cohort.verbosity, "more, where there is more");
}

void describe(CLI::App& app, CurvatureCommand& curvature) {
  CLI::App* command = add_command(app, "curvature", help_text::curvature, help_text::curvature_footer);
  command->add_option("SHAPE", curvature.shape, "the shape")->required()->type_name("");
  add_output_settings(*command, curvature.settings, "output folder (required)");
  command->add_option("--degree", curvature.degree, "of the polynomials fitted to a mesh, 2 to 4; 2 if not given")
      ->type_name("N");
  command
      ->add_option("--rings", curvature.rings,
                   "of neighbours that the fit to the mesh takes in, 1 to 10; 2 if not given")
      ->type_name("N");
}

void describe(CLI::App& app, CheckGradientCommand& check_gradient) {
  CLI::App* command = add_command(app, "check-gradient", help_text::check_gradient, help_text::check_gradient_footer);
  command->add_option("CONFIG", check_gradient.config, "the YAML file")->required()->type_name("");
  command->add_option("--level", check_gradient.level, "level of the grid; 5, in the plane 7, where the cascade has it")
      ->type_name("L");
  command->add_option("--state", check_gradient.state, "the deformation to check at; random:0.03:1 where not given")
      ->type_name("identity|random:A[:SEED]|DIR");
  command
      ->add_option("--directions", check_gradient.directions,
                   "random directions for the Taylor remainder; 2 where not given")
      ->type_name("N");
  command->add_option("--json", check_gradient.json, "write all figures to this file")->type_name("FILE");
  add_experiment_settings(*command, check_gradient.settings, "replace the file of --json if it exists", "every phase");
}

void describe(CLI::App& app, GenerateCommand& generate) {
  CLI::App* command = add_command(app, "generate", help_text::generate, help_text::generate_footer);
  command->add_option("SHAPE", generate.shape, "name, or name/variant")->type_name("");
  command->add_option("-o,--output", generate.output, "the file to write")->type_name("FILE");
  command->add_option("--edge-length", generate.edge_length, "length of edges in sides of the domain")->type_name("X");
  command->add_option("--set", generate.assignments, "a parameter of the shape; repeatable")
      ->type_name("PARAMETER=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--list", generate.list, "list all shapes, or the variants and parameters of one");
  command->add_flag("--force", generate.force, "replace the file if it exists");
}

void describe(CLI::App& app, ApplyCommand& apply) {
  CLI::App* command = add_command(app, "apply", help_text::apply, help_text::apply_footer);
  command->add_option("DIR", apply.deformation, "output folder of a run, or its deformation.vtu")
      ->required()
      ->type_name("");
  command->add_option("FILE", apply.file, "mesh, contour, points or volume to move")->type_name("");
  command->add_option("-o,--output", apply.output, "the file to write (required with FILE)")->type_name("FILE");
  command->add_option("--like", apply.like, "the volume whose voxels the written ones have; those of FILE if not given")
      ->type_name("VOLUME");
  command->add_option("--sampling", apply.sampling, "of a volume between its voxels; by its values if not given")
      ->type_name("nearest|label|linear");
  command
      ->add_option("--displacement", apply.displacement,
                   "write the displacements as vectors in LPS, as ANTs and ITK read them")
      ->type_name("VOLUME");
  command->add_option("--jacobian", apply.jacobian, "write the factors by which volumes change")->type_name("VOLUME");
  command->add_option("--log-jacobian", apply.log_jacobian, "write their logarithms")->type_name("VOLUME");
  command->add_flag("--inverse", apply.inverse, "by the inverse map, from the template back to the reference");
  command->add_flag("--keep-pose", apply.keep_pose,
                    "without the motion that alignment took out: what is on the template is where the reference lies");
  command->add_flag("--force", apply.force, "replace the file if it exists");
}

void describe(CLI::App& app, InspectCommand& inspect) {
  CLI::App* command = add_command(app, "inspect", help_text::inspect, help_text::inspect_footer);
  command->add_option("FILE", inspect.file, "the shape")->required()->type_name("");
  command->add_flag("--json", inspect.json, "for machines");
}

void describe(CLI::App& app, ViewCommand& view) {
  CLI::App* command = add_command(app, "view", help_text::view, help_text::view_footer);
  command->add_option("DIR", view.folder, "output folder of a run, or its report.html")->required()->type_name("");
  command->add_flag("--print", view.print_only, "print the name of the page, and open nothing");
}

void describe(CLI::App& app, RenderCommand& render) {
  CLI::App* command = add_command(app, "render", help_text::render, help_text::render_footer);
  command->add_option("DIR", render.folder, "output folder of a run")->required()->type_name("");
  command
      ->add_option("-o,--output", render.output,
                   "the picture (.png, .svg, .pdf); with --motion an animation (.webp), or a folder of PNGs")
      ->type_name("FILE|DIR");
  command->add_option("--show", render.show, "which shapes; all is three panels")
      ->type_name("result|reference|template|overlay|all");
  command->add_option("--color", render.colors, "distance and distortion have a scale with its unit")
      ->type_name("checker|distance|distortion|plain");
  command->add_option("--azimuth", render.azimuth, "of the view, around the up axis; a good one is chosen if not given")
      ->type_name("DEGREES");
  command->add_option("--elevation", render.elevation, "of the view, above the horizon")->type_name("DEGREES");
  command->add_option("--time", render.time, "t of phi_t = (1 - t) id + t phi, 0 to 1")->type_name("T");
  command->add_option("--size", render.size, "side of a panel (800)")->type_name("PIXELS");
  command
      ->add_option("--motion", render.motion, "an animation: the way from reference to result, or a turn around them")
      ->type_name("morph|turntable");
  command->add_option("--frames", render.frames, "how many pictures (60)")->type_name("N");
  command->add_option("--seconds", render.seconds, "how long a .webp moves; 25 pictures a second if not given")
      ->type_name("SECONDS");
  command->add_option("--quality", render.quality, "of a .webp, 1 to 100 (80); 100 keeps every pixel")->type_name("Q");
  command->add_flag("--force", render.force, "replace the file, or the folder of an earlier animation");
}

void describe(CLI::App& app, ConfigCommand& config) {
  CLI::App* command = add_command(app, "config", help_text::config, help_text::config_footer);
  command->add_option("--profile", config.profile, "whose defaults to print")->type_name("default|paper");
  command->add_flag("--markdown", config.markdown, "as Markdown tables");
}

void describe(CLI::App& app, SelfTestCommand& self_test) {
  CLI::App* command = add_command(app, "self-test", help_text::self_test, help_text::self_test_footer);
  command->add_option("--threads", self_test.threads, "0 uses all of the machine")->type_name("N");
  add_verbosity(*command, self_test.verbosity, "each group as it begins");
}

}  // namespace shellmatch
