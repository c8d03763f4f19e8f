#include "base/error.h"
#include "base/printable.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/volume_name.h"
#include "geometry/volume/zlib_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

// Takes values one by one, as numbers.
class ValueList {
 public:
  /// \param layer the one that is kept; none: the largest value of all
  ValueList(const std::string& path, const VolumeHeader& header, std::optional<std::size_t> layer, Volume& volume)
      : path_(path), header_(header), layer_(layer), volume_(volume) {}
  bool is_complete() const { return n_seen_ == volume_.grid.n_voxels() * static_cast<std::size_t>(header_.n_layers); }

  void add(double number) {
    const auto& size = volume_.grid.size;
    const std::size_t n = volume_.grid.n_voxels(), n_layers = static_cast<std::size_t>(header_.n_layers),
                      at = n_seen_++;
    const std::size_t i = header_.has_layers_first ? at / n_layers : at % n,
                      layer = header_.has_layers_first ? at % n_layers : at / n;
    if (layer_ && *layer_ != layer) return;
    const double value = header_.slope * number + header_.intercept;
    if (!std::isfinite(value) || std::abs(value) > 1e30)
      throw_input_error(
          "{}: voxel {} {} {} (counted from 0) is {}, no number that can be used; replace such voxels, by the "
          "background say",
          path_, i % size[0], i / size[0] % size[1], i / size[0] / size[1], value);
    if (is_integer(header_.type) && std::abs(number) > largest_label)
      throw_input_error("{}: voxel {} {} {} (counted from 0) is {:.0f}; whole numbers up to {:.0f} can be told apart",
                        path_, i % size[0], i / size[0] % size[1], i / size[0] / size[1], number, largest_label);
    const auto kept = static_cast<float>(value);
    if (i < volume_.values.size()) volume_.values[i] = std::max(volume_.values[i], kept);
    else volume_.values.push_back(kept);
  }

  void add_bytes(std::string_view bytes) {
    const ValueType type = value_type(header_.type);
    for (const double number : values_of(bytes, type, bytes.size() / bytes_of(type), header_.is_big_endian))
      add(number);
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
    while (!is_complete()) {
      const std::string_view word = next_word(text, " \t\r\n");
      if (word.empty()) return;
      const auto number = to_double(word);
      if (!number) throw_input_error("{}: value {} (counted from 0) is no number", path_, n_seen_);
      add(*number);
    }
  }

  const std::string& path_;
  const VolumeHeader& header_;
  std::optional<std::size_t> layer_;
  Volume& volume_;
  std::size_t n_seen_ = 0;
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
  ValueList values(path, header, {}, volume);
  for (const double number : numbers) values.add(number);
  return volume;
}

Volume read_volume(const std::string& path, const VolumeHeader& header, std::optional<std::size_t> layer) {
  Volume volume{header.grid, header.slope == 1 && header.intercept == 0 ? header.type : VoxelType::float32, {}};
  const std::size_t n = volume.grid.n_voxels(),
                    n_bytes = n * bytes_of(header.type) * static_cast<std::size_t>(header.n_layers);
  std::error_code error;
  const std::uintmax_t in_file = std::filesystem::file_size(header.file, error);
  // Deflate's best: a file that is not cut off holds no more. Nothing is allocated before that is known.
  constexpr std::uintmax_t best_compression = 1032;
  const auto cut_off = [&] {
    throw_input_error(
        "{}: cut off, or damaged: {} x {} x {} voxels take {} bytes, which the file, of {} bytes, does not hold", path,
        volume.grid.size[0], volume.grid.size[1], volume.grid.size[2], n_bytes, in_file);
  };
  if (error || n_bytes > (header.encoding == VolumeHeader::raw ? in_file : in_file * best_compression)) cut_off();
  volume.values.reserve(n);
  ValueList values(path, header, layer, volume);
  if (header.encoding == VolumeHeader::text) {
    for_each_piece(header.file, header.offset, false, 0, in_file,
                   [&](std::string_view piece) { values.add_text(piece); });
    values.end_text();
  } else {
    const bool is_whole = header.encoding == VolumeHeader::whole_file_deflated;
    for_each_piece(header.file, is_whole ? 0 : header.offset, header.encoding != VolumeHeader::raw,
                   is_whole ? header.offset : 0, n_bytes, [&](std::string_view piece) { values.add_bytes(piece); });
  }
  if (!values.is_complete()) cut_off();
  return volume;
}

std::string list_text(const std::vector<Segment>& segments) {
  std::string text;
  for (const Segment& segment : segments) {
    if (text.size() > 500) return text + ", ...";
    text += fmt::format("{}{}", text.empty() ? "" : ", ", printable(segment.name, 60));
  }
  return text;
}

const Segment& find_segment(const VolumeName& name, const VolumeHeader& header) {
  const std::string& wanted = name.choice.segment;
  const auto found = std::ranges::find(header.segments, wanted, &Segment::name);
  if (found == header.segments.end())
    throw_input_error("{}: has no segment '{}'; {}", name.file, printable(wanted, 60),
                      header.segments.empty() ? "it names no segments: choose labels, as in scan.nrrd:1,2"
                                              : "there are " + list_text(header.segments));
  if (std::ranges::count(header.segments, wanted, &Segment::name) > 1)
    throw_input_error("{}: has several segments '{}'; give each a name of its own", name.file, printable(wanted, 60));
  if (*found->layer < 0 || *found->layer >= header.n_layers)
    throw_input_error("{}: the segment '{}' is in layer {}, and there are {}; export the segmentation again", name.file,
                      printable(wanted, 60), *found->layer, header.n_layers);
  return *found;
}

}  // namespace

Volume read_volume(const std::string& path) {
  if (volume_format(path) == VolumeFormat::vti) return read_vti_volume(path);
  const VolumeHeader header = read_volume_header(path);
  if (header.n_layers > 1)
    throw_input_error(
        "{}: a segmentation in {} layers, which overlap; save the segments that are meant as a volume of labels", path,
        header.n_layers);
  return read_volume(path, header, {});
}

VolumePart read_volume_part(const VolumeName& name) {
  if (volume_format(name.file) != VolumeFormat::nrrd) return {read_volume(name.file), name.choice};
  const VolumeHeader header = read_volume_header(name.file);
  VolumePart part{{}, name.choice};
  std::optional<std::size_t> layer;
  if (!name.choice.segment.empty()) {
    const Segment& segment = find_segment(name, header);
    part.choice.labels = {static_cast<double>(*segment.label)};
    layer = static_cast<std::size_t>(*segment.layer);
  } else if (header.n_layers > 1 && !name.choice.labels.empty()) {
    throw_input_error(
        "{}: has {} layers, each with labels of its own; name the segment, as in scan.seg.nrrd:Femur: there are {}",
        name.file, header.n_layers, list_text(header.segments));
  }
  part.volume = read_volume(name.file, header, layer);
  return part;
}

}  // namespace shellmatch
