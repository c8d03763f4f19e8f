// GIfTI and FreeSurfer: every encoding gives the same surface, and it lies in the scanner's frame.
#include "geometry/io/read_shape.h"
#include "tests/geometry/io/surface_files.h"

#include <zlib.h>

namespace shellmatch::testing {
namespace {

struct GiftiForm {
  std::string encoding = "ASCII", endian = "LittleEndian";
  bool by_columns = false;
  std::string transform;
};

std::string compressed(const std::string& bytes) {
  std::string packed(compressBound(bytes.size()), '\0');
  uLongf size = packed.size();
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                     bytes.size()),
            Z_OK);
  packed.resize(size);
  return packed;
}

template <class T>
std::string gifti_array(const GiftiForm& form, const char* intent, const char* type, const std::vector<T>& rows,
                        const std::string& transform) {
  const std::size_t n = rows.size() / 3;
  std::string text, bytes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const T value = form.by_columns ? rows[3 * (i % n) + i / n] : rows[i];
    text += fmt::format("{}\n", value);
    bytes += number_bytes(value, form.endian == "BigEndian");
  }
  if (form.encoding == "Base64Binary") text = base64(bytes);
  if (form.encoding == "GZipBase64Binary") text = base64(compressed(bytes));
  return fmt::format(
      "<DataArray Intent=\"{}\" DataType=\"{}\" ArrayIndexingOrder=\"{}\" Dimensionality=\"2\" Dim0=\"{}\" Dim1=\"3\" "
      "Encoding=\"{}\" "
      "Endian=\"{}\" ExternalFileName=\"\" ExternalFileOffset=\"\"><MetaData/>{}<Data>{}</Data></DataArray>\n",
      intent, type, form.by_columns ? "ColumnMajorOrder" : "RowMajorOrder", n, form.encoding, form.endian, transform,
      text);
}

std::string gifti_text(const GiftiForm& form, const OriginalShape<3>& shape = triangulated_cube()) {
  std::vector<float> points;
  std::vector<std::int32_t> corners;
  for (const Vec<3>& x : shape.vertices)
    for (int k = 0; k < 3; ++k) points.push_back(static_cast<float>(x[k]));
  for (const auto& polygon : shape.polygons) corners.insert(corners.end(), polygon.begin(), polygon.end());
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
         "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
         "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\"><MetaData/><LabelTable/>\n" +
         gifti_array(form, "NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32", points, form.transform) +
         gifti_array(form, "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", corners, "") + "</GIFTI>\n";
}

std::string transform(const std::string& from, const std::string& to, const std::string& matrix) {
  return "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[" + from + "]]></DataSpace><TransformedSpace><![CDATA[" +
         to + "]]></TransformedSpace><MatrixData>" + matrix + "</MatrixData></CoordinateSystemTransformMatrix>";
}

