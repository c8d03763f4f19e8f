#include "apps/commands.h"
#include "matching/shape_report/inspection.h"
#include "matching/input/shape_source.h"

#include <iostream>

namespace shellmatch {

void execute(const InspectCommand& command) {
  const AnyShape shape = open_shape(command.file, Closing::automatic);
  const Inspection inspection = std::visit([](const auto& s) { return inspect_shape(s); }, shape);
  std::cout << (command.json ? inspection_json(inspection) : inspection_text(inspection));
}

}  // namespace shellmatch
