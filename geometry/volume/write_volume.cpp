#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/volume/nifti_placement.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/volume_name.h"
#include "geometry/volume/zlib_volume.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace shellmatch {

namespace {

template <class T>
void put(std::string& header, std::size_t offset, T value) {
  std::memcpy(header.data() + offset, &value, sizeof value);
}

// Both transforms and their codes as in the NIfTI that the grid is of, so that every program places both alike; for
// others the sform and, where the axes are orthogonal, the same as qform.
NiftiPlacement placement_of(const VoxelGrid& grid) {
  if (grid.file && grid.file->nifti) {
    VoxelGrid there = grid;
    GridFile unused;
    place_by_nifti("", *grid.file->nifti, there, unused);
    if (there.axes == grid.axes && there.origin == grid.origin) return *grid.file->nifti;
  }
  NiftiPlacement p;
  p.sform_code = 1;
  p.srow = grid.axes;
  p.srow_offset = grid.origin;
  p.pixdim = grid.axes.colwise().norm();
  Mat<3> rotation = grid.axes * p.pixdim.cwiseInverse().asDiagonal();
  const bool is_left_handed = rotation.determinant() < 0;
  if (is_left_handed) rotation.col(2) *= -1;
  p.qfac = is_left_handed ? -1 : 1;
  if ((rotation.transpose() * rotation - Mat<3>::Identity()).norm() < 1e-5) {
    p.qform_code = 1;
    Eigen::Quaterniond q(rotation);
    if (q.w() < 0) q.coeffs() *= -1;
    p.quatern = {q.x(), q.y(), q.z(), grid.origin[0], grid.origin[1], grid.origin[2]};
  }
  return p;
}

// The millimetres of the numbers of a file on these voxels, which has the unit of the file of its kind that they are
// of.
double unit_of_file(const VoxelGrid& grid, VolumeFormat format) {
  if (!grid.file || grid.unit != "mm" || grid.file->nifti.has_value() != (format == VolumeFormat::nifti)) return 1;
  return millimetres_of(grid.file->unit).value_or(1);
}

void divide_lengths(NiftiPlacement& p, double unit) {
  p.pixdim /= unit;
  for (std::size_t k = 3; k < 6; ++k) p.quatern[k] /= unit;
  p.srow /= unit;
  p.srow_offset /= unit;
}

// NIfTI-1. Lengths whose unit is known become millimetres, which all programs read alike, but on the voxels of a NIfTI
// they keep its unit, which programs do not read alike.
std::string nifti_header(VoxelGrid grid, VoxelType type, bool is_vector) {
  const double unit = unit_of_file(grid, VolumeFormat::nifti);
  const std::optional<double> millimetres = millimetres_of(grid.unit);
  grid.axes *= millimetres.value_or(1);
  grid.origin *= millimetres.value_or(1);
  static constexpr std::int16_t codes[] = {2, 256, 512, 4, 768, 8, 1280, 1024, 16, 64};  // in the order of VoxelType
  std::string h(352, '\0');
  put<std::int32_t>(h, 0, 348);
  const std::int16_t dim[8] = {static_cast<std::int16_t>(is_vector ? 5 : 3),
                               static_cast<std::int16_t>(grid.size[0]),
                               static_cast<std::int16_t>(grid.size[1]),
                               static_cast<std::int16_t>(grid.size[2]),
                               1,
                               static_cast<std::int16_t>(is_vector ? 3 : 1),
                               1,
                               1};
  for (std::size_t k = 0; k < 8; ++k) put(h, 40 + 2 * k, dim[k]);
  if (is_vector) put<std::int16_t>(h, 68, 1007);
  put(h, 70, codes[static_cast<std::size_t>(type)]);
  put(h, 72, static_cast<std::int16_t>(8 * bytes_of(type)));
  NiftiPlacement p = placement_of(grid);
  divide_lengths(p, unit);
  put(h, 76, static_cast<float>(p.qfac));
  for (std::size_t k = 0; k < 3; ++k) put(h, 80 + 4 * k, static_cast<float>(p.pixdim[static_cast<int>(k)]));
  for (std::size_t k = 3; k < 7; ++k) put(h, 80 + 4 * k, 1.0f);
  put(h, 108, 352.0f);
  put(h, 112, 1.0f);
  h[123] = unit == 1000 ? 1 : unit < 1 ? 3 : millimetres ? 2 : 0;  // metres, micrometres, millimetres, unknown
  put(h, 252, static_cast<std::int16_t>(p.qform_code));
  put(h, 254, static_cast<std::int16_t>(p.sform_code));
  for (std::size_t k = 0; k < 6; ++k) put(h, 256 + 4 * k, static_cast<float>(p.quatern[k]));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      put(h, 280 + 16 * i + 4 * j, static_cast<float>(p.srow(static_cast<int>(i), static_cast<int>(j))));
    put(h, 292 + 16 * i, static_cast<float>(p.srow_offset[static_cast<int>(i)]));
  }
  h.replace(344, 3, "n+1");
  return h;
}

