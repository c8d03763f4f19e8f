#include "geometry/picture/label_choice.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/mesh_text/read_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shellmatch {

VoxelChoice parse_choice(std::string_view text, const std::string& source, std::string_view example) {
  VoxelChoice choice;
  if (text.starts_with('>')) {
    const auto above = to_double(text.substr(1));
    if (!above || !std::isfinite(*above))
      throw_input_error("{}: '{}' after the last colon is no threshold; write a number, as in \"{}:>0.5\"", source,
                        text, example);
    choice.above = *above;
    return choice;
  }
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t comma = rest.find(',');
    const auto label = to_integer(rest.substr(0, comma));
    if (!label || std::abs(static_cast<double>(*label)) > largest_label) {
      choice.labels.clear();
      break;
    }
    choice.labels.push_back(static_cast<double>(*label));
    if (comma == rest.npos) return choice;
    rest.remove_prefix(comma + 1);
  }
  throw_input_error(
      "{0}: '{1}' after the last colon names no labels; write whole numbers up to {2:.0f}, as in {3}:3 or {3}:1,2, or "
      "a "
      "threshold, as in \"{3}:>0.5\"",
      source, text, largest_label, example);
}

bool VoxelChoice::contains(float value) const {
  return labels.empty() ? value > above : std::ranges::find(labels, static_cast<double>(value)) != labels.end();
}

std::string VoxelChoice::text() const {
  if (!segment.empty()) return fmt::format("segment {}", printable(segment, 60));
  if (labels.empty()) return fmt::format("everything above {:g}", above);
  return fmt::format("{} {:g}", labels.size() == 1 ? "label" : "labels", fmt::join(labels, ", "));
}

}  // namespace shellmatch
