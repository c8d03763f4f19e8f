#include "base/error.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/checksum.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <csignal>
#include <memory>
#include <random>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;

// Refined towards a point off the middle, so that there are hanging nodes at several levels.
template <int Dim>
Octree<Dim> refined_grid(int min_level, int max_level) {
  Octree<Dim> grid(min_level);
  const Vec<Dim> centre = Vec<Dim>::Constant(0.3);
  for (int level = min_level; level < max_level; ++level)
    grid.refine([&](Index c) {
      const double r = (grid.cell_centre(c) - centre).norm();
      return grid.cell(c).level == level && std::abs(r - 0.2) < grid.cell(c).side();
    });
  return grid;
}

// Values of all sizes, whose every bit counts.
template <int Dim>
Deformation<Dim> some_deformation(int min_level = 1, int max_level = 4) {
  Deformation<Dim> d{{}, refined_grid<Dim>(min_level, max_level), {}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (Index i = 0; i < d.grid.n_nodes(); ++i) {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k) x[k] = i % 7 == 0 ? std::ldexp(number(random), -300) : number(random) / 3;
    d.phi.push_back(x);
  }
  d.phi[1][0] = -0.0;
  d.placement.scale = 1 / 3.0;
  for (int k = 0; k < Dim; ++k) d.placement.offset[k] = number(random);
  return d;
}

template <int Dim>
typename Octree<Dim>::Coord coord_of(const Octree<Dim>& grid, Index node) {
  typename Octree<Dim>::Coord c;
  for (int k = 0; k < Dim; ++k)
    c[k] = static_cast<std::int32_t>(std::ldexp(grid.node_position(node)[k], Octree<Dim>::max_level));
  return c;
}

template <int Dim>
void expect_same(const Deformation<Dim>& a, const Deformation<Dim>& b) {
  ASSERT_EQ(a.grid.leaves().size(), b.grid.leaves().size());
  for (const Index leaf : a.grid.leaves()) {
    const Index other = b.grid.find_cell(a.grid.cell(leaf).level, a.grid.cell(leaf).corner);
    ASSERT_NE(other, no_index);
    ASSERT_TRUE(b.grid.cell(other).is_leaf());
  }
  ASSERT_EQ(a.grid.n_nodes(), b.grid.n_nodes());
  ASSERT_EQ(a.grid.hanging_nodes().size(), b.grid.hanging_nodes().size());
  for (Index i = 0; i < a.grid.n_nodes(); ++i) {
    const Index j = b.grid.find_node(coord_of(a.grid, i));
    ASSERT_NE(j, no_index);
    for (int k = 0; k < Dim; ++k)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.phi[i][k]), std::bit_cast<std::uint64_t>(b.phi[j][k]));
  }
  EXPECT_EQ(a.placement.scale, b.placement.scale);
  EXPECT_EQ(a.placement.offset, b.placement.offset);
}

template <int Dim>
void expect_exact_round_trip() {
  const TemporaryFolder tmp;
  const Deformation<Dim> d = some_deformation<Dim>();
  ASSERT_GT(d.grid.hanging_nodes().size(), 0u);
  const std::string path = tmp / deformation_file_name;
  std::vector<double> d1(d.grid.n_nodes(), 0.5), n1(static_cast<std::size_t>(Dim) * d.grid.n_nodes(), 1);
  write_deformation(path, d, {{"d1", 1, d1}, {"n1", Dim, n1}},
                    {{"in_band", std::vector<double>(d.grid.leaves().size(), 1)}});
  EXPECT_EQ(deformation_dimension(path), Dim);
  expect_same(d, read_deformation<Dim>(path));
  expect_same(d, read_deformation<Dim>(tmp / ""));  // the folder
  const std::string wrong = message_of<InputError>([&] { read_deformation<5 - Dim>(path); });
  EXPECT_NE(wrong.find(path), std::string::npos);
  EXPECT_NE(wrong.find("dimension"), std::string::npos);

  // Twice the same file to the bit.
  write_deformation(tmp / "again.vtu", d, {{"d1", 1, d1}, {"n1", Dim, n1}},
                    {{"in_band", std::vector<double>(d.grid.leaves().size(), 1)}});
  EXPECT_EQ(contents_of(path), contents_of(tmp / "again.vtu"));
}
TEST(DeformationFileTest, RoundTripIsExactInThePlane) { expect_exact_round_trip<2>(); }
TEST(DeformationFileTest, RoundTripIsExactInSpace) { expect_exact_round_trip<3>(); }

