#include "apps/commands.h"
#include "geometry/io/picture_height.h"
#include "matching/shape_report/inspection.h"
#include "matching/input/shape_source.h"

#include <fmt/format.h>

#include <iostream>

namespace shellmatch {

void execute(const InspectCommand& command) {
  const AnyShape shape = open_shape(command.file, Closing::automatic);
  const Inspection inspection = std::visit([](const auto& s) { return inspect_shape(s); }, shape);
  std::cout << (command.json ? inspection_json(inspection) : inspection_text(inspection));
  if (const double height = command.json ? 0 : picture_height(command.file); height > 0)
    std::cout << fmt::format("  y axis                upward, from 0 at the bottom of the picture to {:g} at its top, in pixels\n", height);
}

}  // namespace shellmatch
