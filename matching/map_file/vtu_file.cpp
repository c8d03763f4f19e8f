#include "matching/map_file/vtu_file.h"

#include "base/error.h"
#include "geometry/vtk_xml/inflate.h"
#include "geometry/vtk_xml/xml_head.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace shellmatch {

namespace {

static_assert(std::endian::native == std::endian::little);

// Limits what a head can ask for; 2^40 nodes are more than any grid has.
constexpr std::int64_t max_count = std::int64_t{1} << 40;

// Names are compared pair by pair.
constexpr std::size_t max_arrays = 1000;

template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<T, double>) return "Float64";
  else if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  else if constexpr (std::is_same_v<T, std::int64_t>) return "Int64";
  else return "UInt8";
}

// A count or an offset: digits, and blanks with which VTK fills up.
std::optional<std::int64_t> to_count(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || value < 0 || value > max_count)
    return std::nullopt;
  return value;
}

std::uint64_t word_at(std::string_view bytes, std::size_t place) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + place, sizeof word);
  return word;
}

bool is_section(std::string_view name) {
  constexpr std::array sections = {"FieldData", "PointData", "CellData", "Points", "Cells"};
  return std::ranges::find(sections, name) != sections.end();
}

}  // namespace

void VtuFile::damaged(std::string_view why) const {
  throw_input_error(
      "{}: damaged, cut off, or no deformation that this program wrote ({}); give the deformation.vtu of an "
      "output folder, or the folder",
      path_, why);
}

VtuFile::VtuFile(std::string path, std::string bytes) : path_(std::move(path)), bytes_(std::move(bytes)) {
  std::string_view rest = bytes_;
  const auto count = [&](const XmlTag& tag, std::string_view key, std::int64_t otherwise) {
    const auto text = tag.find(key);
    if (!text) return otherwise;
    const auto value = to_count(*text);
    if (!value) damaged(fmt::format("the attribute {}", key));
    return *value;
  };
  const auto demand = [&](const XmlTag& tag, std::string_view key, std::string_view value) {
    if (tag.find(key).value_or("") != value) damaged(fmt::format("the attribute {} is not {}", key, value));
  };
  std::vector<std::string_view> open;
  bool is_grid = false, has_piece = false, has_data = false;
  while (!has_data) {
    const std::optional<XmlTag> tag = next_tag(rest);
    if (!tag) damaged("its head is no XML");
    if (tag->closes) {
      if (open.empty() || open.back() != tag->name) damaged("its tags do not match");
      open.pop_back();
      continue;
    }
    if (tag->name == "VTKFile") {
      if (!open.empty() || is_grid) damaged("a second VTKFile");
      demand(*tag, "type", "UnstructuredGrid");
      demand(*tag, "byte_order", "LittleEndian");
      demand(*tag, "header_type", "UInt64");
      demand(*tag, "compressor", "vtkZLibDataCompressor");
      is_grid = true;
    } else if (!is_grid) {
      damaged("it is no VTKFile");
    } else if (tag->name == "Piece") {
      if (std::exchange(has_piece, true)) damaged("a second Piece");
      n_points_ = count(*tag, "NumberOfPoints", 0);
      n_cells_ = count(*tag, "NumberOfCells", 0);
    } else if (tag->name == "DataArray" || tag->name == "Array") {
      if (open.empty() || !is_section(open.back())) damaged("an array in no section");
      demand(*tag, "format", "appended");
      VtuArray array{std::string(open.back()), std::string(tag->find("Name").value_or("")),
                     std::string(tag->find("type").value_or("")), count(*tag, "NumberOfComponents", 1),
                     static_cast<std::size_t>(count(*tag, "offset", max_count))};
      if (find(array.section, array.name) != nullptr)
        damaged(fmt::format("two arrays of one name in {}", array.section));
      if (arrays_.size() == max_arrays) damaged("more arrays than it can have");
      arrays_.push_back(std::move(array));
    } else if (tag->name == "AppendedData") {
      demand(*tag, "encoding", "raw");
      has_data = true;
    }
    if (!tag->is_complete) open.push_back(tag->name);
  }
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
  if (!has_piece || !rest.starts_with('_')) damaged("it has no data");
  data_ = rest.substr(1);
}

