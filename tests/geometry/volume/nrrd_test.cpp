// NRRD: long headers, fields of the axes in any order, and axes by where they begin and end.
#include "geometry/volume/volume_file.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"

namespace shellmatch::testing {
namespace {

class Nrrd : public ::testing::Test {
 protected:
  /// The same file with more lines in its header.
  std::string with_lines(const std::string& lines) const { return folder.write("lines.nrrd", std::string(whole).insert(9, lines)); }
  /// A file of 4 x 5 x 3 bytes with these lines about its axes.
  std::string of_axes(const std::string& lines) const {
    return folder.write("axes.nrrd", "NRRD0004\ntype: uchar\nencoding: raw\ndimension: 3\n" + lines + "\n" + std::string(60, '\1'));
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
  for (const std::size_t n : {std::size_t{65000}, 65536 - rest - 1, 65536 - rest, 65536 - rest + 1, std::size_t{65536}, 262144 - rest,
                              262145 - rest, std::size_t{3000000}})
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
  EXPECT_TRUE(contains(refusal(folder.write("late.nrrd", std::string(whole).insert(whole.find("\n\n") + 1, protocol + "\n"))), message));
  std::string none = whole.substr(0, whole.find("\n\n") + 1);
  EXPECT_TRUE(contains(refusal(folder.write("none.nrrd", none)), "its header does not end"));
  // The values of a header by itself are elsewhere.
  folder.write("values.raw", whole.substr(whole.size() - 60));
  EXPECT_EQ(read_volume(folder.write("detached.nhdr", none + "data file: values.raw\n")).values, volume.values);
}

TEST_F(Nrrd, AxesHaveAnEntryForEachDimension) {
  for (const std::string field : {"spacings", "axis mins", "axis maxs"})
    for (const std::string numbers : {"1", "1 2", "1 2 3 4"}) {
      const std::string message = field + " has " + std::to_string((numbers.size() + 1) / 2) + " entries for 3 dimensions";
      EXPECT_TRUE(contains(refusal(of_axes(field + ": " + numbers + "\nsizes: 4 5 3\n")), message));
      EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\n" + field + ": " + numbers + "\n")), message));
    }
  EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\ncenters: cell cell\n")), "centers has 2 entries for 3 dimensions"));
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
  EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\naxis maxs: 9 4.5 4.5\n")),
                       "axis 1 has a maximum (axis maxs), but neither a minimum nor a spacing"));
  EXPECT_TRUE(contains(refusal(of_axes("sizes: 4 5 3\naxis mins: 1 2 3\naxis maxs: 9 2 4\n")), "must be positive"));
}

}  // namespace
}  // namespace shellmatch::testing
