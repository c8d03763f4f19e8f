#include "geometry/volume/volume_name.h"

#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/io/read_text.h"

#include <algorithm>
#include <string_view>

namespace shellmatch {

namespace {

bool has_ending(std::string_view path, std::string_view ending) {
  return path.size() > ending.size() && equals_ignoring_case(path.substr(path.size() - ending.size()), ending);
}

}  // namespace

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
  return VolumeName{source.substr(0, colon), parse_choice(std::string_view(source).substr(colon + 1), source, "scan.nii.gz")};
}

std::string file_of(const std::string& source) {
  const std::size_t colon = source.rfind(':');
  return colon != source.npos && is_volume_file(source.substr(0, colon)) ? source.substr(0, colon) : source;
}

}  // namespace shellmatch
