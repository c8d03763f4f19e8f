#include "cohorts/output/tps_file.h"

#include "base/error.h"

#include <fmt/format.h>

#include <iterator>

namespace shellmatch {

std::string tps_specimen(std::string_view name, std::span<const double> coordinates, std::size_t dimension) {
  SHELLMATCH_CHECK((dimension == 2 || dimension == 3) && coordinates.size() % dimension == 0, "points have 2 or 3 coordinates each");
  std::string text = fmt::format("LM{}={}\n", dimension == 3 ? "3" : "", coordinates.size() / dimension);
  for (std::size_t p = 0; p < coordinates.size(); p += dimension)
    fmt::format_to(std::back_inserter(text), "{}\n", fmt::join(coordinates.subspan(p, dimension), " "));
  return text + fmt::format("ID={}\n", name);
}

}  // namespace shellmatch
