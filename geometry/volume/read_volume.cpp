#include "base/error.h"
#include "geometry/io/read_text.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/volume_name.h"
#include "geometry/volume/zlib_volume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

namespace shellmatch {

namespace {

// Takes values one by one, as numbers.
class ValueList {
 public:
  ValueList(const std::string& path, const VolumeHeader& header, Volume& volume) : path_(path), header_(header), volume_(volume) {}

  void add(double number) {
    const std::size_t i = volume_.values.size();
    const auto& size = volume_.grid.size;
    const double value = header_.slope * number + header_.intercept;
    if (!std::isfinite(value) || std::abs(value) > 1e30)
      throw_input_error("{}: voxel {} {} {} (counted from 0) is {}, no number that can be used; replace such voxels, by the background say", path_, i % size[0],
                        i / size[0] % size[1], i / size[0] / size[1], value);
    if (is_integer(header_.type) && std::abs(number) > largest_label)
      throw_input_error("{}: voxel {} {} {} (counted from 0) is {:.0f}; whole numbers up to {:.0f} can be told apart", path_, i % size[0], i / size[0] % size[1],
                        i / size[0] / size[1], number, largest_label);
    volume_.values.push_back(static_cast<float>(value));
  }

  template <class T>
  void add_all(std::string_view bytes) {
    for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
      char one[sizeof(T)];
      std::memcpy(one, bytes.data() + at, sizeof(T));
      if (header_.is_big_endian) std::reverse(one, one + sizeof(T));
      T value;
      std::memcpy(&value, one, sizeof(T));
      add(static_cast<double>(value));
    }
  }

  void add_bytes(std::string_view bytes) {
    switch (header_.type) {
      case VoxelType::uint8: return add_all<std::uint8_t>(bytes);
      case VoxelType::int8: return add_all<std::int8_t>(bytes);
      case VoxelType::uint16: return add_all<std::uint16_t>(bytes);
      case VoxelType::int16: return add_all<std::int16_t>(bytes);
      case VoxelType::uint32: return add_all<std::uint32_t>(bytes);
      case VoxelType::int32: return add_all<std::int32_t>(bytes);
      case VoxelType::uint64: return add_all<std::uint64_t>(bytes);
      case VoxelType::int64: return add_all<std::int64_t>(bytes);
      case VoxelType::float32: return add_all<float>(bytes);
      case VoxelType::float64: return add_all<double>(bytes);
    }
  }

  // Numbers as text, of which a piece may hold a part.
  void add_text(std::string_view piece) {
    rest_ += piece;
    const std::size_t end = rest_.find_last_of(" \t\r\n");
    if (end == rest_.npos) {
      if (rest_.size() > 1000) throw_input_error("{}: its values are no numbers between blanks", path_);
      return;
    }
    add_words(std::string_view(rest_).substr(0, end));
    rest_.erase(0, end);
  }
  void end_text() { add_words(std::exchange(rest_, {})); }

 private:
  void add_words(std::string_view text) {
    while (volume_.values.size() < volume_.grid.n_voxels()) {
      const std::string_view word = next_word(text, " \t\r\n");
      if (word.empty()) return;
      const auto number = to_double(word);
      if (!number) throw_input_error("{}: value {} (counted from 0) is no number", path_, volume_.values.size());
      add(*number);
    }
  }

  const std::string& path_;
  const VolumeHeader& header_;
  Volume& volume_;
  std::string rest_;
};

}  // namespace

VoxelGrid read_voxel_grid(const std::string& path) { return read_volume_header(path).grid; }

namespace {

Volume read_vti_volume(const std::string& path) {
  const auto [header, numbers] = read_vti(path, true);
  check_frame(path, header.grid);
  Volume volume{header.grid, header.type, {}};
  volume.values.reserve(numbers.size());
  ValueList values(path, header, volume);
  for (const double number : numbers) values.add(number);
  return volume;
}

}  // namespace

Volume read_volume(const std::string& path) {
  if (volume_format(path) == VolumeFormat::vti) return read_vti_volume(path);
  const VolumeHeader header = read_volume_header(path);
  Volume volume{header.grid, header.slope == 1 && header.intercept == 0 ? header.type : VoxelType::float32, {}};
  const std::size_t n = volume.grid.n_voxels(), n_bytes = n * bytes_of(header.type);
  std::error_code error;
  const std::uintmax_t in_file = std::filesystem::file_size(header.file, error);
  // Deflate's best: a file that is not cut off holds no more. Nothing is allocated before that is known.
  constexpr std::uintmax_t best_compression = 1032;
  const auto cut_off = [&] {
    throw_input_error("{}: cut off, or damaged: {} x {} x {} voxels take {} bytes, which the file, of {} bytes, does not hold", path, volume.grid.size[0],
                      volume.grid.size[1], volume.grid.size[2], n_bytes, in_file);
  };
  if (error || n_bytes > (header.encoding == VolumeHeader::raw ? in_file : in_file * best_compression)) cut_off();
  volume.values.reserve(n);
  ValueList values(path, header, volume);
  if (header.encoding == VolumeHeader::text) {
    for_each_piece(header.file, header.offset, false, 0, in_file, [&](std::string_view piece) { values.add_text(piece); });
    values.end_text();
  } else {
    const bool is_whole = header.encoding == VolumeHeader::whole_file_deflated;
    for_each_piece(header.file, is_whole ? 0 : header.offset, header.encoding != VolumeHeader::raw, is_whole ? header.offset : 0, n_bytes,
                   [&](std::string_view piece) { values.add_bytes(piece); });
  }
  if (volume.values.size() != n) cut_off();
  return volume;
}

}  // namespace shellmatch
