// VTK's XML format of polygonal data: pieces, each with points, cells and their arrays.

#include "geometry/polydata/polydata.h"
#include "geometry/polydata/xml_array.h"
#include "geometry/polydata/xml_head.h"

#include "base/error.h"
#include "base/printable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

constexpr std::size_t max_xml_arrays = 1000;

struct XmlPiece {
  std::size_t n_points = 0;
  std::map<std::string, std::size_t, std::less<>> n_cells;  // by section: Verts, Lines, Strips, Polys
  std::map<std::string, std::vector<XmlArray>, std::less<>> sections;
};

class VtpFile {
 public:
  VtpFile(const std::string& path, std::string_view bytes) : path_(path), rest_(bytes) {}

  OriginalShape<3> read(std::vector<std::string>& notes) {
    read_tags();
    PolyData data(path_);
    for (const XmlPiece& piece : pieces_) add_piece(piece, data, notes);
    if (data.n_points() == 0) throw_input_error("{}: no points in it", path_);
    add_point_data(data);
    data.shape().space = space_;
    return data.finish(notes);
  }

 private:
  [[noreturn]] void damaged(std::string_view why) const {
    throw_input_error("{}: damaged, cut off, or no VTK file of polygonal data ({})", path_, printable(why));
  }

  std::size_t number(const XmlTag& tag, std::string_view key, std::size_t otherwise) const {
    auto text = tag.find(key);
    if (!text) return otherwise;
    while (!text->empty() && text->back() == ' ') text->remove_suffix(1);
    std::size_t value = 0;
    constexpr std::size_t most = std::size_t{1} << 40;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
    if (text->empty() || error != std::errc() || end != text->data() + text->size() || value > most) damaged(fmt::format("the attribute {}", key));
    return value;
  }

  void read_root(const XmlTag& tag) {
    if (const auto type = tag.find("type").value_or(""); type != "PolyData")
      throw_input_error("{}: a VTK file of type '{}'; a surface is of type PolyData (in ParaView: Extract Surface, save as .vtp)", path_, printable(type, 40));
    encoding_.is_big_endian = tag.find("byte_order").value_or("LittleEndian") == "BigEndian";
    encoding_.header_bytes = tag.find("header_type").value_or("UInt32") == "UInt64" ? 8 : 4;
    const std::string_view compressor = tag.find("compressor").value_or("");
    encoding_.is_compressed = !compressor.empty();
    if (encoding_.is_compressed && compressor != "vtkZLibDataCompressor")
      throw_input_error("{}: compressed by {}; save it without compression or with zlib", path_, printable(compressor, 40));
  }

  // The text of an element that is open, before or after elements within.
  std::string_view text_within(std::string_view name) const {
    std::string_view inner = rest_.substr(0, rest_.find(fmt::format("</{}", name)));
    const std::size_t last = inner.rfind('>');
    if (last == inner.npos) return inner;
    const std::string_view after = inner.substr(last + 1);
    return after.find_first_not_of(" \t\r\n") == after.npos ? inner.substr(0, inner.find('<')) : after;
  }

  void read_array(const XmlTag& tag, std::string_view section) {
    XmlArray array;
    array.name = tag.find("Name").value_or("");
    const std::string_view type = tag.find("type").value_or(""), format = tag.find("format").value_or("ascii");
    if (format == "appended") array.format = XmlFormat::appended;
    else if (format == "binary") array.format = XmlFormat::binary;
    else if (format != "ascii") damaged(fmt::format("the format {}", format));
    array.n_components = number(tag, "NumberOfComponents", 1);
    if (array.n_components == 0 || array.n_components > max_columns) damaged(fmt::format("the components of '{}'", array.name));
    if (++n_arrays_ > max_xml_arrays) damaged("more arrays than can be used");
    array.content = tag.is_complete ? std::string_view() : text_within(tag.name);
    if (section == "FieldData") return read_fact(array, type, tag);
    const std::optional<ValueType> known = xml_type(type);
    const bool is_data = section == "PointData" || section == "CellData";
    if (!known && is_data) {
      if (section == "PointData") dropped_.push_back(fmt::format("point data '{}' of type {} dropped", printable(array.name), printable(type, 40)));
      return;
    }
    if (!known) damaged(fmt::format("an array of type {}", type));
    array.type = *known;
    if (section == "CellData") has_cell_data_ = true;
    if (array.format == XmlFormat::appended) {
      offsets_.push_back(number(tag, "offset", std::size_t{1} << 40));
      array.content = {};
    }
    if (pieces_.empty() || section.empty()) damaged("an array in no piece");
    if (section == "CellData") {
      if (array.format == XmlFormat::appended) appended_.push_back({no_piece, {}, 0});
      return;
    }
    std::vector<XmlArray>& arrays = pieces_.back().sections[std::string(section)];
    if (array.format == XmlFormat::appended) appended_.push_back({pieces_.size() - 1, std::string(section), arrays.size()});
    arrays.push_back(std::move(array));
  }

