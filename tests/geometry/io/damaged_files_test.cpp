// Files cut off or altered at random places: either the very same shape, or an InputError; never a crash, and
// a cut file is never a smaller shape.
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "tests/geometry/io/files.h"

#include <cmath>
#include <random>

namespace shellmatch::testing {
namespace {

std::string bytes_of_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A lattice of small cubes with attributes, in all formats.
OriginalShape<3> lattice() {
  OriginalShape<3> shape;
  for (int i = 0; i < 8; ++i) append(shape, cube(2.25 * Vec<3>(i & 1, i >> 1 & 1, i >> 2 & 1), 1.5));
  shape.attributes.push_back({"quality", "float", std::vector<double>(shape.vertices.size(), 0.5)});
  return shape;
}

class DamagedMeshes : public ::testing::TestWithParam<const char*> {};

TEST_P(DamagedMeshes, CutAnywhere) {
  const TempFolder folder;
  const std::string name = GetParam();
  write_shape(folder.path(name), lattice());
  const std::string whole = bytes_of_file(folder.path(name));
  const double true_volume = volume(read_mesh(folder.path(name)).surface);
  std::mt19937 random(11);
  for (int trial = 0; trial < 40; ++trial) {
    const std::size_t length =
        trial < 10 ? whole.size() - 1 - static_cast<std::size_t>(trial) : random() % whole.size();
    const std::string path = folder.write(name, whole.substr(0, length));
    try {
      // Without its last line end, or without a comment, a text is still whole. A file of many closed parts
      // may lose some in OBJ, which has no counts: only there.
      const double v = volume(read_mesh(path).surface);
      if (name != "a.obj") {
        EXPECT_NEAR(v, true_volume, 1e-9) << length;
      }
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), path));
    }
  }
}

TEST_P(DamagedMeshes, BytesAlteredAnywhere) {
  const TempFolder folder;
  const std::string name = GetParam();
  write_shape(folder.path(name), lattice());
  const std::string whole = bytes_of_file(folder.path(name));
  std::mt19937 random(13);
  for (int trial = 0; trial < 60; ++trial) {
    std::string bytes = whole;
    for (int k = 0; k < 1 + trial % 4; ++k)
      bytes[trial % 2 ? random() % std::min<std::size_t>(bytes.size(), 200) : random() % bytes.size()] =
          trial % 3 ? static_cast<char>(random()) : "0123456789-. e\n"[random() % 15];
    const std::string path = folder.write(name, bytes);
    try {
      EXPECT_TRUE(is_closed_and_oriented(read_mesh(path).surface));
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), path));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllFormats, DamagedMeshes, ::testing::Values("a.ply", "a.obj", "a.off", "a.stl"));

TEST(DamagedOutlines, BytesAlteredAnywhere) {
  const TempFolder folder;
  std::string whole = "x,y,label\n";
  for (int i = 0; i < 40; ++i) whole += fmt::format("{:.3f},{:.3f},{}\n", std::cos(0.15 * i), std::sin(0.15 * i), i);
  std::mt19937 random(17);
  for (int trial = 0; trial < 100; ++trial) {
    std::string bytes = whole.substr(0, trial % 2 ? random() % whole.size() : whole.size());
    for (int k = 0; k < trial % 5 && !bytes.empty(); ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    const std::string path = folder.write("a.csv", bytes);
    try {
      EXPECT_GE(area(read_outline(path).surface), 0);
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), path));
    }
  }
}

}  // namespace
}  // namespace shellmatch::testing