Deformation<3> bent_deformation() {
  Deformation<3> d = some_deformation<3>();
  const Surface<3> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1 / 3.0}},
                          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  d.bend =
      std::make_shared<const SurfaceBend<3>>(corner, std::vector<Vec<3>>{{5, 0, 0}, {5, 1, 0}, {4, 0, 0}, {5, 0, 0.1}});
  return d;
}

TEST(DeformationFileTest, TheBendOfTheReferenceComesBack) {
  const TemporaryFolder tmp;
  Deformation<3> d = bent_deformation();
  write_deformation(tmp / "bent.vtu", d);
  const Deformation<3> read = read_deformation<3>(tmp / "bent.vtu");
  ASSERT_TRUE(read.bend);
  EXPECT_EQ(read.bend->surface().vertices, d.bend->surface().vertices);
  EXPECT_EQ(read.bend->surface().facets, d.bend->surface().facets);
  EXPECT_EQ(read.bend->bent().vertices, d.bend->bent().vertices);
  const Vec<3> x(0.2, 0.1, -0.05);
  EXPECT_EQ(read.apply(x), d.apply(x));
  d.is_backward = true;
  write_deformation(tmp / "wrong.vtu", d);
  EXPECT_NE(message_of<InputError>([&] { read_deformation<3>(tmp / "wrong.vtu"); }).find("backward"),
            std::string::npos);
}

TEST(DeformationFileTest, UniformGridsAndSingleCellsComeBack) {
  const TemporaryFolder tmp;
  for (const int level : {0, 2}) {
    const Deformation<3> d = some_deformation<3>(level, level);
    write_deformation(tmp / "u.vtu", d);
    expect_same(d, read_deformation<3>(tmp / "u.vtu"));
  }
}

TEST(DeformationFileTest, AFileCutOffAnywhereIsAnInputError) {
  const TemporaryFolder tmp;
  write_deformation(tmp / "whole.vtu", some_deformation<2>());
  const std::string whole = contents_of(tmp / "whole.vtu");
  for (std::size_t i = 0; i < 60; ++i) {
    const std::size_t length = i < 30 ? i * whole.size() / 30 : whole.size() - 2 - (i - 30);
    put(tmp / "cut.vtu", whole.substr(0, length));
    EXPECT_NE(message_of<InputError>([&] { read_deformation<2>(tmp / "cut.vtu"); }), "") << length;
    EXPECT_NE(message_of<InputError>([&] { deformation_dimension(tmp / "cut.vtu"); }), "") << length;
  }
  // A piece missing from the middle, the end in place.
  for (std::size_t i = 1; i < 30; ++i) {
    const std::size_t at = i * whole.size() / 31;
    put(tmp / "cut.vtu", whole.substr(0, at) + whole.substr(at + 9));
    EXPECT_NE(message_of<InputError>([&] { read_deformation<2>(tmp / "cut.vtu"); }), "") << at;
  }
}

TEST(DeformationFileTest, AChangedByteIsFoundOrDoesNotMatter) {
  const TemporaryFolder tmp;
  const Deformation<2> d = some_deformation<2>();
  write_deformation(tmp / "whole.vtu", d);
  const std::string whole = contents_of(tmp / "whole.vtu");
  int n_found = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    std::string changed = whole;
    changed[i * whole.size() / 200] ^= static_cast<char>(1 << (i % 8));
    put(tmp / "changed.vtu", changed);
    try {
      expect_same(d, read_deformation<2>(tmp / "changed.vtu"));
    } catch (const InputError&) {
      ++n_found;
    }
  }
  EXPECT_GT(n_found, 100);
}

