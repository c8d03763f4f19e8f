#include "apps/command_line/command_line.h"

#include "apps/command_line/help_text.h"
#include "apps/command_line/parse_error.h"
#include "apps/versions_text.h"
#include "base/error.h"
#include "base/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace shellmatch {

namespace {

// The data of all commands. CLI11 fills those of the command that is named.
struct Commands {
  MatchCommand match;
  RunCommand run;
  GenerateCommand generate;
  ApplyCommand apply;
  InspectCommand inspect;
  CurvatureCommand curvature;
  CheckGradientCommand check_gradient;
  SelfTestCommand self_test;
  ViewCommand view;
  RenderCommand render;
  ConfigCommand config;
  StudyCommand study;
  CohortCommand cohort;
  Limits limits;  ///< of whichever it is
};

void set_verbosity(Verbosity& present, Verbosity verbosity) {
  if (present != Verbosity::normal && present != verbosity)
    throw_input_error("--quiet and --verbose exclude each other");
  present = verbosity;
}

void add_verbosity(CLI::App& command, Verbosity& verbosity, const char* more) {
  command.add_flag_function("-q,--quiet", [&](std::int64_t) { set_verbosity(verbosity, Verbosity::quiet); }, "errors only");
  command.add_flag_function("-v,--verbose", [&](std::int64_t) { set_verbosity(verbosity, Verbosity::verbose); }, more);
}

// The options that all commands reading an experiment share.
void add_experiment_settings(CLI::App& command, RunSettings& settings, const char* force_meaning, const char* verbose_meaning) {
  command.add_option("--placement", settings.placement,
                     "fit moves both shapes into the unit domain together, as-is leaves them where they are")
      ->type_name("fit|as-is");
  command.add_option("--align", settings.align,
                     "auto finds the pose and pairs of points before the matching (docs/alignment.md)")
      ->type_name("none|auto|rigid|similarity|landmarks");
  command.add_option("--landmarks", settings.landmarks, "points that correspond: CSV, .fcsv or .mrk.json (docs/landmarks.md)")
      ->type_name("FILE");
  command.add_option("--template-landmarks", settings.template_landmarks,
                     "file of the template's points, where --landmarks has those of the reference alone")
      ->type_name("FILE");
  command.add_flag("--strict", settings.strict, "refuse meshes that are not closed, instead of closing them (docs/closing.md)");
  command.add_option("--profile", settings.profile,
                     "default is the best we know, paper keeps the paper's discrete choices to the letter")
      ->type_name("default|paper");
  command.add_option("--threads", settings.threads, "0 uses all of the machine; the result does not depend on it")
      ->type_name("N");
  command.add_option("--set", settings.assignments, "any other option (`shellmatch config` lists them); repeatable")
      ->type_name("KEY.SUB=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--force", settings.force, force_meaning);
  add_verbosity(command, settings.verbosity, verbose_meaning);
}

void add_output_settings(CLI::App& command, RunSettings& settings, const std::string& output_meaning) {
  command.add_option("-o,--output", settings.output, output_meaning)->type_name("DIR");
  command.add_option("--levels", settings.levels, "coarsest and finest level; cells have side 2^-level")
      ->type_name("MIN:MAX");
  add_experiment_settings(command, settings, "replace the output folder of an earlier run", "every iteration");
}

void add_run_settings(CLI::App& command, RunSettings& settings, const std::string& output_meaning) {
  add_output_settings(command, settings, output_meaning);
  command.add_option("--fail-on", settings.fail_on, "exit code 1 for this verdict or a worse one; the result is written all the same")
      ->type_name("look-here|not-matched");
  command.add_flag("--restart", settings.restart, "begin anew where the same command was stopped before");
}

CLI::App* add_command(CLI::App& app, const char* name, const char* meaning, const std::string& footer) {
  CLI::App* command = app.add_subcommand(name, meaning);
  command->footer(footer);
  return command;
}

// Every command has these.
void add_limits(CLI::App& command, Limits& limits) {
  command.add_option("--max-seconds", limits.seconds, "stop in order after this time (exit code 4)")->type_name("SECONDS");
  command.add_option("--max-memory", limits.memory, "stop in order before more is used (exit code 4); runs of a study or cohort together")
      ->type_name("800MB|4GB");
}

void describe_study(CLI::App& app, StudyCommand& study) {
  CLI::App* command = add_command(app, "study", help_text::study, help_text::study_footer);
  command->add_option("STUDY", study.study, "the YAML file")->required()->type_name("");
  command->add_option("-o,--output", study.output, "output folder; without it out/NAME for NAME.yaml")->type_name("DIR");
  command->add_option("-j,--jobs", study.jobs, "runs at the same time (1)")->type_name("N");
  command->add_option("--set", study.assignments, "an option of an experiment for all runs, or limits.seconds and the like; repeatable")
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

void describe_cohort(CLI::App& app, CohortCommand& cohort) {
  CLI::App* command = add_command(app, "cohort", help_text::cohort, help_text::cohort_footer);
  command->add_option("SHAPES", cohort.shapes, "files of subjects or patterns, or the YAML file of a cohort")->type_name("");
  command->add_option("-o,--output", cohort.output, "output folder; without it out/NAME for NAME.yaml")->type_name("DIR");
  command->add_option("--atlas", cohort.atlas, "the shape that is deformed onto all: a file, or the id of a subject")->type_name("SHAPE");
  command->add_option("--kind", cohort.kind, "what becomes of the atlas; given with --atlas, otherwise mean")->type_name("given|medoid|mean");
  command->add_option("--atlas-landmarks", cohort.atlas_landmarks, "points of the atlas, which are carried to all subjects")->type_name("FILE");
  command->add_option("--table", cohort.table, "CSV with the columns file, id, landmarks, group, reflect, instead of SHAPES")->type_name("FILE");
  command->add_option("--levels", cohort.levels, "coarsest and finest level; cells have side 2^-level")->type_name("MIN:MAX");
  command->add_option("-j,--jobs", cohort.jobs, "matchings at the same time; without it one for each core")->type_name("N");
  command->add_option("--set", cohort.assignments, "an option of the cohort, as statistics.modes, or of the matchings; repeatable")
      ->type_name("KEY.SUB=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--retry", cohort.retry, "match again what has a result but did not finish");
  command->add_flag("--list", cohort.list, "print the ids of the subjects; with -v also threads, seconds and MB of a matching");
  command->add_flag("--list-stages", cohort.list_stages, "print the stages: the rounds that the search for the atlas may take, and last");
  command->add_option("--only", cohort.only, "match this subject alone, in the first stage that is not closed; repeatable")
      ->type_name("ID")
      ->allow_extra_args(false);
  command->add_option("--shard", cohort.shard, "match the I-th, (I+N)-th, ... subject alone, likewise")->type_name("I/N");
  command->add_option("--stage", cohort.stage, "with --only, --shard or --collect: this stage; nothing where the atlas is found before it")->type_name("ROUND|last");
  command->add_flag("--collect", cohort.collect, "match nothing: close the rounds that are complete, and write tables, model and report");
  command->add_option("--program", cohort.program, "another build of shellmatch to run")->type_name("FILE");
  command->add_flag("--options", cohort.options, "print every option of a cohort's file");
  add_verbosity(*command, cohort.verbosity, "more, where there is more");
}

void describe(CLI::App& app, Commands& commands) {
  app.footer(help_text::program_footer);
  app.get_formatter()->column_width(34);
  CLI::Option* version = app.set_version_flag("--version", "shellmatch " SHELLMATCH_VERSION, "print the version");
  app.add_flag_function("-v,--verbose", [](std::int64_t) {}, "with --version: versions and licences of all that is linked, too")->needs(version);
  app.require_subcommand(1);

  CLI::App* match = add_command(app, "match", help_text::match,
                                std::string(help_text::match_footer) + help_text::output_footer);
  match->add_option("REFERENCE", commands.match.reference, "the shape that is deformed")->required()->type_name("");
  match->add_option("TEMPLATE", commands.match.template_shape, "the shape it is to match")->required()->type_name("");
  add_run_settings(*match, commands.match.settings, "output folder (required)");

  CLI::App* run = add_command(app, "run", help_text::run, std::string(help_text::run_footer) + help_text::output_footer);
  run->add_option("CONFIG", commands.run.config, "the YAML file")->required()->type_name("");
  add_run_settings(*run, commands.run.settings, "output folder; without it out/NAME for NAME.yaml");

  describe_study(app, commands.study);
  describe_cohort(app, commands.cohort);

  CLI::App* generate = add_command(app, "generate", help_text::generate, help_text::generate_footer);
  generate->add_option("SHAPE", commands.generate.shape, "name, or name/variant")->type_name("");
  generate->add_option("-o,--output", commands.generate.output, "the file to write")->type_name("FILE");
  generate->add_option("--edge-length", commands.generate.edge_length, "length of edges in sides of the domain")
      ->type_name("X");
  generate->add_option("--set", commands.generate.assignments, "a parameter of the shape; repeatable")
      ->type_name("PARAMETER=VALUE")
      ->allow_extra_args(false);
  generate->add_flag("--list", commands.generate.list, "list all shapes, or the variants and parameters of one");
  generate->add_flag("--force", commands.generate.force, "replace the file if it exists");

  CLI::App* apply = add_command(app, "apply", help_text::apply, help_text::apply_footer);
  apply->add_option("DIR", commands.apply.deformation, "output folder of a run, or its deformation.vtu")
      ->required()->type_name("");
  apply->add_option("FILE", commands.apply.file, "mesh, contour, points or volume to move")->type_name("");
  apply->add_option("-o,--output", commands.apply.output, "the file to write (required with FILE)")->type_name("FILE");
  apply->add_option("--like", commands.apply.like, "the volume whose voxels the written ones have; those of FILE if not given")->type_name("VOLUME");
  apply->add_option("--sampling", commands.apply.sampling, "of a volume between its voxels; by its values if not given")->type_name("nearest|label|linear");
  apply->add_option("--displacement", commands.apply.displacement, "write the displacements as vectors in LPS, as ANTs and ITK read them")->type_name("VOLUME");
  apply->add_option("--jacobian", commands.apply.jacobian, "write the factors by which volumes change")->type_name("VOLUME");
  apply->add_option("--log-jacobian", commands.apply.log_jacobian, "write their logarithms")->type_name("VOLUME");
  apply->add_flag("--inverse", commands.apply.inverse, "by the inverse map, from the template back to the reference");
  apply->add_flag("--keep-pose", commands.apply.keep_pose,
                  "without the motion that alignment took out: what is on the template is where the reference lies");
  apply->add_flag("--force", commands.apply.force, "replace the file if it exists");

  CLI::App* inspect = add_command(app, "inspect", help_text::inspect, help_text::inspect_footer);
  inspect->add_option("FILE", commands.inspect.file, "the shape")->required()->type_name("");
  inspect->add_flag("--json", commands.inspect.json, "for machines");

  CLI::App* curvature = add_command(app, "curvature", help_text::curvature, help_text::curvature_footer);
  curvature->add_option("SHAPE", commands.curvature.shape, "the shape")->required()->type_name("");
  add_output_settings(*curvature, commands.curvature.settings, "output folder (required)");
  curvature->add_option("--degree", commands.curvature.degree, "of the polynomials fitted to a mesh, 2 to 4; 2 if not given")
      ->type_name("N");
  curvature->add_option("--rings", commands.curvature.rings,
                        "of neighbours that the fit to the mesh takes in, 1 to 10; 2 if not given")
      ->type_name("N");

  CLI::App* check = add_command(app, "check-gradient", help_text::check_gradient, help_text::check_gradient_footer);
  CheckGradientCommand& checked = commands.check_gradient;
  check->add_option("CONFIG", checked.config, "the YAML file")->required()->type_name("");
  check->add_option("--level", checked.level, "level of the grid; 5, in the plane 7, where the cascade has it")->type_name("L");
  check->add_option("--state", checked.state, "the deformation to check at; random:0.03:1 where not given")
      ->type_name("identity|random:A[:SEED]|DIR");
  check->add_option("--directions", checked.directions, "random directions for the Taylor remainder; 2 where not given")
      ->type_name("N");
  check->add_option("--json", checked.json, "write all figures to this file")->type_name("FILE");
  add_experiment_settings(*check, checked.settings, "replace the file of --json if it exists", "every phase");

  CLI::App* self_test = add_command(app, "self-test", help_text::self_test, help_text::self_test_footer);
  self_test->add_option("--threads", commands.self_test.threads, "0 uses all of the machine")->type_name("N");
  add_verbosity(*self_test, commands.self_test.verbosity, "each group as it begins");

  CLI::App* view = add_command(app, "view", help_text::view, help_text::view_footer);
  view->add_option("DIR", commands.view.folder, "output folder of a run, or its report.html")->required()->type_name("");
  view->add_flag("--print", commands.view.print_only, "print the name of the page, and open nothing");

  CLI::App* render = add_command(app, "render", help_text::render, help_text::render_footer);
  RenderCommand& rendered = commands.render;
  render->add_option("DIR", rendered.folder, "output folder of a run")->required()->type_name("");
  render->add_option("-o,--output", rendered.output, "the picture (.png, .svg, .pdf); with --motion an animation (.webp), or a folder of PNGs")->type_name("FILE|DIR");
  render->add_option("--show", rendered.show, "which shapes; all is three panels")->type_name("result|reference|template|overlay|all");
  render->add_option("--color", rendered.colors, "distance and distortion have a scale with its unit")->type_name("checker|distance|distortion|plain");
  render->add_option("--azimuth", rendered.azimuth, "of the view, around the up axis; a good one is chosen if not given")->type_name("DEGREES");
  render->add_option("--elevation", rendered.elevation, "of the view, above the horizon")->type_name("DEGREES");
  render->add_option("--time", rendered.time, "t of phi_t = (1 - t) id + t phi, 0 to 1")->type_name("T");
  render->add_option("--size", rendered.size, "side of a panel (800)")->type_name("PIXELS");
  render->add_option("--motion", rendered.motion, "an animation: the way from reference to result, or a turn around them")->type_name("morph|turntable");
  render->add_option("--frames", rendered.frames, "how many pictures (60)")->type_name("N");
  render->add_option("--seconds", rendered.seconds, "how long a .webp moves; 25 pictures a second if not given")->type_name("SECONDS");
  render->add_option("--quality", rendered.quality, "of a .webp, 1 to 100 (80); 100 keeps every pixel")->type_name("Q");
  render->add_flag("--force", rendered.force, "replace the file, or the folder of an earlier animation");

  CLI::App* config = add_command(app, "config", help_text::config, help_text::config_footer);
  config->add_option("--profile", commands.config.profile, "whose defaults to print")->type_name("default|paper");
  config->add_flag("--markdown", commands.config.markdown, "as a Markdown table instead");

  for (CLI::App* command : app.get_subcommands({})) add_limits(*command, commands.limits);
}

// The command of this name, with what it needs.
Command named_command(const std::string& name, const Commands& commands) {
  const auto require_output = [&](const std::string& output, const char* what) {
    if (output.empty()) throw_input_error("{}: say where to write: -o {} (see shellmatch {} --help)", name, what, name);
  };
  if (name == "match") {
    require_output(commands.match.settings.output, "DIR");
    return commands.match;
  }
  if (name == "run") return commands.run;
  if (name == "study") return commands.study;
  if (name == "cohort") return commands.cohort;
  if (name == "generate") {
    if (commands.generate.shape.empty() && !commands.generate.list)
      throw_input_error("generate: say which shape; `shellmatch generate --list` lists them");
    if (!commands.generate.list) require_output(commands.generate.output, "FILE");
    return commands.generate;
  }
  if (name == "apply") {
    const ApplyCommand& apply = commands.apply;
    const bool has_fields = !apply.displacement.empty() || !apply.jacobian.empty() || !apply.log_jacobian.empty();
    if (apply.file.empty() && !has_fields) throw_input_error("apply: say what to move: apply DIR FILE -o OUTPUT (see shellmatch apply --help)");
    if (!apply.file.empty()) require_output(apply.output, "FILE");
    else if (!apply.output.empty()) throw_input_error("apply: -o {}: there is no FILE to move (see shellmatch apply --help)", apply.output);
    return commands.apply;
  }
  if (name == "inspect") return commands.inspect;
  if (name == "curvature") {
    require_output(commands.curvature.settings.output, "DIR");
    return commands.curvature;
  }
  if (name == "check-gradient") return commands.check_gradient;
  if (name == "self-test") return commands.self_test;
  if (name == "view") return commands.view;
  if (name == "render") {
    require_output(commands.render.output, commands.render.motion.empty() ? "FILE" : "FILE.webp, or a folder");
    return commands.render;
  }
  return commands.config;
}

}  // namespace

Invocation parse_command_line(const std::vector<std::string>& words) {
  Commands commands;
  CLI::App app{help_text::program, "shellmatch"};
  describe(app, commands);
  try {
    // CLI11 expects the words in reverse order.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return {PrintCommand{app.help()}, {}};
  } catch (const CLI::CallForVersion&) {
    const bool is_verbose = std::ranges::any_of(words, [](const std::string& w) { return w == "-v" || w == "--verbose"; });
    return {PrintCommand{is_verbose ? versions_text() : "shellmatch " SHELLMATCH_VERSION "\n"}, {}};
  } catch (const CLI::ParseError& error) {
    std::string complaint = error.what();
    std::replace(complaint.begin(), complaint.end(), '\n', ' ');
    explain_parse_error(app, words, complaint);
  }
  return {named_command(app.get_subcommands().front()->get_name(), commands), commands.limits};
}

}  // namespace shellmatch
