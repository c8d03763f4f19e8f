#pragma once
/// \file
/// What the library that reads and writes volumes does. Without our types of vectors: ITK brings an Eigen of its own, of another
/// version.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace shellmatch {

/// The type of a file's values.
enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

/// Whole numbers beyond this are not told apart: values are kept in single precision.
inline constexpr double largest_label = 16777216;

/// A header, unchecked; in LPS.
struct RawHeader {
  unsigned n_dimensions = 3;
  std::array<std::uint64_t, 3> size{1, 1, 1};
  bool is_series = false;                      ///< further dimensions have more than one element
  std::array<double, 3> origin{};              ///< centre of the first voxel
  std::array<std::array<double, 3>, 3> axes{};  ///< axes[k] leads to the next voxel along axis k
  unsigned n_components = 1;                   ///< numbers for each voxel
  std::optional<VoxelType> type;               ///< none where it is another one
  std::size_t value_bytes = 1;
};

/// A file that is being read. \throws InputError where it cannot be
class RawVolumeReader {
 public:
  explicit RawVolumeReader(const std::string& path);
  ~RawVolumeReader();
  RawVolumeReader(const RawVolumeReader&) = delete;
  RawVolumeReader& operator=(const RawVolumeReader&) = delete;

  const RawHeader& header() const { return header_; }
  /// \param to has room for all values
  void read(char* to) const;

 private:
  struct File;
  std::string path_;
  std::unique_ptr<File> file_;
  RawHeader header_;
};

/// \param path its ending says the format \param values in the header's type \return the library's complaint; empty where it was written
std::string write_raw_volume(const std::string& path, const RawHeader& header, const void* values);

}  // namespace shellmatch
