#include "apps/command_line/describe_commands.h"
#include "apps/command_line/help_text.h"
#include "apps/command_line/shared_options.h"

#include <CLI/CLI.hpp>

namespace shellmatch {

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
  command->add_flag("--markdown", config.markdown, "as a Markdown table instead");
}

void describe(CLI::App& app, SelfTestCommand& self_test) {
  CLI::App* command = add_command(app, "self-test", help_text::self_test, help_text::self_test_footer);
  command->add_option("--threads", self_test.threads, "0 uses all of the machine")->type_name("N");
  add_verbosity(*command, self_test.verbosity, "each group as it begins");
}

}  // namespace shellmatch