TEST(DeformationFileTest, ForeignFilesAreInputErrorsThatNameThem) {
  const TemporaryFolder tmp;
  put(tmp / "a.vtu", "");
  put(tmp / "b.vtu", "ply\nformat ascii 1.0\n");
  put(tmp / "c.vtu",
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid><Piece NumberOfPoints=\"0\" "
      "NumberOfCells=\"0\"></Piece></UnstructuredGrid>\n</VTKFile>\n");
  for (const std::string name : {"a.vtu", "b.vtu", "c.vtu", "not_there.vtu", ""}) {
    const std::string message = message_of<InputError>([&] { read_deformation<3>(tmp / name); });
    EXPECT_NE(message.find(tmp / name), std::string::npos) << message;
  }
}

TEST(DeformationFileTest, AFileOfAnEarlierVersionSaysSo) {
  const TemporaryFolder tmp;
  write_deformation(tmp / "d.vtu", some_deformation<2>());
  const std::string now = contents_of(tmp / "d.vtu");
  put(tmp / "d.vtu", now.substr(0, now.rfind("\n<!--")) + "\n<!-- shellmatch checksum 0123456789abcdef -->\n");
  for (const std::string& message : {message_of<InputError>([&] { read_deformation<2>(tmp / "d.vtu"); }),
                                     message_of<InputError>([&] { deformation_dimension(tmp / "d.vtu"); })}) {
    EXPECT_NE(message.find("d.vtu: written by an earlier version of this program"), std::string::npos) << message;
    EXPECT_EQ(message.find("damaged"), std::string::npos) << message;
  }
}

// The file with a piece of its head replaced by one of the same or of another length, and with a right checksum.
void put_changed(const std::string& path, std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  ASSERT_NE(at, std::string::npos) << before;
  text.replace(at, before.size(), after);
  put(path, text.substr(0, text.rfind("\n<!--")));
  append_checksum(path);
}

TEST(DeformationFileTest, AHeadThatLiesIsAnInputError) {
  const TemporaryFolder tmp;
  write_deformation(tmp / "whole.vtu", some_deformation<3>());
  const std::string whole = contents_of(tmp / "whole.vtu");
  put_changed(tmp / "same.vtu", whole, "RangeMin", "rangemin");  // of no meaning here
  expect_same(some_deformation<3>(), read_deformation<3>(tmp / "same.vtu"));
  const auto phi = [](const std::string& components) {
    return "Name=\"phi\" NumberOfComponents=\"" + components + "\"";
  };
  const std::string points = whole.substr(whole.find("NumberOfPoints=\""), 36),
                    cells = whole.substr(whole.find("NumberOfCells=\""), 36);
  struct Case {
    std::string before, after;
  };
  const Case cases[] = {{"Name=\"dimension\"", "Name=\"level\""},
                        {"Name=\"level\"", "Name=\"dimension\""},
                        {"type=\"Int32\" Name=\"dimension\"", "type=\"level\" Name=\"dimension\""},
                        {"header_type=\"UInt64\"", "header_type=\"UInt46\""},
                        {"header_type=\"UInt64\"", "header_type=\"UInt32\""},
                        {"compressor=\"vtkZLibDataCompressor\"", "compressor=\"vtkLZ4DataCompressor\""},
                        {"byte_order=\"LittleEndian\"", "byte_order=\"BigEndian\""},
                        {phi("3"), phi("-1")},
                        {phi("3"), phi("0")},
                        {phi("3"), phi("9223372036854775807")},
                        {phi("3"), phi("1")},
                        {"type=\"Float64\" Name=\"phi\"", "type=\"Float32\" Name=\"phi\""},
                        {"type=\"Float64\" Name=\"phi\"", "type=\"Int64\" Name=\"phi\""},
                        {"Name=\"connectivity\"", "Name=\"offsets\""},
                        {points, "NumberOfPoints=\"1099511627776\""},
                        {points, "NumberOfPoints=\"-5\""},
                        {points, "NumberOfPoints=\"0\""},
                        {cells, "NumberOfCells=\"1099511627776\""},
                        {cells, "NumberOfCells=\"0\""},
                        {"offset=\"0\"", "offset=\"9999999999\""},
                        {"offset=\"0\"", "offset=\"44\""},
                        {"<Points>", "<Point>"},
                        {"<UnstructuredGrid>", "<UnstructuredGrid "},
                        {"</Piece>", "<Piece/>"},
                        {"encoding=\"raw\"", "encoding=\"base64\""},
                        {"format=\"appended\"", "format=\"ascii\""},
                        {"<AppendedData", "<AppendedDatum"}};
  for (const auto& [before, after] : cases) {
    SCOPED_TRACE(before + " -> " + after);
    put_changed(tmp / "changed.vtu", whole, before, after);
    const std::string message = message_of<InputError>([&] { read_deformation<3>(tmp / "changed.vtu"); });
    EXPECT_NE(message.find("changed.vtu: damaged"), std::string::npos) << message;
  }
}

