// NRRD: long headers, fields of the axes in any order, and axes by where they begin and end.
#include "geometry/volume/grid_file.h"
#include "geometry/volume/volume_file.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"

#include <algorithm>

namespace shellmatch::testing {
namespace {

class Nrrd : public ::testing::Test {
 protected:
  /// The same file with more lines in its header.
  std::string with_lines(const std::string& lines) const {
    return folder.write("lines.nrrd", std::string(whole).insert(9, lines));
  }
  /// A file of 4 x 5 x 3 bytes with these lines about its axes.
  std::string of_axes(const std::string& lines) const {
    return folder.write("axes.nrrd",
                        "NRRD0004\ntype: uchar\nencoding: raw\ndimension: 3\n" + lines + "\n" + std::string(60, '\1'));
  }
  std::string refusal(const std::string& file) const {
    return input_error_of([&] { read_volume(file); });
  }
  const TempFolder folder;
  const Volume volume = volume_of(grid_over({-10.5, 20.25, 3}, {1, 0.5, 2}, {4, 5, 3}), [](const Vec<3>& x) {
    return std::round(3 * (x[0] + 10.5) + 7 * (x[1] - 20.25) + 11 * (x[2] - 3));
  });
  const std::string whole = nrrd(volume, true);
};

TEST_F(Nrrd, HeadersMayBeLong) {
  // The steps in which a header is read end at 64 KiB and 256 KiB: before, within and behind its end.
  const std::size_t rest = whole.size() - 60;
  for (const std::size_t n : {std::size_t{65000}, 65536 - rest - 1, 65536 - rest, 65536 - rest + 1, std::size_t{65536},
                              262144 - rest, 262145 - rest, std::size_t{3000000}})
    EXPECT_EQ(read_volume(with_lines("protocol:=" + std::string(n - 11, 'x') + "\n")).values, volume.values) << n;
  // Ends of lines of two bytes, of which a step may read one.
  std::string header;
  for (const char c : whole.substr(0, rest)) header += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::size_t n : {65536 - header.size() - 1, 65536 - header.size(), 65536 - header.size() + 1}) {
    const std::string longer = std::string(header).insert(10, "# " + std::string(n - 4, 'x') + "\r\n");
    EXPECT_EQ(read_volume(folder.write("cr.nrrd", longer + whole.substr(rest))).values, volume.values) << n;
  }
}

TEST_F(Nrrd, AHeaderWithoutAnEndIsRefused) {
  const std::string protocol = "protocol:=" + std::string(9000000, 'x');
  const std::string message = "its header does not end: no blank line in the first 8388608 bytes";
  EXPECT_TRUE(contains(refusal(with_lines(protocol + "\n")), message));
  EXPECT_TRUE(contains(
      refusal(folder.write("late.nrrd", std::string(whole).insert(whole.find("\n\n") + 1, protocol + "\n"))), message));
  std::string none = whole.substr(0, whole.find("\n\n") + 1);
  EXPECT_TRUE(contains(refusal(folder.write("none.nrrd", none)), "its header does not end"));
  // The values of a header by itself are elsewhere.
  folder.write("values.raw", whole.substr(whole.size() - 60));
  EXPECT_EQ(read_volume(folder.write("detached.nhdr", none + "data file: values.raw\n")).values, volume.values);
}

TEST_F(Nrrd, AxesHaveAnEntryForEachDimension) {
  for (const std::string field : {"spacings", "axis mins", "axis maxs"})
    for (const std::string numbers : {"1", "1 2", "1 2 3 4"}) {
      const std::string message =
          field + " has " + std::to_string((numbers.size() + 1) / 2) + " entries for 3 dimensions";
      EXPECT_TRUE(contains(refusal(of_axes(field + ": " + numbers + "\nsizes: 4 5 3\n")), message));
      EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\n" + field + ": " + numbers + "\n")), message));
    }
  EXPECT_TRUE(
      contains(refusal(of_axes("sizes: 4 5 3\ncenters: cell cell\n")), "centers has 2 entries for 3 dimensions"));
  EXPECT_EQ(read_voxel_grid(of_axes("spacings: 1 0.5 2\nsizes: 4 5 3\n")).axes.col(1).norm(), 0.5);
}

// Minima and maxima are those of voxels, and of their centres where an axis is centred on nodes.
TEST_F(Nrrd, AxesBeginAndEnd) {
  const auto expect_axes = [&](const std::string& lines, const Vec<3>& first, const Vec<3>& spacing) {
    const VoxelGrid read = exchange_space(read_voxel_grid(of_axes("sizes: 4 5 3\n" + lines)));
    EXPECT_LE((read.origin - first).norm(), 1e-14) << lines;
    EXPECT_LE((read.axes - Mat<3>(spacing.asDiagonal())).norm(), 1e-14) << lines;
  };
  expect_axes("axis mins: 1 2 3\naxis maxs: 9 4.5 4.5\n", {2, 2.25, 3.25}, {2, 0.5, 0.5});
  expect_axes("axismins: 1 2 3\naxismaxs: 9 4.5 4.5\ncenters: cell cell cell\n", {2, 2.25, 3.25}, {2, 0.5, 0.5});
  expect_axes("centerings: node node node\naxis mins: 1 2 3\naxis maxs: 7 4 4\n", {1, 2, 3}, {2, 0.5, 0.5});
  expect_axes("centers: node cell ???\naxis mins: 1 2 3\naxis maxs: 7 4.5 4.5\n", {1, 2.25, 3.25}, {2, 0.5, 0.5});
  expect_axes("axis mins: 1 2 3\nspacings: 2 0.5 0.5\n", {2, 2.25, 3.25}, {2, 0.5, 0.5});
  expect_axes("axis mins: 1 2 3\naxis maxs: 9 nan nan\nspacings: nan 0.5 0.5\n", {2, 2.25, 3.25}, {2, 0.5, 0.5});
  EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\nspacings: 1 -0.5 2\n")),
                       "the spacing of its voxels along axis 2 is -0.5, and must be positive"));
  EXPECT_EQ(volume_notes(read_voxel_grid(of_axes("sizes: 4 5 3\nspacings: 1 nan 2\n"))),
            std::vector<std::string>{"its header gives no spacing along axis 2: taken to be 1"});
  EXPECT_EQ(volume_notes(read_voxel_grid(of_axes("sizes: 4 5 3\n"))).size(), 3u);
  EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\naxis maxs: 9 4.5 4.5\n")),
                       "axis 1 has a maximum (axis maxs), but neither a minimum nor a spacing"));
  EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\naxis mins: 1 2 3\naxis maxs: 9 2 4\n")), "must be positive"));
}

