#include "base/printable.h"
#include "geometry/scene/brain_surface.h"
#include "geometry/scene/inflate_stream.h"
#include "geometry/scene/pugixml_node.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace shellmatch {

namespace {

enum class GiftiType { float32, float64, int32, uint32, int64, uint8 };

template <class T>
double value_at(const char* bytes, bool swap) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swap) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

// Groups of four characters, the last with fill; nothing where the text is another.
std::optional<std::string> decode_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> value;
  value.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i) value[static_cast<unsigned char>(digits[i])] = static_cast<int>(i);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int n_bits = 0, n_digits = 0, n_fill = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    ++n_digits;
    if (c == '=') {
      ++n_fill;
      continue;
    }
    const int digit = value[static_cast<unsigned char>(c)];
    if (digit < 0 || n_fill > 0) return {};
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    n_bits += 6;
    if (n_bits < 8) continue;
    n_bits -= 8;
    bytes.push_back(static_cast<char>(bits >> n_bits & 0xff));
  }
  if (n_digits % 4 != 0 || n_fill > 2) return {};
  return bytes;
}

// One <DataArray> of three columns.
class Columns {
 public:
  Columns(const std::string& path, std::string_view what, const pugi::xml_node& array)
      : path_(path), what_(what), array_(array) {
    if (attribute_of(array, "Dimensionality") != "2" || attribute_of(array, "Dim1") != "3")
      throw_input_error("{}: {} are not an array of three columns", path, what);
    const std::optional<std::int64_t> n = to_integer(attribute_of(array, "Dim0"));
    if (!n || *n < 0 || *n > std::numeric_limits<Index>::max())
      throw_input_error("{}: {}: '{}' is no number of rows", path, what, printable(attribute_of(array, "Dim0"), 30));
    n_rows_ = static_cast<std::size_t>(*n);
    const std::string_view order = attribute_of(array, "ArrayIndexingOrder");
    is_by_columns_ = order == "ColumnMajorOrder";
    if (!is_by_columns_ && order != "RowMajorOrder")
      throw_input_error("{}: {}: the order '{}' is unknown", path, what, printable(order, 30));
    values_ = read();
  }

  std::size_t n_rows() const { return n_rows_; }
  double operator()(std::size_t row, std::size_t column) const {
    return values_[is_by_columns_ ? column * n_rows_ + row : 3 * row + column];
  }

 private:
  std::vector<double> read() const {
    const std::string_view encoding = attribute_of(array_, "Encoding"), text = child_of(array_, "Data").child_value();
    if (encoding == "ASCII") {
      std::vector<double> values = numbers_in(path_, text, what_);
      if (values.size() != 3 * n_rows_)
        throw_input_error("{}: {}: {} of {} numbers are there", path_, what_, values.size(), 3 * n_rows_);
      return values;
    }
    if (encoding == "ExternalFileBinary")
      throw_input_error("{}: {} lie in another file; bring them into this one (gifti_tool -encoding b64gz)", path_,
                        what_);
    if (encoding != "Base64Binary" && encoding != "GZipBase64Binary")
      throw_input_error("{}: {}: the encoding '{}' is unknown", path_, what_, printable(encoding, 30));
    std::optional<std::string> bytes = decode_base64(text);
    const std::size_t size = type_size(), n_bytes = 3 * n_rows_ * size;
    if (bytes && encoding == "GZipBase64Binary") bytes = inflate_stream(*bytes, StreamForm::zlib_or_gzip, n_bytes);
    if (!bytes || bytes->size() != n_bytes)
      throw_input_error("{}: {} cannot be decoded to {} numbers; the file is damaged or was cut off", path_, what_,
                        3 * n_rows_);
    const std::string_view endian = attribute_of(array_, "Endian");
    if (endian != "LittleEndian" && endian != "BigEndian")
      throw_input_error("{}: {}: the order of bytes '{}' is unknown", path_, what_, printable(endian, 30));
    const bool swap = (endian == "BigEndian") != (std::endian::native == std::endian::big);
    std::vector<double> values(3 * n_rows_);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(bytes->data() + i * size, swap);
    return values;
  }

  GiftiType type() const {
    constexpr std::pair<std::string_view, GiftiType> types[] = {
        {"NIFTI_TYPE_FLOAT32", GiftiType::float32}, {"NIFTI_TYPE_FLOAT64", GiftiType::float64},
        {"NIFTI_TYPE_INT32", GiftiType::int32},     {"NIFTI_TYPE_UINT32", GiftiType::uint32},
        {"NIFTI_TYPE_INT64", GiftiType::int64},     {"NIFTI_TYPE_UINT8", GiftiType::uint8}};
    const std::string_view name = attribute_of(array_, "DataType");
    for (const auto& [known, type] : types)
      if (known == name) return type;
    throw_input_error("{}: {}: numbers of the type '{}' are not supported", path_, what_, printable(name, 30));
  }
  std::size_t type_size() const {
    switch (type()) {
      case GiftiType::uint8: return 1;
      case GiftiType::float64:
      case GiftiType::int64: return 8;
      default: return 4;
    }
  }
  double value(const char* bytes, bool swap) const {
    switch (type()) {
      case GiftiType::float32: return value_at<float>(bytes, swap);
      case GiftiType::float64: return value_at<double>(bytes, swap);
      case GiftiType::int32: return value_at<std::int32_t>(bytes, swap);
      case GiftiType::uint32: return value_at<std::uint32_t>(bytes, swap);
      case GiftiType::int64: return static_cast<double>(value_at<std::int64_t>(bytes, swap));
      default: return value_at<std::uint8_t>(bytes, swap);
    }
  }

