#include "apps/commands.h"
#include "apps/terminal/progress.h"
#include "base/printable.h"
#include "base/text.h"
#include "geometry/io/picture_height.h"
#include "matching/input/shape_source.h"
#include "matching/pairs/slicer_points.h"
#include "matching/pairs/tps_specimens.h"
#include "matching/shape_report/inspection.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

namespace shellmatch {

namespace {

void inspect_points(const InspectCommand& command) {
  const SlicerPoints file = read_slicer_points(command.file);
  if (command.json) std::cout << slicer_points_json(file);
  else std::cout << slicer_points_text(file);
}

}  // namespace

void execute(const InspectCommand& command) {
  if (is_slicer_file(command.file)) return inspect_points(command);
  if (const auto specimens = listed_specimens(command.file)) {
    std::cout << (command.json ? specimens_json(command.file, *specimens) : specimens_text(command.file, *specimens));
    return;
  }
  Progress progress(isatty(STDERR_FILENO) != 0 ? Verbosity::normal : Verbosity::quiet, 0);
  progress.stage("reading");
  const AnyShape shape = open_shape(command.file, Closing::automatic);
  progress.stage("measuring");
  const Inspection inspection = std::visit([](const auto& s) { return inspect_shape(s); }, shape);
  progress.finished();
  std::cout << (command.json ? inspection_json(inspection) : inspection_text(inspection));
  if (const double height = command.json ? 0 : picture_height(command.file); height > 0)
    std::cout << fmt::format(
        "  y axis                upward, from 0 at the bottom of the picture to {:g} at its top, in pixels\n", height);
}

}  // namespace shellmatch