// An array of the file, in which it is appended, given as text.
void put_with_array(const std::string& path, const std::string& whole, const std::string& name,
                    const std::string& values) {
  const std::size_t begin = whole.rfind("<DataArray", whole.find("Name=\"" + name + "\"")),
                    end = whole.find("/>", begin);
  std::string tag = whole.substr(begin, end - begin);
  tag.replace(tag.find("format=\"appended\""), 17, "format=\"ascii\"");
  put_changed(path, whole, whole.substr(begin, end + 2 - begin), tag + ">" + values + "</DataArray>");
}

TEST(DeformationFileTest, ADamagedBendIsAnInputErrorAndNeverLeftOut) {
  const TemporaryFolder tmp;
  const Deformation<3> d = bent_deformation();
  write_deformation(tmp / "whole.vtu", d);
  const std::string whole = contents_of(tmp / "whole.vtu"), sizes = "bend_sizes", facets = "bend_facets",
                    vertices = "bend_vertices";
  const auto expect_refused = [&](const std::string& name) {
    const std::string message = message_of<InputError>([&] { read_deformation<3>(tmp / "changed.vtu"); });
    EXPECT_NE(message.find("changed.vtu: damaged"), std::string::npos) << message;
    EXPECT_NE(message.find(name), std::string::npos) << message;
  };
  for (const std::string& name : {sizes, vertices, facets}) {
    SCOPED_TRACE(name + " is not there");
    put_changed(tmp / "changed.vtu", whole, "Name=\"" + name + "\"", "Name=\"another\"");
    expect_refused(name);
  }
  put_with_array(tmp / "same.vtu", whole, facets, "0 2 1 0 1 3 0 3 2 1 2 3");
  EXPECT_EQ(read_deformation<3>(tmp / "same.vtu").bend->surface().facets, d.bend->surface().facets);
  struct Case {
    std::string name, values, blamed;
  };
  const std::string numbers = "1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5";
  const Case cases[] = {{facets, "0 2 1 0 1 3 0 3 2 1 2 4", facets},
                        {facets, "0 2 1 0 1 3 0 3 2 1 2 -1", facets},
                        {facets, "0 2 1 0 1 3 0 3 2 1 2 nan", facets},
                        {facets, "0 2 1 0 1 3 0 3 2 1 2 0.5", facets},
                        {facets, "0 2 1 0 1 3 0 3 2 1 2", facets},
                        {facets, "0 2 1 0 1 3 0 3 2 1 2 3 1 2 3", facets},
                        {vertices, numbers + " nan", vertices},
                        {vertices, numbers + " inf", vertices},
                        {vertices, numbers, vertices},
                        {sizes, "4 3", facets},
                        {sizes, "5 4", vertices},
                        {sizes, "4 2147483647", facets},
                        {sizes, "2147483647 4", vertices},
                        {sizes, "1e300 4", sizes},
                        {sizes, "4 0", sizes},
                        {sizes, "-4 4", sizes},
                        {sizes, "4.5 4", sizes},
                        {sizes, "nan 4", sizes}};
  for (const auto& [name, values, blamed] : cases) {
    SCOPED_TRACE(name + ": " + values);
    put_with_array(tmp / "changed.vtu", whole, name, values);
    expect_refused(blamed);
  }
  write_deformation(tmp / "plane.vtu", some_deformation<2>());
  put_changed(tmp / "changed.vtu", contents_of(tmp / "plane.vtu"), "Name=\"placement_scale\"",
              "Name=\"placement_scale\"/><DataArray type=\"Float64\" Name=\"bend_sizes\" format=\"ascii\"");
  EXPECT_THROW(read_deformation<2>(tmp / "changed.vtu"), InputError);
}

