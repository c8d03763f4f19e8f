#include "base/printable.h"
#include "geometry/scene/brain_surface.h"
#include "geometry/bytes/inflate.h"
#include "geometry/scene/pugixml_node.h"
#include "geometry/bytes/value_type.h"

#include <cmath>

namespace shellmatch {

namespace {

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
    const std::size_t n = 3 * n_rows_, n_bytes = bytes_of(type(), n);
    if (bytes && encoding == "GZipBase64Binary") bytes = inflate_stream(*bytes, StreamForm::zlib_or_gzip, n_bytes);
    if (!bytes || bytes->size() != n_bytes)
      throw_input_error("{}: {} cannot be decoded to {} numbers; the file is damaged or was cut off", path_, what_, n);
    const std::string_view endian = attribute_of(array_, "Endian");
    if (endian != "LittleEndian" && endian != "BigEndian")
      throw_input_error("{}: {}: the order of bytes '{}' is unknown", path_, what_, printable(endian, 30));
    return values_of(*bytes, type(), n, endian == "BigEndian");
  }

  ValueType type() const {
    constexpr std::pair<std::string_view, ValueType> types[] = {
        {"NIFTI_TYPE_FLOAT32", ValueType::float32}, {"NIFTI_TYPE_FLOAT64", ValueType::float64},
        {"NIFTI_TYPE_INT32", ValueType::int32},     {"NIFTI_TYPE_UINT32", ValueType::uint32},
        {"NIFTI_TYPE_INT64", ValueType::int64},     {"NIFTI_TYPE_UINT8", ValueType::uint8}};
    const std::string_view name = attribute_of(array_, "DataType");
    for (const auto& [known, type] : types)
      if (known == name) return type;
    throw_input_error("{}: {}: numbers of the type '{}' are not supported", path_, what_, printable(name, 30));
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
