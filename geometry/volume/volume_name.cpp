#include "geometry/volume/volume_name.h"

#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/io/read_text.h"
#include "geometry/volume/volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace shellmatch {

namespace {

bool has_ending(std::string_view path, std::string_view ending) {
  return path.size() > ending.size() && equals_ignoring_case(path.substr(path.size() - ending.size()), ending);
}

VoxelChoice parse_choice(std::string_view text, const std::string& source) {
  VoxelChoice choice;
  if (text.starts_with('>')) {
    const auto above = to_double(text.substr(1));
    if (!above || !std::isfinite(*above))
      throw_input_error("{}: '{}' after the last colon is no threshold; write a number, as in \"scan.nii.gz:>0.5\"", source, text);
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
  throw_input_error("{}: '{}' after the last colon names no labels; write whole numbers up to {:.0f}, as in scan.nii.gz:3 or scan.nii.gz:1,2, or a "
                    "threshold, as in \"scan.nii.gz:>0.5\"", source, text, largest_label);
}

}  // namespace

bool VoxelChoice::contains(float value) const {
  return labels.empty() ? value > above : std::ranges::find(labels, static_cast<double>(value)) != labels.end();
}

std::string VoxelChoice::text() const {
  if (labels.empty()) return fmt::format("everything above {:g}", above);
  return fmt::format("{} {:g}", labels.size() == 1 ? "label" : "labels", fmt::join(labels, ", "));
}

bool is_volume_file(const std::string& path) {
  return std::ranges::any_of(std::initializer_list<std::string_view>{".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti"},
                             [&](std::string_view ending) { return has_ending(path, ending); });
}

VolumeFormat volume_format(const std::string& path) {
  const std::string ending = file_extension(path);
  if (ending == ".nrrd" || ending == ".nhdr") return VolumeFormat::nrrd;
  if (ending == ".mha" || ending == ".mhd") return VolumeFormat::meta_image;
  if (ending == ".vti") return VolumeFormat::vti;
  if (is_volume_file(path)) return VolumeFormat::nifti;
  throw_input_error("{}: no volume by its ending; supported are {}", path, volume_endings);
}

std::optional<VolumeName> parse_volume_name(const std::string& source) {
  if (is_volume_file(source)) return VolumeName{source, {}};
  const std::size_t colon = source.rfind(':');
  if (colon == source.npos || !is_volume_file(source.substr(0, colon))) return std::nullopt;
  return VolumeName{source.substr(0, colon), parse_choice(std::string_view(source).substr(colon + 1), source)};
}

std::string file_of(const std::string& source) {
  const std::size_t colon = source.rfind(':');
  return colon != source.npos && is_volume_file(source.substr(0, colon)) ? source.substr(0, colon) : source;
}

}  // namespace shellmatch
