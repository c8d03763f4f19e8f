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
void check_nifti(const std::string& path, VolumeData& data) {
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
  const std::uintmax_t least_offset = is_second ? 540 : 348;
  const double offset = is_second ? static_cast<double>(number_at<std::int64_t>(header, 168, swapped)) : static_cast<double>(number_at<float>(header, 108, swapped));
  data.offset = offset > static_cast<double>(least_offset) && offset < 1e9 ? static_cast<std::uintmax_t>(offset) : least_offset;
  data.voxel_bytes = static_cast<std::size_t>(std::max(0, number_at<std::int16_t>(header, is_second ? 14 : 72, swapped) / 8));
  if (file_extension(path) == ".gz") data.compression = VolumeData::of_file;
}

// What the header of an NRRD or a MetaImage says of its values.
struct DataFields {
  std::optional<std::string> file;  ///< none: they follow the header
  std::size_t header_bytes = 0;
  std::uintmax_t skipped = 0;
  bool is_compressed = false, is_text = false;
};

DataFields data_fields_of(const std::string& path, VolumeFormat format) {
  constexpr std::size_t longest_header = 1 << 16;
  const std::string text = inflated_beginning(path, longest_header);
  const bool is_nrrd = format == VolumeFormat::nrrd;
  DataFields fields;
  LineReader lines(path, text, 0);
  while (lines.next_line()) {
    const std::string_view line = lines.line();
    if (is_nrrd && line.empty()) return fields;  // the header ends
    const std::size_t separator = line.find(is_nrrd ? ':' : '=');
    if (separator == line.npos) continue;
    std::string_view name = line.substr(0, separator), value = line.substr(separator + 1);
    while (name.ends_with(' ') || name.ends_with('\t')) name.remove_suffix(1);
    while (value.starts_with(' ') || value.starts_with('\t')) value.remove_prefix(1);
    const auto is = [&](std::string_view field) { return equals_ignoring_case(name, field); };
    const bool is_true = equals_ignoring_case(value, "true") || value == "1";
    if (is_nrrd) {
      if (is("data file") || is("datafile")) fields.file = value;
    } else if (is("compresseddata")) {
      fields.is_compressed = is_true;
    } else if (is("binarydata")) {
      fields.is_text = !is_true;
    } else if (is("headersize")) {
      fields.skipped = static_cast<std::uintmax_t>(std::max<std::int64_t>(0, to_integer(value).value_or(0)));
    } else if (is("elementdatafile")) {
      if (!equals_ignoring_case(value, "local")) fields.file = value;
      fields.header_bytes = text.size() - lines.n_left();
      return fields;
    }
  }
  if (!is_nrrd)
    throw_input_error("{}: no MetaImage: its header does not say where the values are (ElementDataFile); export the volume again", path);
  return fields;
}

}  // namespace

VolumeData check_volume_header(const std::string& path) {
  const InputFile file(path);
  const VolumeFormat format = volume_format(path);
  VolumeData data{path, 0, VolumeData::none, size_of(path), 0};
  if (format == VolumeFormat::nifti) {
    check_nifti(path, data);
    return data;
  }
  if (format == VolumeFormat::nrrd && inflated_beginning(path, 4) != "NRRD")
    throw_input_error("{}: no NRRD file: it does not begin with the word NRRD; export the volume again", path);
  const DataFields fields = data_fields_of(path, format);
  data.offset = fields.file ? fields.skipped : fields.header_bytes;
  data.compression = fields.is_compressed ? VolumeData::of_values : VolumeData::none;
  if (fields.is_text) throw_input_error("{}: its values are written as text (BinaryData); save it with binary values", path);
  if (!fields.file) return data;
  const std::string& name = *fields.file;
  if (name.find('%') != name.npos || name.starts_with("LIST") || name.find(' ') != name.npos)
    throw_input_error("{}: its values are in several files ('{}'); export the volume as one file", path, printable(name));
  data.file = (std::filesystem::path(path).parent_path() / name).string();
  try {
    const InputFile values(data.file);
    data.file_bytes = size_of(data.file);
  } catch (const InputError& error) {
    throw_input_error("{}: the file that its header names for the values: {}", path, error.what());
  }
  return data;
}

std::uintmax_t most_value_bytes(const VolumeData& data) { return data.file_bytes * best_compression; }

bool has_values(const VolumeData& data, std::uintmax_t n_bytes) {
  if (data.compression == VolumeData::none) return data.file_bytes >= data.offset + n_bytes;
  const bool is_whole = data.compression == VolumeData::of_file;
  const std::uintmax_t wanted = n_bytes + (is_whole ? data.offset : 0);
  return inflated_bytes(data.file, is_whole ? 0 : data.offset, wanted) == wanted;
}

}  // namespace shellmatch