TEST(Gifti, EveryEncodingGivesTheSameSurface) {
  const TempFolder folder;
  for (const std::string encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    for (const std::string endian : {"LittleEndian", "BigEndian"})
      for (const bool by_columns : {false, true}) {
        const Shape<3> shape = read_mesh(folder.write("a.surf.gii", gifti_text({encoding, endian, by_columns, ""})));
        EXPECT_EQ(shape.original.vertices, cube().vertices) << encoding << endian << by_columns;
        EXPECT_EQ(shape.original.polygons, triangulated_cube().polygons);
        EXPECT_EQ(shape.original.space, Space::ras);
        EXPECT_EQ(shape.unit, "mm");
        EXPECT_NEAR(volume(shape.surface), 1, 1e-12);
      }
}

TEST(Gifti, TransformToTheScannerIsAppliedAndOthersAreSaid) {
  const TempFolder folder;
  const std::string moved = "1 0 0 5\n0 1 0 -6\n0 0 1 7.5\n0 0 0 1";
  GiftiForm form;
  form.transform = transform("NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_SCANNER_ANAT", moved);
  Shape<3> shape = read_mesh(folder.write("a.gii", gifti_text(form)));
  EXPECT_EQ(shape.original.vertices[7], Vec<3>(6, -5, 8.5));
  EXPECT_TRUE(has_note(shape, "(5, -6, 7.5)"));
  form.transform = transform("NIFTI_XFORM_SCANNER_ANAT", "NIFTI_XFORM_TALAIRACH", moved);
  shape = read_mesh(folder.write("a.gii", gifti_text(form)));
  EXPECT_EQ(shape.original.vertices[7], Vec<3>(1, 1, 1));
  EXPECT_TRUE(has_note(shape, "NIFTI_XFORM_TALAIRACH is not applied"));
  form.transform = transform("NIFTI_XFORM_TALAIRACH", "NIFTI_XFORM_TALAIRACH", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  EXPECT_TRUE(read_mesh(folder.write("a.gii", gifti_text(form))).notes.empty());
}

TEST(Gifti, WhatIsWrongIsSaidOnce) {
  const TempFolder folder;
  const auto message = [&](const std::string& text) {
    return input_error_of([&] { read_mesh(folder.write("a.gii", text)); });
  };
  const std::string whole = gifti_text({"Base64Binary", "LittleEndian", false, ""});
  const auto changed = [&](std::string_view from, std::string_view to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TRUE(contains(message(whole.substr(0, 400)), "no XML at byte"));
  EXPECT_TRUE(contains(message("<a/>"), "no GIfTI file"));
  EXPECT_TRUE(contains(message(changed("NIFTI_INTENT_POINTSET", "NIFTI_INTENT_SHAPE")), "no points in it"));
  EXPECT_TRUE(
      contains(message(changed("NIFTI_INTENT_TRIANGLE", "NIFTI_INTENT_POINTSET")), "more than one array of points"));
  EXPECT_TRUE(contains(message(changed("Dim0=\"8\"", "Dim0=\"9\"")), "cannot be decoded to 27 numbers"));
  EXPECT_TRUE(contains(message(changed("Dim0=\"8\"", "Dim0=\"2000000000\"")), "cannot be decoded"));
  EXPECT_TRUE(contains(message(changed("Base64Binary", "ExternalFileBinary")), "lie in another file"));
  EXPECT_TRUE(contains(message(changed("Dim1=\"3\"", "Dim1=\"2\"")), "three columns"));
  OriginalShape<3> wrong = triangulated_cube();
  wrong.polygons[3][1] = 8;
  EXPECT_TRUE(contains(message(gifti_text({}, wrong)), "triangle 3"));
}

std::string real_ras(bool is_real) {
  return number_bytes(std::int32_t{2}, true) + number_bytes(std::int32_t{is_real}, true);
}
const std::string geometry_tag = number_bytes(std::int32_t{20}, true);
std::string geometry(const std::string& axes, const std::string& valid = "1  # volume info valid") {
  return geometry_tag + "valid = " + valid +
         "\nfilename = ../mri/filled.mgz\nvolume = 256 256 256\nvoxelsize = 1 1 1\n" + axes;
}
const std::string standard_axes = "xras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\ncras   = 5 -6 7.5\n";

TEST(FreeSurfer, LiesInTheScannersFrame) {
  const TempFolder folder;
  const auto vertex = [&](const std::string& footer) {
    const Shape<3> shape = read_mesh(folder.write("lh.white", freesurfer_bytes(triangulated_cube(), footer)));
    EXPECT_EQ(shape.original.space, Space::ras);
    EXPECT_NEAR(volume(shape.surface), 1, 1e-6);
    return shape.original.vertices[1];
  };
  EXPECT_EQ(vertex(real_ras(false) + geometry(standard_axes)), Vec<3>(6, -6, 7.5));
  EXPECT_EQ(vertex(geometry(standard_axes)), Vec<3>(6, -6, 7.5));
  EXPECT_EQ(vertex(real_ras(true) + geometry(standard_axes)), Vec<3>(1, 0, 0));
  EXPECT_EQ(vertex(geometry(standard_axes, "0")), Vec<3>(1, 0, 0));
  EXPECT_EQ(vertex(""), Vec<3>(1, 0, 0));
  // A volume whose first axis runs backwards in y: tkRegister calls it -x.
  EXPECT_NEAR(
      (vertex(geometry("xras = 0 -1 0\nyras = 0 0 -1\nzras = -1 0 0\ncras = 1 2 3\n")) - Vec<3>(1, 3, 3)).norm(), 0,
      1e-12);
}

std::string three_bytes(std::size_t n) { return number_bytes(static_cast<std::int32_t>(n), true).substr(1); }

std::string quad_bytes(bool is_old) {
  std::string bytes = (is_old ? "\xff\xff\xff" : "\xff\xff\xfd") + three_bytes(8) + three_bytes(6);
  for (const Vec<3>& x : cube().vertices)
    for (int k = 0; k < 3; ++k)
      bytes += is_old ? number_bytes(static_cast<std::int16_t>(-150 * x[k]), true)
                      : number_bytes(static_cast<float>(-1.5 * x[k]), true);
  for (const auto& polygon : cube().polygons)
    for (const Index v : polygon) bytes += three_bytes(static_cast<std::size_t>(v));
  return bytes;
}

TEST(FreeSurfer, QuadrilateralsOfOldAreRead) {
  const TempFolder folder;
  for (const bool is_old : {true, false}) {
    const Shape<3> shape = read_mesh(folder.write("lh.orig", quad_bytes(is_old)));
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(shape.original.vertices[v], Vec<3>(-1.5 * cube().vertices[v]));
    ASSERT_EQ(shape.original.polygons.size(), 12u);
    for (std::size_t f = 0; f < 6; ++f) {
      const std::vector<Index> q = cube().polygons[f], t = shape.original.polygons[2 * f];
      EXPECT_EQ(t, q[0] % 2 == 0 ? (std::vector<Index>{q[0], q[1], q[3]}) : (std::vector<Index>{q[0], q[1], q[2]}));
    }
    EXPECT_NEAR(volume(shape.surface), 1.5 * 1.5 * 1.5, 1e-6);
    EXPECT_TRUE(has_note(shape, "says nothing of its volume"));
  }
  // Values at vertices have the mark of the old ones.
  const std::string values = "\xff\xff\xff" + number_bytes(std::int32_t{8}, true) +
                             number_bytes(std::int32_t{12}, true) + number_bytes(std::int32_t{1}, true) +
                             std::string(32, '\0');
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.write("lh.curv", values)); }), "not supported"));
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.write("lh.orig", quad_bytes(false).substr(0, 60))); }),
                       "8 vertices and 6 quadrilaterals"));
  std::string wrong = quad_bytes(false);
  wrong.back() = 8;
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.write("lh.orig", wrong)); }), "quadrilateral 5"));
}

TEST(FreeSurfer, IsKnownByItsContentsAndDamageIsSaid) {
  const TempFolder folder;
  const std::string whole = freesurfer_bytes(triangulated_cube(), geometry(standard_axes));
  const Shape<3> shape = read_mesh(folder.write("rh.pial.T1", whole));
  EXPECT_EQ(shape.original.polygons, triangulated_cube().polygons);
  EXPECT_TRUE(has_note(shape, "moved by c_ras (5, -6, 7.5)"));
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.write("lh.white", whole.substr(0, 200))); }),
                       "cut off: it declares 8 vertices and 12 triangles"));
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.write("lh.white", whole.substr(0, 20))); }), "cut off"));
  EXPECT_TRUE(
      contains(input_error_of([&] { read_mesh(folder.write("lh.curv", "\xff\xff\xff" + whole)); }), "not supported"));
}

}  // namespace
}  // namespace shellmatch::testing
