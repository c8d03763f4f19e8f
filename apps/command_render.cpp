// `render`: pictures of a result with a chosen view, and animations: one file, or numbered pictures in a folder.

#include "apps/commands.h"
#include "apps/output_file.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/stop.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/output_folder.h"
#include "matching/output/write_file.h"
#include "matching/pictures/result_picture.h"
#include "matching/render/canvas/animation.h"

#include <fmt/ranges.h>

#include <filesystem>
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

// None where no text was given.
std::optional<double> number_of(const std::string& text, const char* option, double least, double greatest) {
  return text.empty() ? std::nullopt : std::optional(number(text, option, least, greatest));
}

enum class Motion { none, morph, turntable };

struct Frames {
  Motion motion = Motion::none;
  int n = 0;
  double seconds = 0;  // of all, and how true they are to the pictures: of one file
  int quality = 0;
};

std::string ending_of(const std::string& file) { return std::filesystem::path(file).extension().string(); }

bool is_one_file(const RenderCommand& command) { return ending_of(command.output) == ".webp"; }

constexpr double pictures_per_second = 25;

Frames frames_of(const RenderCommand& command) {
  const int n = command.frames.empty() ? 60 : whole_number(command.frames, "--frames", 2, 2000);
  const double seconds = number_of(command.seconds, "--seconds", 0.1, 600).value_or(n / pictures_per_second);
  const int quality = command.quality.empty() ? 80 : whole_number(command.quality, "--quality", 1, 100);
  for (const auto& [option, text] : {std::pair{"--seconds", command.seconds}, std::pair{"--quality", command.quality}})
    if (!text.empty() && (command.motion.empty() || !is_one_file(command)))
      throw_input_error("{} {}: is of an animation in one file: --motion morph or turntable, -o NAME.webp", option,
                        text);
  if (command.motion.empty()) {
    if (!command.frames.empty())
      throw_input_error("--frames {}: say which motion: --motion morph or turntable", command.frames);
    return {};
  }
  if (command.motion == "morph") return {Motion::morph, n, seconds, quality};
  if (command.motion == "turntable") return {Motion::turntable, n, seconds, quality};
  throw_input_error("--motion {}: expected morph or turntable", command.motion);
}

CanvasKind kind_of(const std::string& file) {
  const std::string ending = ending_of(file);
  if (ending == ".png") return CanvasKind::raster;
  if (ending == ".svg") return CanvasKind::svg;
  if (ending == ".pdf") return CanvasKind::pdf;
  throw_input_error(
      "{}: pictures are written as .png, .svg, .pdf; animations (--motion) as .webp, or as a folder of PNGs", file);
}

// The last picture of a turn would be the first one again; a morph ends with the result.
ResultView view_of_frame(ResultView view, const Frames& frames, int i) {
  view.turns = frames.motion == Motion::turntable;
  if (view.turns) view.turn = 360.0 * i / frames.n;
  else view.time = static_cast<double>(i) / (frames.n - 1);
  return view;
}

// Before it begins anew a morph rests at its ends.
double seconds_of_frame(const Frames& frames, int i) {
  const bool is_end = frames.motion == Motion::morph && (i == 0 || i == frames.n - 1);
  return frames.seconds / frames.n + (is_end ? 0.5 : 0);
}

template <int Dim>
void write_animation(const RenderCommand& command, const ResultView& view, const Frames& frames) {
  check_report_file(command.output, command.force);
  // Before anything is drawn: captions and scales need a little more.
  if (const int n_panels = view.show == ShownShapes::all ? 3 : 1; n_panels * view.size > Animation::largest_side)
    throw_input_error("--size {}: pictures of an animation end at {} pixels a side", view.size,
                      Animation::largest_side);
  const ResultShapes<Dim> shapes = read_result_shapes<Dim>(command.folder);
  Animation animation(frames.quality);
  for (int i = 0; i < frames.n; ++i) {
    stop_if_wanted();
    animation.add(draw_result(shapes, view_of_frame(view, frames, i), CanvasKind::raster).to_image(),
                  seconds_of_frame(frames, i));
  }
  write_report_file(command.output, animation.bytes(), command.force);
}

template <int Dim>
void write_frames(const RenderCommand& command, const ResultView& view, const Frames& frames) {
  for (const char* ending : {".png", ".svg", ".pdf", ".gif", ".apng", ".mp4", ".webm", ".avi", ".mkv", ".mov"})
    if (ending_of(command.output) == ending)
      throw_input_error(
          "{}: an animation is written as one file .webp, or as numbered PNGs in a folder, whose name does not end "
          "like that of a file",
          command.output);
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::path(command.output) / "deformation.vtu", ignored))
    throw_input_error("{}: holds the result of a run, which an animation would replace; choose another folder with -o",
                      command.output);
  OutputFolder folder(command.output, command.force);
  const ResultShapes<Dim> shapes = read_result_shapes<Dim>(command.folder);
  for (int i = 0; i < frames.n; ++i) {
    stop_if_wanted();
    write_file(folder.path_of(fmt::format("frame_{:04d}.png", i)),
               draw_result(shapes, view_of_frame(view, frames, i), CanvasKind::raster).bytes());
  }
  folder.commit();
}

template <int Dim>
void render(const RenderCommand& command, const ResultView& view, const Frames& frames) {
  if (Dim == 2 && frames.motion == Motion::turntable)
    throw_input_error("--motion turntable: {} is a result in the plane; morph is possible", command.folder);
  if (frames.motion != Motion::none)
    return is_one_file(command) ? write_animation<Dim>(command, view, frames)
                                : write_frames<Dim>(command, view, frames);
  const CanvasKind kind = kind_of(command.output);
  check_report_file(command.output, command.force);
  write_report_file(command.output, draw_result(read_result_shapes<Dim>(command.folder), view, kind).bytes(),
                    command.force);
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
  view.size = command.size.empty() ? 800 : whole_number(command.size, "--size", 50, 8000);
  const Frames frames = frames_of(command);
  if (deformation_dimension(command.folder) == 2) render<2>(command, view, frames);
  else render<3>(command, view, frames);
}

}  // namespace shellmatch
