// NIfTI-1 and NIfTI-2 in one file: https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h and nifti2.h, whose names
// are used here.
#include "base/error.h"
#include "geometry/volume/nifti_placement.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/zlib_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

class NiftiFields {
 public:
  NiftiFields(const std::string& path) : path_(path), bytes_(inflated_beginning(path, 544)) {
    const auto size = [&] { return bytes_.size() < 4 ? 0 : number<std::int32_t>(0); };
    if (size() != 348 && size() != 540) swapped_ = true;
    is_second_ = size() == 540;
    if ((size() != 348 && size() != 540) || bytes_.size() < (is_second_ ? 540u : 348u))
      throw_input_error(
          "{}: no NIfTI image: it does not begin with a NIfTI header of 348 bytes; export the volume again", path);
    if (bytes_.substr(is_second_ ? 4 : 344, 2) == "ni")
      throw_input_error("{}: the header of a NIfTI image whose values are in another file (.img); save it as one file",
                        path);
  }
  bool is_big_endian() const { return swapped_; }  // on a machine that is not
  // Fields of floating point numbers have 4 bytes in the first version and 8 in the second.
  double real(std::size_t first, std::size_t second, std::size_t k) const {
    return is_second_ ? number<double>(second + 8 * k) : static_cast<double>(number<float>(first + 4 * k));
  }
  std::int64_t dim(std::size_t k) const {
    return is_second_ ? number<std::int64_t>(16 + 8 * k) : number<std::int16_t>(40 + 2 * k);
  }
  int datatype() const { return number<std::int16_t>(is_second_ ? 12 : 70); }
  int bitpix() const { return number<std::int16_t>(is_second_ ? 14 : 72); }
  int code(std::size_t first, std::size_t second) const {
    return is_second_ ? number<std::int32_t>(second) : number<std::int16_t>(first);
  }
  int units() const { return is_second_ ? number<std::int32_t>(500) : bytes_[123]; }
  std::uintmax_t offset() const {
    const double least = is_second_ ? 540 : 348;
    const double offset =
        is_second_ ? static_cast<double>(number<std::int64_t>(168)) : static_cast<double>(number<float>(108));
    if (!(offset >= least && offset < 1e9))
      throw_input_error("{}: its values begin at byte {:g} (vox_offset), which cannot be; export the volume again",
                        path_, offset);
    return static_cast<std::uintmax_t>(offset);
  }

 private:
  template <class T>
  T number(std::size_t offset) const {
    char bytes[sizeof(T)];
    std::memcpy(bytes, bytes_.data() + offset, sizeof(T));
    if (swapped_) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }
  const std::string& path_;
  std::string bytes_;
  bool swapped_ = false, is_second_ = false;
};

VoxelType type_of(const std::string& path, int datatype) {
  switch (datatype) {
    case 2: return VoxelType::uint8;
    case 4: return VoxelType::int16;
    case 8: return VoxelType::int32;
    case 16: return VoxelType::float32;
    case 64: return VoxelType::float64;
    case 256: return VoxelType::int8;
    case 512: return VoxelType::uint16;
    case 768: return VoxelType::uint32;
    case 1024: return VoxelType::int64;
    case 1280: return VoxelType::uint64;
    default:
      throw_input_error(
          "{}: its type of values (datatype {}) is not supported; save it with integers or floating point numbers",
          path, datatype);
  }
}

NiftiPlacement placement_of(const std::string& path, const NiftiFields& fields) {
  const int unit = fields.units() & 7;
  const double millimetres = unit == 1 ? 1000 : unit == 3 ? 0.001 : 1;
  NiftiPlacement p;
  p.qform_code = fields.code(252, 344);
  p.sform_code = fields.code(254, 348);
  p.qfac = fields.real(76, 104, 0) < 0 ? -1 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double spacing = fields.real(76, 104, k + 1);
    if (!(std::isfinite(spacing) && spacing > 0))
      throw_input_error("{}: the spacing of its voxels along axis {} is {:g} (pixdim[{}]), and must be positive", path,
                        k + 1, spacing, k + 1);
    p.pixdim[static_cast<int>(k)] = millimetres * spacing;
  }
  for (std::size_t k = 0; k < 6; ++k) p.quatern[k] = (k < 3 ? 1 : millimetres) * fields.real(256, 352, k);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      p.srow(static_cast<int>(i), static_cast<int>(j)) = millimetres * fields.real(280, 400, 4 * i + j);
    p.srow_offset[static_cast<int>(i)] = millimetres * fields.real(280, 400, 4 * i + 3);
  }
  return p;
}

}  // namespace

VolumeHeader read_nifti_header(const std::string& path) {
  const NiftiFields fields(path);
  const std::int64_t n_dimensions = fields.dim(0);
  if (n_dimensions < 1 || n_dimensions > 7)
    throw_input_error("{}: has {} dimensions (dim[0]); export the volume again", path, n_dimensions);
  std::vector<std::int64_t> size;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(n_dimensions); ++k) {
    if (k > 3 && fields.dim(k) > 1)
      k == 5
          ? throw_input_error("{}: has {} numbers for each voxel; a volume with one is wanted", path, fields.dim(k))
          : throw_input_error("{}: has {} dimensions; save one of its volumes as a file of three", path, n_dimensions);
    if (k <= 3) size.push_back(fields.dim(k));
  }
  VolumeHeader header;
  set_size(path, size, header.grid);
  header.type = type_of(path, fields.datatype());
  GridFile file;
  file.nifti = placement_of(path, fields);
  if (const int unit = fields.units() & 7; unit == 1 || unit == 3) {
    file.unit = unit == 1 ? "m" : "um";
    file.notes.push_back(
        fmt::format("its numbers are in {}, as it says, and turned into millimetres; nibabel leaves them as they are, "
                    "and ITK before 5.4 turns the size of voxels alone, not where they begin",
                    file.unit));
  }
  place_by_nifti(path, *file.nifti, header.grid, file);
  if (const int bits = fields.bitpix(), wanted = static_cast<int>(8 * bytes_of(header.type));
      bits != 0 && bits != wanted)
    file.notes.push_back(
        fmt::format("its header contradicts itself: {} bits for each voxel (bitpix), and a type of {} (datatype {}), "
                    "by which it is read",
                    bits, wanted, fields.datatype()));
  header.grid.file = std::make_shared<const GridFile>(std::move(file));
  const double slope = fields.real(112, 176, 0), intercept = fields.real(116, 184, 0);
  if (slope != 0 && std::isfinite(slope) && std::isfinite(intercept))
    header.slope = slope, header.intercept = intercept;
  if (const int unit = fields.units() & 7; unit >= 1 && unit <= 3)
    header.grid.unit = "mm";  // placement_of() has made it so
  header.file = path;
  header.offset = fields.offset();
  header.is_big_endian = fields.is_big_endian();
  if (is_gzip_file(path)) header.encoding = VolumeHeader::whole_file_deflated;
  return header;
}

}  // namespace shellmatch
