#include "tests/support/folders.h"

#include <cstdlib>

namespace shellmatch::test {

std::filesystem::path source_folder() { return SHELLMATCH_SOURCE_DIR; }

std::filesystem::path data_folder() {
  const char* const variable = std::getenv("SHELLMATCH_DATA");
  return variable ? std::filesystem::path(variable) : source_folder() / "../shared/data";
}

}  // namespace shellmatch::test