// ITK up to 5.4.3 has what is left-anterior-superior half a turn from there, and has both files alike.
TEST_F(Nrrd, AFrameInWhichReadersDifferIsSaidAndKept) {
  const std::string frame =
      "space: left-anterior-superior\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n"
      "space origin: (7,8,9)\nsizes: 4 5 3\n";
  const Volume read = read_volume(of_axes(frame));
  EXPECT_EQ(read.grid.origin, Vec<3>(-7, 8, 9));
  EXPECT_TRUE(contains(volume_notes(read.grid).at(0), "half a turn about z"));
  write_volume(folder.path("b.nrrd"), read, Existing::is_replaced);
  EXPECT_TRUE(contains(folder.read("b.nrrd"), "space: left-anterior-superior\n"));
  EXPECT_TRUE(contains(folder.read("b.nrrd"), "space directions: (1,0,0) (0,2,0) (0,0,3)\n"));
  EXPECT_TRUE(contains(folder.read("b.nrrd"), "space origin: (7,8,9)\n"));
  EXPECT_EQ(read_volume(folder.path("b.nrrd")).grid.origin, read.grid.origin);
  // The components of vectors are along LPS, whatever the model: a reader of either kind has both alike then.
  const std::vector<float> vectors(3 * read.values.size());
  vector_volume_file(folder.path("v.nrrd"), read.grid, vectors, Existing::is_replaced).publish();
  EXPECT_TRUE(contains(folder.read("v.nrrd"), "space: left-posterior-superior\n"));
  EXPECT_EQ(read.grid.origin, Vec<3>(-7, 8, 9));
  const Volume scanner = read_volume(of_axes("space: scanner-xyz\n" + frame.substr(frame.find('\n') + 1)));
  EXPECT_TRUE(contains(scanner.grid.file->placed_by, "in LPS, as its space 'scanner-xyz' says nothing of a patient"));
}