std::string nrrd_header(const VoxelGrid& in_ras, VoxelType type, bool is_vector) {
  static constexpr const char* names[] = {"uint8", "int8",   "uint16", "int16", "uint32",
                                          "int32", "uint64", "int64",  "float", "double"};
  VoxelGrid grid = exchange_space(in_ras);
  // Vectors are in LPS, as ITK and ANTs read them.
  const bool is_las = !is_vector && in_ras.file && in_ras.file->space == "left-anterior-superior";
  if (is_las) {
    grid.axes.row(1) *= -1;
    grid.origin[1] *= -1;
  }
  if (const double unit = unit_of_file(grid, VolumeFormat::nrrd); unit != 1) {
    grid.unit = grid.file->unit;
    grid.axes /= unit;
    grid.origin /= unit;
  }
  const auto text = [](const Vec<3>& x) { return fmt::format("({},{},{})", x[0], x[1], x[2]); };
  const std::string units = grid.unit.empty() ? "" : fmt::format("space units: \"{0}\" \"{0}\" \"{0}\"\n", grid.unit);
  return fmt::format(
      "NRRD0004\ntype: {}\ndimension: {}\nspace: left-{}-superior\n{}sizes: {}{} {} {}\n"
      "space directions: {}{} {} {}\nkinds: {}domain domain domain\nendian: little\nencoding: gzip\nspace origin: "
      "{}\n\n",
      names[static_cast<std::size_t>(type)], is_vector ? 4 : 3, is_las ? "anterior" : "posterior", units,
      is_vector ? "3 " : "", grid.size[0], grid.size[1], grid.size[2], is_vector ? "none " : "", text(grid.axes.col(0)),
      text(grid.axes.col(1)), text(grid.axes.col(2)), is_vector ? "vector " : "", text(grid.origin));
}

std::string meta_image_header(const VoxelGrid& in_ras, VoxelType type, bool is_vector, std::size_t n_bytes) {
  static constexpr const char* names[] = {"UCHAR", "CHAR",       "USHORT",    "SHORT", "UINT",
                                          "INT",   "ULONG_LONG", "LONG_LONG", "FLOAT", "DOUBLE"};
  const VoxelGrid grid = exchange_space(in_ras);
  const Vec<3> spacing = grid.axes.colwise().norm();
  std::string directions;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) directions += fmt::format(" {}", grid.axes(i, k) / spacing[k]);
  return fmt::format(
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
      "True\nCompressedDataSize = {}\n"
      "TransformMatrix ={}\nOffset = {} {} {}\nCenterOfRotation = 0 0 0\nElementSpacing = {} {} {}\nDimSize = {} {} "
      "{}\n{}ElementType = MET_{}\n"
      "ElementDataFile = LOCAL\n",
      n_bytes, directions, grid.origin[0], grid.origin[1], grid.origin[2], spacing[0], spacing[1], spacing[2],
      grid.size[0], grid.size[1], grid.size[2], is_vector ? "ElementNumberOfChannels = 3\n" : "",
      names[static_cast<std::size_t>(type)]);
}

// Values follow as they are, after their number: VTK's own compression is by blocks.
std::string vti_file(const VoxelGrid& grid, VoxelType type, bool is_vector, const std::string& bytes) {
  static constexpr const char* names[] = {"UInt8", "Int8",   "UInt16", "Int16",   "UInt32",
                                          "Int32", "UInt64", "Int64",  "Float32", "Float64"};
  const Vec<3> spacing = grid.axes.colwise().norm();
  std::string direction;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      direction += fmt::format("{}{}", direction.empty() ? "" : " ", grid.axes(i, k) / spacing[k]);
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const char* name = is_vector ? "displacement" : "values";
  std::string file = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<ImageData WholeExtent=\"{0}\" Origin=\"{1} {2} {3}\" Spacing=\"{4} {5} {6}\" Direction=\"{7}\">\n<Piece "
      "Extent=\"{0}\">\n"
      "<PointData {8}=\"{9}\"><DataArray type=\"{10}\" Name=\"{9}\" NumberOfComponents=\"{11}\" format=\"appended\" "
      "offset=\"0\"/></PointData>\n"
      "<CellData/>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_",
      extent, grid.origin[0], grid.origin[1], grid.origin[2], spacing[0], spacing[1], spacing[2], direction,
      is_vector ? "Vectors" : "Scalars", name, names[static_cast<std::size_t>(type)], is_vector ? 3 : 1);
  const std::uint64_t n = bytes.size();
  file.append(reinterpret_cast<const char*>(&n), sizeof n);
  return file + bytes + "\n</AppendedData>\n</VTKFile>\n";
}

