#include "geometry/volume/volume_header.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/io/input_file.h"
#include "geometry/io/read_text.h"
#include "geometry/volume/volume_name.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

namespace shellmatch {

namespace {

// Deflate's best.
constexpr std::uintmax_t best_compression = 1032;

std::uintmax_t size_of(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw_input_error("{}: cannot be opened ({})", path, error.message());
  if (size == 0) throw_input_error("{}: the file is empty (0 bytes)", path);
  return size;
}

template <class T>
T number_at(const std::string& header, std::size_t offset, bool swapped) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, header.data() + offset, sizeof(T));
  if (swapped) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

// Offsets of https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h, and of nifti2.h.
void check_nifti(const std::string& path) {
  const std::string header = inflated_beginning(path, 540);
  const auto size_field = [&](bool swapped) { return header.size() < 4 ? 0 : number_at<std::int32_t>(header, 0, swapped); };
  const bool swapped = size_field(false) != 348 && size_field(false) != 540;
  const bool is_second = size_field(swapped) == 540;
  if ((!is_second && size_field(swapped) != 348) || header.size() < (is_second ? 540u : 348u))
    throw_input_error("{}: no NIfTI image: it does not begin with a NIfTI header of 348 bytes; export the volume again", path);
  const auto spacing = [&](std::size_t k) {
    return is_second ? number_at<double>(header, 104 + 8 * k, swapped) : static_cast<double>(number_at<float>(header, 76 + 4 * k, swapped));
  };
  for (std::size_t k = 1; k <= 3; ++k)
    if (!(std::isfinite(spacing(k)) && spacing(k) > 0))
      throw_input_error("{}: the spacing of its voxels along axis {} is {:g} (pixdim[{}]), and must be positive", path, k, spacing(k), k);
  const std::size_t first = is_second ? 352 : 256;  // quatern_b to srow_z
  for (std::size_t k = 0; k < 18; ++k) {
    const double value = is_second ? number_at<double>(header, first + 8 * k, swapped) : static_cast<double>(number_at<float>(header, first + 4 * k, swapped));
    if (!std::isfinite(value)) throw_input_error("{}: its position in space is not finite (quatern or srow of the header)", path);
  }
}

// The name that the header gives the file of its values; none where they follow the header.
std::optional<std::string> data_file_of(const std::string& path, VolumeFormat format) {
  constexpr std::size_t longest_header = 1 << 16;
  const std::string text = inflated_beginning(path, longest_header);
  LineReader lines(path, text, 0);
  while (lines.next_line()) {
    const std::string_view line = lines.line();
    if (format == VolumeFormat::nrrd && line.empty()) return std::nullopt;  // the header ends
    const std::size_t separator = line.find(format == VolumeFormat::nrrd ? ':' : '=');
    if (separator == line.npos) continue;
    std::string_view name = line.substr(0, separator), value = line.substr(separator + 1);
    while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
    while (value.starts_with(' ') || value.starts_with('\t')) value.remove_prefix(1);
    if (format == VolumeFormat::nrrd ? equals_ignoring_case(name, "data file") || equals_ignoring_case(name, "datafile")
                                     : equals_ignoring_case(name, "elementdatafile"))
      return equals_ignoring_case(value, "local") && format == VolumeFormat::meta_image ? std::nullopt : std::optional(std::string(value));
  }
  if (format == VolumeFormat::meta_image)
    throw_input_error("{}: no MetaImage: its header does not say where the values are (ElementDataFile); export the volume again", path);
  return std::nullopt;
}

}  // namespace

VolumeFormat volume_format(const std::string& path) {
  const std::string ending = file_extension(path);
  if (ending == ".nrrd" || ending == ".nhdr") return VolumeFormat::nrrd;
  if (ending == ".mha" || ending == ".mhd") return VolumeFormat::meta_image;
  if (is_volume_file(path)) return VolumeFormat::nifti;
  throw_input_error("{}: no volume by its ending; supported are {}", path, volume_endings);
}

VolumeSpace check_volume_header(const std::string& path) {
  const InputFile file(path);
  const VolumeFormat format = volume_format(path);
  std::uintmax_t bytes = size_of(path);
  if (format == VolumeFormat::nifti) {
    check_nifti(path);
    return {file_extension(path) == ".gz" ? bytes * best_compression : bytes, bytes};
  }
  const std::string beginning = inflated_beginning(path, 4);
  if (format == VolumeFormat::nrrd && beginning != "NRRD")
    throw_input_error("{}: no NRRD file: it does not begin with the word NRRD; export the volume again", path);
  if (const auto name = data_file_of(path, format)) {
    if (name->find('%') != name->npos || name->starts_with("LIST") || name->find(' ') != name->npos)
      throw_input_error("{}: its values are in several files ('{}'); export the volume as one file", path, printable(*name));
    const std::string data = (std::filesystem::path(path).parent_path() / *name).string();
    try {
      const InputFile values(data);
      bytes = size_of(data);
    } catch (const InputError& error) {
      throw_input_error("{}: the file that its header names for the values: {}", path, error.what());
    }
  }
  return {bytes * best_compression, bytes};
}

}  // namespace shellmatch
