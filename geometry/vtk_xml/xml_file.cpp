#include "geometry/vtk_xml/xml_file.h"

#include "base/printable.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace shellmatch {

namespace {

constexpr std::size_t max_xml_arrays = 1000;

}  // namespace

VtkXmlFile::VtkXmlFile(const std::string& path, std::string_view bytes, const XmlExpectation& expected)
    : path_(path), rest_(bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes), expected_(expected) {
  read_tags();
}

void VtkXmlFile::damaged(std::string_view why) const {
  throw DamagedXmlFile(
      fmt::format("{}: damaged, cut off, or no {} ({}){}", path_, expected_.what, printable(why), expected_.instead));
}

const XmlArray* VtkXmlFile::find(const XmlPiece& piece, std::string_view section, std::string_view name) {
  const auto arrays = piece.sections.find(section);
  if (arrays == piece.sections.end()) return nullptr;
  const auto found =
      std::ranges::find_if(arrays->second, [&](const XmlArray& a) { return name.empty() || a.name == name; });
  return found == arrays->second.end() ? nullptr : &*found;
}

std::size_t VtkXmlFile::number(const XmlTag& tag, std::string_view key, std::size_t otherwise) const {
  auto text = tag.find(key);
  if (!text) return otherwise;
  while (!text->empty() && text->back() == ' ') text->remove_suffix(1);
  std::size_t value = 0;
  constexpr std::size_t most = std::size_t{1} << 40;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (text->empty() || error != std::errc() || end != text->data() + text->size() || value > most)
    damaged(fmt::format("the attribute {}", key));
  return value;
}

void VtkXmlFile::read_root(const XmlTag& tag) {
  if (const auto type = tag.find("type").value_or(""); type != expected_.type)
    throw_input_error("{}: a VTK file of type '{}'; {}", path_, printable(type, 40), expected_.advice);
  encoding_.is_big_endian = tag.find("byte_order").value_or("LittleEndian") == "BigEndian";
  encoding_.header_bytes = tag.find("header_type").value_or("UInt32") == "UInt64" ? 8 : 4;
  const std::string_view compressor = tag.find("compressor").value_or("");
  encoding_.is_compressed = !compressor.empty();
  if (encoding_.is_compressed && compressor != "vtkZLibDataCompressor")
    throw_input_error("{}: compressed by {}; save it without compression or with zlib", path_,
                      printable(compressor, 40));
}

// The text of an element that is open, before or after elements within.
std::string_view VtkXmlFile::text_within(std::string_view name) const {
  std::string_view inner = rest_.substr(0, rest_.find(fmt::format("</{}", name)));
  const std::size_t last = inner.rfind('>');
  if (last == inner.npos) return inner;
  const std::string_view after = inner.substr(last + 1);
  return after.find_first_not_of(" \t\r\n") == after.npos ? inner.substr(0, inner.find('<')) : after;
}

void VtkXmlFile::read_array(const XmlTag& tag, std::string_view section) {
  XmlArray array;
  array.name = tag.find("Name").value_or("");
  const std::string_view type = tag.find("type").value_or(""), format = tag.find("format").value_or("ascii");
  if (format == "appended") array.format = XmlFormat::appended;
  else if (format == "binary") array.format = XmlFormat::binary;
  else if (format != "ascii") damaged(fmt::format("the format {}", format));
  array.n_components = number(tag, "NumberOfComponents", 1);
  if (array.n_components == 0 || array.n_components > max_components)
    damaged(fmt::format("the components of '{}'", array.name));
  if (++n_arrays_ > max_xml_arrays) damaged("more arrays than can be used");
  array.content = tag.is_complete ? std::string_view() : text_within(tag.name);
  const bool is_fact = section == "FieldData";
  if (is_fact && array.name == "SPACE" && type == "String") return read_space(std::move(array), tag);
  const std::optional<ValueType> known = xml_type(type);
  if (!known) {
    if (!is_fact && section != "PointData" && section != "CellData") damaged(fmt::format("an array of type {}", type));
    if (section == "PointData")
      dropped_.push_back(fmt::format("point data '{}' of type {} dropped", printable(array.name), printable(type, 40)));
    return;
  }
  array.type = *known;
  if (section.empty() || (pieces_.empty() && !is_fact)) damaged("an array in no piece");
  std::vector<XmlArray>& arrays = (is_fact ? facts_ : pieces_.back()).sections[std::string(section)];
  if (array.format == XmlFormat::appended) {
    array.content = {};
    appended_.push_back({is_fact ? std::nullopt : std::optional(pieces_.size() - 1),
                         number(tag, "offset", std::size_t{1} << 40), std::string(section), arrays.size()});
  }
  arrays.push_back(std::move(array));
}

// 3D Slicer names the frame in the data of the whole, as a list of the numbers of characters.
void VtkXmlFile::read_space(XmlArray array, const XmlTag& tag) {
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

void VtkXmlFile::set_space(const XmlArray& array) {
  const std::string text = xml_bytes(path_, array, encoding_, 10);
  space_ = space_in_comment("SPACE=" + text.substr(0, text.find('\0')));
}

void VtkXmlFile::read_tags() {
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
    } else if (tag->name == expected_.type) {
      data_set_ = *tag;
    } else if (tag->name == "Piece") {
      pieces_.push_back({*tag, {}});
      if (pieces_.size() > max_xml_arrays) damaged("more pieces than can be used");
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
void VtkXmlFile::take_appended() {
  const std::size_t begin = rest_.find('_');
  if (begin == rest_.npos) damaged("what should be appended is missing");
  const std::string_view data = rest_.substr(begin + 1);
  if (space_array_ && space_offset_ <= data.size()) {
    space_array_->content = data.substr(space_offset_, 100);
    set_space(*space_array_);
  }
  std::vector<std::size_t> ends;
  for (const Appended& a : appended_) ends.push_back(a.offset);
  std::ranges::sort(ends);
  for (const Appended& a : appended_) {
    XmlArray& array = (a.piece ? pieces_[*a.piece] : facts_).sections[a.section][a.index];
    if (a.offset > data.size()) damaged(fmt::format("the array '{}' begins beyond its end", array.name));
    const auto next = std::ranges::upper_bound(ends, a.offset);
    array.content = data.substr(a.offset, next == ends.end() ? data.npos : *next - a.offset);
  }
}

}  // namespace shellmatch
