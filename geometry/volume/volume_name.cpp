#include "geometry/volume/volume_name.h"

#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_text.h"

#include <algorithm>
#include <string_view>

namespace shellmatch {

namespace {

bool has_ending(std::string_view path, std::string_view ending) {
  return path.size() > ending.size() && equals_ignoring_case(path.substr(path.size() - ending.size()), ending);
}

// What is no list of whole numbers and no threshold is the name of a segment, which an NRRD may have.
bool is_segment(std::string_view text, const std::string& file) {
  return volume_format(file) == VolumeFormat::nrrd && !text.starts_with('>') &&
         text.find_first_not_of("+-0123456789,") != text.npos;
}

}  // namespace

bool is_volume_file(const std::string& path) {
  return std::ranges::any_of(
      std::initializer_list<std::string_view>{".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd", ".vti"},
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
  VolumeName name{source.substr(0, colon), {}};
  const std::string_view text = std::string_view(source).substr(colon + 1);
  if (is_segment(text, name.file)) name.choice.segment = text;
  else name.choice = parse_choice(text, source, "scan.nii.gz");
  return name;
}

std::string file_of(const std::string& source) {
  const std::size_t colon = source.rfind(':');
  return colon != source.npos && is_volume_file(source.substr(0, colon)) ? source.substr(0, colon) : source;
}

}  // namespace shellmatch