// \param bytes the values, voxel by voxel; for vectors in a NIfTI, component by component
PendingFile pending(const std::string& path, const VoxelGrid& grid, VoxelType type, bool is_vector, std::string bytes,
                    Existing existing) {
  check_volume_output(path);
  const bool is_compressed = file_extension(path) != ".nii";
  switch (volume_format(path)) {
    case VolumeFormat::nifti:
      for (const int n : grid.size)
        if (n > std::numeric_limits<std::int16_t>::max())
          throw_input_error("{}: NIfTI has at most 32767 voxels along an axis; write .nrrd or .mha", path);
      bytes.insert(0, nifti_header(grid, type, is_vector));
      if (is_compressed) bytes = deflated(bytes, Deflated::gzip);
      break;
    case VolumeFormat::nrrd: bytes = nrrd_header(grid, type, is_vector) + deflated(bytes, Deflated::gzip); break;
    case VolumeFormat::meta_image:
      bytes = deflated(bytes, Deflated::zlib);
      bytes.insert(0, meta_image_header(grid, type, is_vector, bytes.size()));
      break;
    case VolumeFormat::vti: bytes = vti_file(grid, type, is_vector, bytes); break;
  }
  return PendingFile(path, existing, bytes);
}

}  // namespace

void check_volume_output(const std::string& path) {
  const std::string ending = file_extension(path);
  if (!is_volume_file(path) || ending == ".nhdr" || ending == ".mhd")
    throw_input_error("{}: volumes are written as .nii, .nii.gz, .nrrd, .mha or .vti", path);
}

std::vector<std::string> volume_notes(const VoxelGrid& grid) {
  return grid.file ? grid.file->notes : std::vector<std::string>();
}

std::vector<std::string> written_notes(const std::string& path, const VoxelGrid& grid) {
  if (volume_format(path) != VolumeFormat::nifti || (grid.file && grid.file->nifti)) return {};
  if (itk_choice(placement_of(grid), grid.size) != ItkChoice::refused) return {};
  return {
      "its axes are not at right angles, which a NIfTI's qform cannot say: ITK, ANTs and 3D Slicer do not read it; "
      "they read an .nrrd"};
}

PendingFile volume_file(const std::string& path, const Volume& volume, Existing existing) {
  SHELLMATCH_CHECK(volume.values.size() == volume.grid.n_voxels(), "every voxel has a value");
  std::string bytes;
  bytes.reserve(volume.values.size() * bytes_of(volume.type));
  // Whole numbers are at most 2^24 in size.
  for (const float value : volume.values)
    append_value(bytes, value_type(volume.type),
                 is_integer(volume.type) ? std::clamp<double>(value, -largest_label, largest_label) : value);
  return pending(path, volume.grid, volume.type, false, std::move(bytes), existing);
}

PendingFile vector_volume_file(const std::string& path, const VoxelGrid& grid, std::span<const float> values,
                               Existing existing) {
  const std::size_t n = grid.n_voxels();
  SHELLMATCH_CHECK(values.size() == 3 * n, "every voxel has three components");
  const bool by_component = is_volume_file(path) && volume_format(path) == VolumeFormat::nifti;
  std::string bytes;
  bytes.reserve(values.size() * sizeof(float));
  // VTK's files name no frame: their components are along the axes of their positions, which are in RAS.
  const bool is_in_ras = is_volume_file(path) && volume_format(path) == VolumeFormat::vti;
  // Vectors are in the unit of their file, which other programs do not convert.
  const bool is_nrrd = is_volume_file(path) && volume_format(path) == VolumeFormat::nrrd;
  const auto factor = static_cast<float>(by_component ? millimetres_of(grid.unit).value_or(1)
                                         : is_nrrd    ? 1 / unit_of_file(grid, VolumeFormat::nrrd)
                                                      : 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float value = factor * values[by_component ? 3 * (i % n) + i / n : i];
    append_value(bytes, ValueType::float32, is_in_ras && i % 3 < 2 ? -value : value);
  }
  return pending(path, grid, VoxelType::float32, true, std::move(bytes), existing);
}

}  // namespace shellmatch
