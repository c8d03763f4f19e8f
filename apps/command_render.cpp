// `render`: pictures of a result with a chosen view, and the pictures of an animation.

#include "apps/commands.h"
#include "apps/output_file.h"
#include "apps/process/interrupt.h"
#include "base/error.h"
#include "base/stop.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/output_folder.h"
#include "matching/output/write_file.h"
#include "matching/pictures/result_picture.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <vector>

namespace shellmatch {

namespace {

template <class Enum>
Enum choice_of(const std::string& text, const char* option, Enum default_value) {
  if (text.empty()) return default_value;
  std::vector<std::string_view> names;
  for (const auto& [value, name] : EnumNames<Enum>::names) {
    if (name == text) return value;
    names.push_back(name);
  }
  throw_input_error("{} {}: expected one of {}", option, text, fmt::join(names, ", "));
}

// A number of a range; none where no text was given.
std::optional<double> number_of(const std::string& text, const char* option, double least, double greatest) {
  if (text.empty()) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || !(value >= least && value <= greatest))
    throw_input_error("{} {}: expected a number from {} to {}", option, text, least, greatest);
  return value;
}

enum class Motion { none, morph, turntable };

struct Frames {
  Motion motion = Motion::none;
  int n = 0;
};

Frames frames_of(const RenderCommand& command) {
  const int n = static_cast<int>(std::lround(number_of(command.frames, "--frames", 2, 2000).value_or(60)));
  if (command.motion.empty()) {
    if (!command.frames.empty()) throw_input_error("--frames {}: say which motion: --motion morph or turntable", command.frames);
    return {};
  }
  if (command.motion == "morph") return {Motion::morph, n};
  if (command.motion == "turntable") return {Motion::turntable, n};
  throw_input_error("--motion {}: expected morph or turntable", command.motion);
}

CanvasKind kind_of(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".png") return CanvasKind::raster;
  if (ending == ".svg") return CanvasKind::svg;
  if (ending == ".pdf") return CanvasKind::pdf;
  throw_input_error("{}: pictures are written as .png, .svg, .pdf; with --motion the name is that of a folder", file);
}

template <int Dim>
void render(const RenderCommand& command, ResultView view, const Frames& frames) {
  if (Dim == 2 && frames.motion == Motion::turntable) throw_input_error("--motion turntable: {} is a result in the plane; morph is possible", command.folder);
  if (frames.motion == Motion::none) {
    const CanvasKind kind = kind_of(command.output);
    check_report_file(command.output, command.force);
    return write_report_file(command.output, draw_result(read_result_shapes<Dim>(command.folder), view, kind).bytes(), command.force);
  }
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::path(command.output) / "deformation.vtu", ignored))
    throw_input_error("{}: holds the result of a run, which an animation would replace; choose another folder with -o", command.output);
  OutputFolder folder(command.output, command.force);
  const ResultShapes<Dim> shapes = read_result_shapes<Dim>(command.folder);
  view.turns = frames.motion == Motion::turntable;
  for (int i = 0; i < frames.n; ++i) {
    stop_if_wanted();
    // The last picture of a turn would be the first one again; a morph ends with the result.
    if (frames.motion == Motion::turntable) view.turn = 360.0 * i / frames.n;
    else view.time = static_cast<double>(i) / (frames.n - 1);
    write_file(folder.path_of(fmt::format("frame_{:04d}.png", i)), draw_result(shapes, view, CanvasKind::raster).bytes());
  }
  folder.commit();
}

}  // namespace

void execute(const RenderCommand& command) {
  catch_interrupts();
  ResultView view;
  view.show = choice_of(command.show, "--show", view.show);
  view.colors = choice_of(command.colors, "--color", view.colors);
  view.azimuth = number_of(command.azimuth, "--azimuth", -360, 360);
  view.elevation = number_of(command.elevation, "--elevation", -90, 90);
  view.time = number_of(command.time, "--time", 0, 1).value_or(1);
  view.size = static_cast<int>(number_of(command.size, "--size", 50, 8000).value_or(800));
  const Frames frames = frames_of(command);
  if (deformation_dimension(command.folder) == 2) render<2>(command, view, frames);
  else render<3>(command, view, frames);
}

}  // namespace shellmatch
