#include "apps/versions_text.h"

#include "matching/progress/linked_libraries.h"
#include "matching/progress/process_info.h"
#include "apps/studies/execution/revision.h"

#include <fmt/format.h>

namespace shellmatch {

std::string versions_text() {
  const std::string revision = build_revision();
  std::string text =
      fmt::format("shellmatch {}{}, made by {}\nlicence: GPL-3.0-or-later\nvector code: {}\n\n", program_version(),
                  revision.empty() ? "" : fmt::format(" ({})", revision), compiler_name(), vector_code());
  constexpr const char* row = "{:<14} {:<10} {:<20} {}\n";
  text += fmt::format(row, "library", "version", "binds", "licence");
  for (const LinkedLibrary& library : linked_libraries())
    text += fmt::format(row, library.name, library.version, library.binds, library.licence);
  return text + "\n'binds' is what a library asks of a distributed program; docs/licences.md says what follows.\n";
}

}  // namespace shellmatch