const VtuArray* VtuFile::find(std::string_view section, std::string_view name) const {
  const auto found =
      std::ranges::find_if(arrays_, [&](const VtuArray& a) { return a.section == section && a.name == name; });
  return found == arrays_.end() ? nullptr : &*found;
}

// An array is the numbers of blocks, of bytes of a full block and of the last one (0 if that is full), the packed sizes
// of the blocks, and the blocks.
std::size_t VtuFile::packed_size(const VtuArray& array, std::size_t n_bytes) const {
  constexpr std::size_t word = sizeof(std::uint64_t), n_head = 3 * word;
  if (array.offset > data_.size() || data_.size() - array.offset < n_head) damaged(array.name);
  const std::string_view head = data_.substr(array.offset);
  const std::uint64_t n_blocks = word_at(head, 0), full = word_at(head, word), last = word_at(head, 2 * word);
  if (n_blocks > (head.size() - n_head) / word || last > full) damaged(array.name);
  // No product below exceeds 2^64: each block has a packed size, so that there are fewer than bytes in the file.
  if (n_blocks > 0 && full > std::numeric_limits<std::uint64_t>::max() / n_blocks) damaged(array.name);
  if (n_blocks * full - (n_blocks > 0 && last > 0 ? full - last : 0) != n_bytes) damaged(array.name);
  std::size_t packed = 0;
  for (std::uint64_t i = 0; i < n_blocks; ++i) {
    const std::uint64_t size = word_at(head, n_head + i * word);
    if (size > head.size() - n_head - n_blocks * word - packed) damaged(array.name);
    packed += size;
  }
  return packed;
}

void VtuFile::expand(const VtuArray& array, char* out, std::size_t n_bytes) const {
  constexpr std::size_t word = sizeof(std::uint64_t);
  const std::string_view head = data_.substr(array.offset);
  const std::uint64_t n_blocks = word_at(head, 0), full = word_at(head, word);
  std::string_view packed = head.substr((3 + n_blocks) * word);
  for (std::uint64_t i = 0; i < n_blocks; ++i) {
    const std::size_t size = word_at(head, (3 + i) * word), n = std::min<std::size_t>(full, n_bytes);
    if (!inflate_exactly(packed.substr(0, size), out, n)) damaged(array.name);
    packed.remove_prefix(size);
    out += n;
    n_bytes -= n;
  }
}

template <class T>
std::vector<T> VtuFile::values(std::string_view section, std::string_view name, std::int64_t n_components,
                               std::int64_t n_tuples) const {
  const VtuArray* array = find(section, name);
  if (array == nullptr || array->type != type_name<T>() || array->n_components != n_components) damaged(name);
  SHELLMATCH_CHECK(n_components > 0 && n_components < 100 && n_tuples >= 0 && n_tuples <= max_count,
                   "an array has a size");
  const std::size_t n = static_cast<std::size_t>(n_components) * static_cast<std::size_t>(n_tuples),
                    n_bytes = n * sizeof(T);
  // Memory is taken only for what the packed bytes can hold.
  if (n_bytes / max_expansion > packed_size(*array, n_bytes)) damaged(name);
  std::vector<T> values(n);
  expand(*array, reinterpret_cast<char*>(values.data()), n_bytes);
  if constexpr (std::is_floating_point_v<T>)
    if (!std::ranges::all_of(values, [](T x) { return std::isfinite(x); })) damaged(name);
  return values;
}

template std::vector<double> VtuFile::values(std::string_view, std::string_view, std::int64_t, std::int64_t) const;
template std::vector<std::int32_t> VtuFile::values(std::string_view, std::string_view, std::int64_t,
                                                   std::int64_t) const;
template std::vector<std::int64_t> VtuFile::values(std::string_view, std::string_view, std::int64_t,
                                                   std::int64_t) const;
template std::vector<std::uint8_t> VtuFile::values(std::string_view, std::string_view, std::int64_t,
                                                   std::int64_t) const;

}  // namespace shellmatch