// 3D Slicer's segmentations: segments have names, and where they overlap layers.
TEST_F(Nrrd, SegmentsByName) {
  const std::string keys =
      "Segment0_Name:=Femur\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment1_Name:=Tibia "
      "left\nSegment1_LabelValue:=2\n"
      "Segment1_Layer:=0\nSegment2_Name:=Femur and "
      "more\nSegment2_LabelValue:=1\nSegment2_Layer:=1\nSegment3_Name:=Lost\nSegment3_Layer:=7\n"
      "Segmentation_MasterRepresentation:=Binary labelmap\n";
  // Layer 0: 1 where i = 0, 2 where i = 3; layer 1: 1 where i < 2.
  const auto of_layers = [&](const std::string& header, bool layers_first) {
    std::string bytes(120, '\0');
    for (std::size_t v = 0; v < 60; ++v) {
      bytes[layers_first ? 2 * v : v] = v % 4 == 0 ? 1 : v % 4 == 3 ? 2 : 0;
      bytes[layers_first ? 2 * v + 1 : 60 + v] = v % 4 < 2 ? 1 : 0;
    }
    return folder.write("a.seg.nrrd",
                        "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nencoding: "
                        "raw\nspace origin: (1,2,3)\n" +
                            header + keys + "\n" + bytes);
  };
  const std::string first =
      "sizes: 2 4 5 3\nkinds: list domain domain domain\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\n";
  const std::string last =
      "sizes: 4 5 3 2\nkinds: domain domain domain list\nspace directions: (1,0,0) (0,2,0) (0,0,3) none\n";
  for (const bool layers_first : {true, false}) {
    const std::string file = of_layers(layers_first ? first : last, layers_first);
    const auto n_chosen = [&](const std::string& choice) {
      const VolumePart part = read_volume_part(*parse_volume_name(file + choice));
      EXPECT_EQ(part.volume.values.size(), 60u);
      EXPECT_EQ(exchange_space(part.volume.grid.position({1, 1, 1})), Vec<3>(2, 4, 6));
      return std::ranges::count_if(part.volume.values, [&](float v) { return part.choice.contains(v); });
    };
    EXPECT_EQ(n_chosen(":Femur"), 15);
    EXPECT_EQ(n_chosen(":Tibia left"), 15);
    EXPECT_EQ(n_chosen(":Femur and more"), 30);
    EXPECT_EQ(n_chosen(""), 45);
    const auto refused = [&](const std::string& choice) { return input_error_of([&] { n_chosen(choice); }); };
    EXPECT_TRUE(
        contains(refused(":Fibula"), "has no segment 'Fibula'; there are Femur, Tibia left, Femur and more, Lost"));
    EXPECT_TRUE(contains(refused(":Lost"), "is in layer 7, and there are 2"));
    EXPECT_TRUE(contains(refused(":1"), "has 2 layers, each with labels of its own; name the segment"));
    EXPECT_TRUE(contains(refusal(file), "a segmentation in 2 layers"));
    folder.write("b.seg.nrrd", folder.read("a.seg.nrrd").substr(0, folder.read("a.seg.nrrd").size() - 1));
    EXPECT_TRUE(contains(refusal(folder.path("b.seg.nrrd") + ""), "layers"));
    EXPECT_TRUE(
        contains(input_error_of([&] { read_volume_part(*parse_volume_name(folder.path("b.seg.nrrd") + ":Femur")); }),
                 "cut off"));
  }
  // One layer is a volume of labels as any other.
  const std::string one = folder.write("one.seg.nrrd", std::string(whole).insert(9, keys));
  EXPECT_EQ(read_volume_part(*parse_volume_name(one + ":Tibia left")).choice.labels, std::vector<double>{2});
  EXPECT_EQ(read_volume(one).values, volume.values);
  EXPECT_TRUE(contains(
      input_error_of([&] { read_volume_part(*parse_volume_name(folder.write("none.nrrd", whole) + ":Femur")); }),
      "it names no segments"));
  EXPECT_TRUE(contains(
      refusal(of_layers(
          "sizes: 2 4 5 3\nkinds: vector domain domain domain\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\n",
          true)),
      "has 4 dimensions"));
}

}  // namespace
}  // namespace shellmatch::testing