  const std::string& path_;
  std::string_view what_;
  pugi::xml_node array_;
  std::size_t n_rows_ = 0;
  bool is_by_columns_ = false;
  std::vector<double> values_;
};

std::string_view space_of(const pugi::xml_node& system, std::string_view which) {
  std::string_view rest = child_of(system, which).child_value();
  return next_word(rest, " \t\r\n");
}

// Each <CoordinateSystemTransformMatrix> says what its matrix leads from and to. The frame that meshes share is the
// scanner's: other transforms, to an atlas for instance, are left to the user.
void bring_to_scanner(const std::string& path, const pugi::xml_node& array, MeshFile& mesh) {
  constexpr std::string_view scanner = "NIFTI_XFORM_SCANNER_ANAT";
  bool is_done = false;
  for (const pugi::xml_node& system : children_of(array, "CoordinateSystemTransformMatrix")) {
    const std::string_view from = space_of(system, "DataSpace"), to = space_of(system, "TransformedSpace");
    const std::vector<double> m =
        numbers_in(path, child_of(system, "MatrixData").child_value(), "a transform of coordinates");
    if (m.size() != 16)
      throw_input_error("{}: a transform of coordinates has {} numbers, but 16 belong there", path, m.size());
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(m.data());
    if (matrix.isIdentity(0)) continue;
    if (is_done || to != scanner || from == scanner) {
      mesh.notes.push_back(fmt::format("its transform from {} to {} is not applied: coordinates stay as they stand",
                                       printable(from, 30), printable(to, 30)));
      continue;
    }
    if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      throw_input_error("{}: its transform to the scanner's frame is not one of space", path);
    for (Vec<3>& x : mesh.shape.vertices) x = matrix.topLeftCorner<3, 3>() * x + matrix.topRightCorner<3, 1>();
    for (const Vec<3>& x : mesh.shape.vertices)
      if (!x.allFinite()) throw_input_error("{}: its transform to the scanner's frame leads out of all bounds", path);
    mesh.notes.push_back(fmt::format("its transform from {} to {} applied: an offset of ({:g}, {:g}, {:g}){}",
                                     printable(from, 30), scanner, matrix(0, 3), matrix(1, 3), matrix(2, 3),
                                     matrix.topLeftCorner<3, 3>().isIdentity(1e-6) ? "" : " and a change of axes"));
    is_done = true;
  }
}

pugi::xml_node array_of(const std::string& path, const pugi::xml_node& root, std::string_view intent,
                        std::string_view what) {
  pugi::xml_node found;
  for (const pugi::xml_node& array : children_of(root, "DataArray")) {
    if (attribute_of(array, "Intent") != intent) continue;
    if (found) throw_input_error("{}: more than one array of {}; keep one surface in the file", path, what);
    found = array;
  }
  if (!found)
    throw_input_error("{}: no {} in it: it is no surface; name the file .surf.gii that its values belong to", path,
                      what);
  return found;
}

}  // namespace

MeshFile read_gifti(const std::string& path, std::string_view bytes) {
  pugi::xml_document document;
  parse_xml(path, bytes, document);
  const pugi::xml_node root = child_of(document, "GIFTI");
  if (!root) throw_input_error("{}: no GIfTI file: its element <GIFTI> is missing", path);
  const pugi::xml_node points = array_of(path, root, "NIFTI_INTENT_POINTSET", "points"),
                       faces = array_of(path, root, "NIFTI_INTENT_TRIANGLE", "triangles");
  MeshFile mesh;
  const Columns x(path, "the points", points), corners(path, "the triangles", faces);
  for (std::size_t i = 0; i < x.n_rows(); ++i)
    add_vertex({path, "point", i}, Vec<3>(x(i, 0), x(i, 1), x(i, 2)), mesh.shape);
  for (std::size_t f = 0; f < corners.n_rows(); ++f) {
    std::vector<Index> triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const double v = corners(f, k);
      add_corner(
          {path, "triangle", f},
          v >= 0 && v < static_cast<double>(x.n_rows()) && v == std::floor(v) ? static_cast<std::int64_t>(v) : -1,
          x.n_rows(), triangle);
    }
    mesh.shape.polygons.push_back(std::move(triangle));
  }
  if (const std::size_t n = children_of(root, "DataArray").size(); n > 2)
    mesh.notes.push_back(counted(n - 2, "array", "arrays") + " beside points and triangles left out");
  bring_to_scanner(path, points, mesh);
  mesh.shape.space = Space::ras;
  mesh.unit = "mm";
  return mesh;
}

}  // namespace shellmatch
