// Subjects that are reflected.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "apps/cohorts/subjects/mirrored.h"
#include "geometry/io/read_shape.h"
#include "matching/pairs/landmark_file.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

TEST(Mirrored, TheFirstCoordinateChangesItsSignAndFacetsStayOutward) {
  const fs::path folder = fs::path(testing::TempDir()) / "shellmatch_mirrored";
  fs::create_directories(folder);
  std::ofstream(folder / "t.off") << "OFF\n4 4 0\n1 0 0\n3 0 0\n1 1 0\n1 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  std::ofstream(folder / "p.csv") << "name,vertex\ntip,1\n";
  Subject subject{"t", (folder / "t.off").string(), (folder / "p.csv").string(), "", true, {}};
  const std::string file = mirrored_shape(subject, {}, (folder / "m").string());
  const Shape<3> image = read_mesh(file);
  EXPECT_EQ(image.original.vertices[1], Vec<3>(-3, 0, 0));
  EXPECT_EQ(image.original.vertices[3], Vec<3>(-1, 0, 1));
  EXPECT_NEAR(enclosed_measure(Surface<3>{read_triangles(file)}), 1. / 3, 1e-12) << "its facets point inward";
  std::vector<std::string> notes;
  const auto points = read_named_points<3>(mirrored_landmarks(subject, {}, (folder / "m").string()),
                                           image.original.vertices, Space::unsaid, Space::unsaid, notes);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].point, Vec<3>(-3, 0, 0));
  // What cannot be read is left to the matching.
  subject.source = (folder / "none.off").string();
  EXPECT_EQ(mirrored_shape(subject, {}, (folder / "m").string()), subject.source);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace shellmatch
