#include "base/text.h"

#include <fmt/format.h>

namespace shellmatch {

std::string counted(std::size_t n, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", n, n == 1 ? singular : plural);
}

}  // namespace shellmatch