// Names are compared pair by pair: 100,000 took a minute.
TEST(DeformationFileTest, MoreArraysOrAttributesThanItCanHaveAreRefusedAtOnce) {
  const TemporaryFolder tmp;
  write_deformation(tmp / "whole.vtu", some_deformation<2>());
  const std::string whole = contents_of(tmp / "whole.vtu");
  std::string arrays = "<FieldData>", attributes = "<FieldData ";
  for (int i = 0; i < 100000; ++i) {
    arrays += "<DataArray format=\"appended\" Name=\"a" + std::to_string(i) + "\"/>";
    attributes += "a" + std::to_string(i) + "=\"\" ";
  }
  put_changed(tmp / "changed.vtu", whole, "<FieldData>", arrays);
  EXPECT_NE(message_of<InputError>([&] { read_deformation<2>(tmp / "changed.vtu"); }).find("more arrays"),
            std::string::npos);
  put_changed(tmp / "changed.vtu", whole, "<FieldData>", attributes + ">");
  EXPECT_NE(message_of<InputError>([&] { read_deformation<2>(tmp / "changed.vtu"); }).find("no XML"),
            std::string::npos);
}

TEST(DeformationFileTest, ANameThatIsTooLongIsAnInputError) {
  EXPECT_THROW(read_deformation<2>(std::string(5000, 'a')), InputError);
  EXPECT_THROW(deformation_dimension(std::string(5000, 'a')), InputError);
}

// With a right checksum, so that nothing but the reader itself stands against them.
TEST(DeformationFileTest, ChangedBytesWithARightChecksumAreFoundOrDoNotMatter) {
  const TemporaryFolder tmp;
  const Deformation<2> d = some_deformation<2>();
  write_deformation(tmp / "whole.vtu", d);
  const std::string whole = contents_of(tmp / "whole.vtu"), body = whole.substr(0, whole.rfind("\n<!--"));
  std::mt19937_64 random(11);
  int n_found = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string changed = body;
    for (std::uint64_t n = 1 + random() % 3; n > 0; --n)
      changed[random() % changed.size()] = static_cast<char>(random());
    if (trial % 10 == 0) changed.resize(random() % changed.size());
    put(tmp / "changed.vtu", changed);
    append_checksum(tmp / "changed.vtu");
    try {
      const Deformation<2> read = read_deformation<2>(tmp / "changed.vtu");
      for (const Vec<2>& x : read.phi) ASSERT_TRUE(x.allFinite());
    } catch (const InputError&) {
      ++n_found;
    }
  }
  EXPECT_GT(n_found, 500);
}

TEST(DeformationFileTest, AFullDiskIsAnEnvironmentError) {
  const TemporaryFolder tmp;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 2048;  // writing beyond fails as on a full disk
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      message_of<EnvironmentError>([&] { write_deformation(tmp / "d.vtu", some_deformation<3>()); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("d.vtu"), std::string::npos) << message;
  EXPECT_THROW(write_deformation(tmp / "no_folder/d.vtu", some_deformation<2>()), EnvironmentError);
}

}  // namespace
}  // namespace shellmatch