  // 3D Slicer names the frame in the data of the whole, as a list of the numbers of characters.
  void read_fact(XmlArray array, std::string_view type, const XmlTag& tag) {
    if (array.name != "SPACE" || type != "String") return;
    if (array.format == XmlFormat::appended) {
      space_offset_ = number(tag, "offset", 0);
      space_array_ = std::move(array);
      return;
    }
    if (array.format == XmlFormat::binary) return set_space(array);
    std::string text;
    std::string_view rest = array.content;
    while (text.size() < 10) {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
      int character = 0;
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), character);
      if (error != std::errc() || character < 1 || character > 126) break;
      text.push_back(static_cast<char>(character));
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    }
    space_ = space_in_comment("SPACE=" + text);
  }

  void set_space(const XmlArray& array) {
    const std::string text = xml_bytes(path_, array, encoding_, 10);
    space_ = space_in_comment("SPACE=" + text.substr(0, text.find('\0')));
  }

  void read_tags() {
    std::vector<std::string> open;
    bool has_root = false;
    for (;;) {
      const std::optional<XmlTag> tag = next_tag(rest_);
      if (!tag) damaged("its head is no XML, or ends too early");
      if (tag->closes) {
        if (open.empty() || open.back() != tag->name) damaged("its tags do not match");
        open.pop_back();
        if (open.empty()) break;
        continue;
      }
      const std::string section = open.empty() ? "" : open.back();
      if (tag->name == "VTKFile" && open.empty() && !has_root) {
        read_root(*tag);
        has_root = true;
      } else if (!has_root) {
        damaged("it is no VTKFile");
      } else if (tag->name == "Piece") {
        XmlPiece& piece = pieces_.emplace_back();
        if (pieces_.size() > max_xml_arrays) damaged("more pieces than can be used");
        piece.n_points = number(*tag, "NumberOfPoints", 0);
        for (const char* kind : {"Verts", "Lines", "Strips", "Polys"})
          piece.n_cells[kind] = number(*tag, fmt::format("NumberOf{}", kind), 0);
      } else if (tag->name == "DataArray" || tag->name == "Array") {
        read_array(*tag, section);
      } else if (tag->name == "AppendedData") {
        const std::string_view encoding = tag->find("encoding").value_or("base64");
        if (encoding != "raw" && encoding != "base64") damaged("the encoding of what is appended");
        encoding_.is_appended_base64 = encoding == "base64";
        return take_appended();
      }
      if (open.size() > 20) damaged("its tags are nested too deeply");
      if (!tag->is_complete) open.emplace_back(tag->name);
    }
    if (!appended_.empty()) damaged("what should be appended is missing");
  }

  // An array ends where the next one begins.
  void take_appended() {
    const std::size_t begin = rest_.find('_');
    if (begin == rest_.npos) damaged("what should be appended is missing");
    const std::string_view data = rest_.substr(begin + 1);
    std::vector<std::size_t> ends = offsets_;
    if (space_array_ && space_offset_ <= data.size()) {
      space_array_->content = data.substr(space_offset_, 100);
      set_space(*space_array_);
    }
    std::ranges::sort(ends);
    for (std::size_t i = 0; i < appended_.size(); ++i) {
      if (appended_[i].piece == no_piece) continue;
      XmlArray& array = pieces_[appended_[i].piece].sections[appended_[i].section][appended_[i].index];
      if (offsets_[i] > data.size()) damaged(fmt::format("the array '{}' begins beyond its end", array.name));
      const auto next = std::ranges::upper_bound(ends, offsets_[i]);
      array.content = data.substr(offsets_[i], next == ends.end() ? data.npos : *next - offsets_[i]);
    }
  }

  const XmlArray& array_in(const XmlPiece& piece, const std::string& section, std::string_view name) const {
    const auto arrays = piece.sections.find(section);
    if (arrays != piece.sections.end())
      for (const XmlArray& array : arrays->second)
        if (name.empty() || array.name == name) return array;
    damaged(fmt::format("{} has no array {}", section, name));
  }

  void add_piece(const XmlPiece& piece, PolyData& data, std::vector<std::string>& notes) {
    const std::size_t first = data.n_points();
    if (piece.n_points > 0) {
      const XmlArray& points = array_in(piece, "Points", "");
      if (points.n_components != 3) damaged("points have three components");
      data.add_points(xml_values(path_, points, encoding_, 3 * piece.n_points));
    }
    for (const auto& [section, kind] : {std::pair{"Verts", CellKind::vertices}, {"Lines", CellKind::lines}, {"Polys", CellKind::polygons},
                                        {"Strips", CellKind::strips}}) {
      const std::size_t n = piece.n_cells.at(section);
      if (n == 0) continue;
      const std::vector<double> ends = xml_values(path_, array_in(piece, section, "offsets"), encoding_, n);
      const double n_corners = ends.back();
      if (!(n_corners >= 0 && n_corners < 1e12) || n_corners != std::floor(n_corners)) damaged(fmt::format("the offsets of {}", section));
      const auto corners = xml_values(path_, array_in(piece, section, "connectivity"), encoding_, static_cast<std::size_t>(n_corners));
      data.add_cells(kind, ends, corners, first);
    }
    if (!dropped_.empty()) {
      const std::size_t shown = std::min<std::size_t>(dropped_.size(), 20);
      notes.insert(notes.end(), dropped_.begin(), dropped_.begin() + static_cast<std::ptrdiff_t>(shown));
      dropped_.clear();
    }
    if (std::exchange(has_cell_data_, false)) notes.emplace_back("cell data dropped");
  }

  // The arrays that all pieces have, in the order of the first.
  void add_point_data(PolyData& data) {
    const auto with_points = std::ranges::find_if(pieces_, [](const XmlPiece& p) { return p.n_points > 0; });
    const auto first = with_points->sections.find("PointData");
    if (first == with_points->sections.end()) return;
    for (const XmlArray& array : first->second) {
      std::vector<double> values;
      bool is_in_all = true;
      for (const XmlPiece& piece : pieces_) {
        if (piece.n_points == 0) continue;
        const auto arrays = piece.sections.find("PointData");
        const auto same = [&](const XmlArray& a) { return a.name == array.name && a.type == array.type && a.n_components == array.n_components; };
        const XmlArray* own = nullptr;
        if (arrays != piece.sections.end())
          if (const auto at = std::ranges::find_if(arrays->second, same); at != arrays->second.end()) own = &*at;
        if (own == nullptr) {
          is_in_all = false;
          break;
        }
        const std::vector<double> more = xml_values(path_, *own, encoding_, piece.n_points * array.n_components);
        values.insert(values.end(), more.begin(), more.end());
      }
      if (is_in_all) data.add_point_array(array.name, column_type(array.type), array.n_components, values);
      else data.add_dropped(fmt::format("point data '{}' dropped: not every piece has it", printable(array.name)));
    }
  }

  static constexpr std::size_t no_piece = static_cast<std::size_t>(-1);
  struct Appended {
    std::size_t piece;
    std::string section;
    std::size_t index;
  };

  const std::string& path_;
  std::string_view rest_;
  XmlEncoding encoding_;
  std::vector<XmlPiece> pieces_;
  std::vector<Appended> appended_;
  std::vector<std::size_t> offsets_;  // of appended_
  std::size_t n_arrays_ = 0;
  bool has_cell_data_ = false;
  Space space_ = Space::unsaid;
  std::optional<XmlArray> space_array_;  // where it is appended
  std::size_t space_offset_ = 0;
  std::vector<std::string> dropped_;
};

}  // namespace

OriginalShape<3> read_vtp(const std::string& path, std::string_view bytes, std::vector<std::string>& notes) {
  return VtpFile(path, bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes).read(notes);
}

}  // namespace shellmatch
