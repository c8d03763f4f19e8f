// Surfaces of labels: volume, place, smoothness; noise, borders and blocks; independence of the order of voxels and of
// the frame.
#include "geometry/label/volume_shape.h"
#include "geometry/volume/volume_file.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace shellmatch::testing {
namespace {

Shape<3> shape_of(const Volume& volume, const std::string& choice = "", Space space = Space::ras) {
  const TempFolder folder;
  const std::string file = folder.path("a.nrrd");
  write_volume(file, volume, Existing::is_replaced);
  return volume_shape(*parse_volume_name(file + choice), "a.nrrd" + choice, space);
}

double ball(const Vec<3>& x, const Vec<3>& centre, double radius) { return (x - centre).norm() < radius ? 1 : 0; }

TEST(VolumeShape, ABallHasItsVolumeItsPlaceAndNoStairs) {
  const Vec<3> centre(3.1, -2.3, 7.7);
  constexpr double r = 12.3;
  for (const Vec<3>& spacing : {Vec<3>(1, 1, 1), Vec<3>(0.7, 1, 1.9)}) {
    const std::array<int, 3> size{static_cast<int>(34 / spacing[0]), static_cast<int>(34 / spacing[1]),
                                  static_cast<int>(34 / spacing[2])};
    const Shape<3> shape = shape_of(
        volume_of(grid_over({-14, -19, -9}, spacing, size), [&](const Vec<3>& x) { return ball(x, centre, r); }));
    EXPECT_TRUE(is_closed_and_oriented(shape.surface));
    EXPECT_NEAR(volume(shape.surface) / (4.0 / 3 * std::numbers::pi * r * r * r), 1, 0.02);
    double area = 0, deviation = 0, largest = 0;
    Vec<3> mean = Vec<3>::Zero();
    for (Index f = 0; f < static_cast<Index>(shape.surface.facets.size()); ++f) {
      const double share = facet_measure(shape.surface, f);
      area += share;
      for (const Index v : shape.surface.facets[static_cast<std::size_t>(f)])
        mean += share / 3 * shape.surface.vertices[static_cast<std::size_t>(v)];
    }
    mean /= area;
    for (const Vec<3>& x : shape.surface.vertices) {
      const double d = std::abs((x - centre).norm() - r);
      deviation += d / static_cast<double>(shape.surface.vertices.size());
      largest = std::max(largest, d);
    }
    // Stairs would have 1.5 times the area.
    EXPECT_NEAR(area / (4 * std::numbers::pi * r * r), 1, 0.025);
    EXPECT_LT(deviation, 0.13 * spacing.maxCoeff());
    EXPECT_LT(largest, 0.75 * spacing.maxCoeff());
    EXPECT_LT((mean - centre).norm(), 0.2 * spacing.maxCoeff());
    EXPECT_TRUE(has_note(shape, "everything above 0: "));
    EXPECT_TRUE(has_note(shape, "from the voxels' boundary on average"));
    EXPECT_TRUE(has_note(shape, "its volume 1.00 times theirs") || has_note(shape, "its volume 0.99 times theirs"))
        << shape.notes[0];
    EXPECT_FALSE(has_note(shape, "the surface has only"));
  }
}

TEST(VolumeShape, DoesNotDependOnTheOrderOfVoxelsNorOnTheFrameOfTheFile) {
  const auto label = [](const Vec<3>& x) { return ball(x, {6, 5, 4}, 4.2) + ball(x, {9, 7, 5}, 3) > 0 ? 1.0 : 0.0; };
  const std::array<int, 3> size{17, 14, 11};
  const VoxelGrid straight = grid_over({0, 0, 0}, {1, 1, 1}, size),
                  turned = grid_over({0, 0, 0}, {1, 1, 1}, size, {true, true, false});
  const TempFolder folder;
  const auto read = [&](const std::string& name, const std::string& bytes, Space space) {
    const std::string file = folder.write(name, bytes);
    return volume_shape({file, {}}, file, space).surface;
  };
  const Surface<3> expected = read("a.nii", nifti(volume_of(straight, label)), Space::ras);
  for (const VoxelGrid& grid : {straight, turned, permuted(turned)}) {
    const Volume v = volume_of(grid, label);
    EXPECT_EQ(read("b.nii", nifti(v), Space::ras).vertices, expected.vertices);
    EXPECT_EQ(read("b.nrrd", nrrd(v, true), Space::ras).vertices, expected.vertices);
    EXPECT_EQ(read("c.nrrd", nrrd(v, false), Space::ras).vertices, expected.vertices);
  }
  EXPECT_EQ(read("d.mha", meta_image(volume_of(turned, label)), Space::ras).vertices, expected.vertices);
  const Surface<3> lps = read("a.nii", nifti(volume_of(turned, label)), Space::lps);
  EXPECT_EQ(lps.facets, expected.facets);
  for (std::size_t v = 0; v < lps.vertices.size(); ++v)
    EXPECT_EQ(lps.vertices[v], exchange_space(expected.vertices[v]));
}

TEST(VolumeShape, ChoosesLabels) {
  const auto parts = [](const Vec<3>& x) {
    return ball(x, {10, 10, 10}, 7) == 0 ? 0 : x[0] < 10 ? 1 : x[1] < 10 ? 2 : 5;
  };
  const Volume labels = volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {21, 21, 21}), parts);
  const double whole = volume(shape_of(labels).surface), first = volume(shape_of(labels, ":1").surface),
               others = volume(shape_of(labels, ":2,5").surface);
  EXPECT_NEAR(first / whole, 0.447, 0.02);  // cut half a voxel beside the centre
  EXPECT_NEAR((first + others) / whole, 1, 0.02);
  EXPECT_NEAR(volume(shape_of(labels, ":>1").surface), others, 1e-9);
  const auto refusal = [&](const std::string& choice) { return input_error_of([&] { shape_of(labels, choice); }); };
  EXPECT_TRUE(contains(refusal(":3"), "no voxel has the label 3; there are the labels 1, 2, 5"));
  EXPECT_TRUE(contains(refusal(":1,3,4"), "no voxel has the label 3, 4"));
  EXPECT_TRUE(contains(refusal(":>5"), "no voxel is above 5: its values are from 0 to 5"));
  EXPECT_TRUE(contains(refusal(":>-1"), "every voxel is in the shape"));
  const Volume grey = volume_of(
      labels.grid, [](const Vec<3>& x) { return 0.1 * x[0]; }, VoxelType::float32);
  EXPECT_TRUE(contains(input_error_of([&] { shape_of(grey, ":3"); }), "and no labels: choose a threshold"));
}

TEST(VolumeShape, NoiseGoesAndIsSaid) {
  const VoxelGrid grid = grid_over({0, 0, 0}, {1, 1, 1}, {30, 24, 24});
  const auto clean = [](const Vec<3>& x) { return ball(x, {10, 11, 11}, 8); };
  const auto noisy = [&](const Vec<3>& x) {
    const bool island = x[0] > 20 && x[0] < 23 && x[1] > 3 && x[1] < 6 && x[2] > 3 && x[2] < 6;  // 8 voxels
    const bool speck = x == Vec<3>(27, 20, 20),
               cavity = (x - Vec<3>(10, 11, 11)).cwiseAbs().maxCoeff() < 1 && x[0] == 10;
    return island || speck ? 1.0 : cavity ? 0.0 : clean(x);
  };
  const Shape<3> shape = shape_of(volume_of(grid, noisy));
  EXPECT_TRUE(has_note(shape, "2 islands of fewer than 27 voxels dropped (9 voxels)"));
  EXPECT_TRUE(has_note(shape, "1 cavity of fewer than 27 voxels filled (1 voxel)"));
  EXPECT_EQ(shape.surface.facets, shape_of(volume_of(grid, clean)).surface.facets);
  // A cavity as large as an organ's stays, and so does a second part.
  const Shape<3> hollow = shape_of(volume_of(grid, [&](const Vec<3>& x) {
    return clean(x) - ball(x, {10, 11, 11}, 4) + ball(x, {25, 11, 11}, 3.5);
  }));
  EXPECT_NEAR(volume(hollow.surface) / (4.0 / 3 * std::numbers::pi * (512 - 64 + 42.9)), 1, 0.03);
}

TEST(VolumeShape, ClosesWhatTheBorderCuts) {
  const Shape<3> shape = shape_of(volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {12, 24, 24}), [](const Vec<3>& x) {
    return ball(x, {0, 11, 11}, 8);
  }));
  EXPECT_TRUE(is_closed_and_oriented(shape.surface));
  EXPECT_TRUE(has_note(shape, "it reaches the border of the volume (193 voxels) and is closed there: that part, "))
      << shape.notes.back();
  EXPECT_NEAR(bounding_box(shape.surface.vertices).min.x(), -0.5, 0.1);
  // The disc and the first voxel of the side are made up; the rest is that of the whole ball.
  const double r = 8, disc = r * r, side = 2 * r;                                // over pi
  EXPECT_NEAR(shape.invented_share, (disc + side) / (disc + side * 8.5), 0.05);  // its edge is rounded
  EXPECT_NEAR(surface_measure(shape.evidence.unobserved) / surface_measure(shape.surface), shape.invented_share, 1e-12);
  for (const Vec<3>& x : shape.surface.vertices)
    EXPECT_TRUE(x[0] < 0.8 || std::abs((x - Vec<3>(0, 11, 11)).norm() - 7.9) < 0.4);
  for (const auto& facet : shape.evidence.observed.facets) {
    Vec<3> centre = Vec<3>::Zero();
    for (const Index v : facet) centre += shape.evidence.observed.vertices[static_cast<std::size_t>(v)] / 3;
    EXPECT_GT(centre[0], 0.5);
  }
}

// The frame of the result is that of the mesh beside it, the border that of the volume.
TEST(VolumeShape, TheBorderIsFoundInEitherFrameAndAtEitherEnd) {
  const VoxelGrid grid = grid_over({-30, -7, 4}, {1, 1.5, 1}, {12, 16, 24});
  const auto label = [](const Vec<3>& x) { return ball(x, {-19, 5, 15}, 8); };
  const Shape<3> shape = shape_of(volume_of(grid, label)), other = shape_of(volume_of(grid, label), "", Space::lps);
  EXPECT_GT(shape.invented_share, 0.3);
  EXPECT_EQ(shape.invented_share, other.invented_share);
  for (const auto& facet : shape.evidence.observed.facets)
    for (const Index v : facet) EXPECT_LT(shape.evidence.observed.vertices[static_cast<std::size_t>(v)][0], -19);
  // One free layer of voxels, and nothing is cut.
  const Shape<3> whole = shape_of(volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {13, 13, 13}), [](const Vec<3>& x) {
    return ball(x, {6, 6, 6}, 5.5);
  }));
  EXPECT_TRUE(whole.evidence.is_complete());
  EXPECT_EQ(whole.invented_share, 0);
  // Two slices have hardly any surface but the border.
  const Shape<3> flat = shape_of(volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {24, 24, 2}), [](const Vec<3>& x) {
    return ball({x[0], x[1], 11}, {11, 11, 11}, 8);
  }));
  EXPECT_TRUE(flat.evidence.is_complete());
  EXPECT_TRUE(has_note(flat, "hardly anything else is seen of it"));
}

// Voxels that touch along edges and at corners, threads and bubbles: whatever the label, its surface is closed.
TEST(VolumeShape, NoiseHasASurface) {
  for (const double z : {1.0, 3.0})
    for (const unsigned seed : {1u, 2u, 3u}) {
      std::uint32_t state = seed;
      const auto random = [&] { return state = 1664525 * state + 1013904223, state >> 16; };
      const VoxelGrid grid = grid_over({0, 0, 0}, {1, 1, z}, {20, 20, 20});
      Volume noise = volume_of(grid, [&](const Vec<3>& x) {
        const Vec<3> i(x[0], x[1], x[2] / z);
        return i.minCoeff() > 1.5 && i.maxCoeff() < 17.5 && random() % 5 < 2 ? 1.0 : 0.0;
      });
      const Shape<3> shape = shape_of(noise);
      EXPECT_TRUE(is_closed_and_oriented(shape.surface));
      EXPECT_GT(shape.surface.facets.size(), 1000u);
    }
}

TEST(VolumeShape, SmallAndThinLabelsAreRefusedOrKept) {
  const auto refusal = [](const std::function<double(const Vec<3>&)>& label) {
    return input_error_of([&] { shape_of(volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {24, 24, 24}), label)); });
  };
  EXPECT_TRUE(contains(refusal([](const Vec<3>& x) { return x == Vec<3>(5, 5, 5); }),
                       "everything above 0 has 1 voxel: too small"));
  EXPECT_EQ(refusal([](const Vec<3>& x) { return (x - Vec<3>(5, 5, 5)).cwiseAbs().maxCoeff() < 1.5; }), "");
  EXPECT_EQ(refusal([](const Vec<3>& x) { return x[0] == 5 && x[1] > 3 && x[1] < 20 && x[2] > 3 && x[2] < 20; }),
            "");  // a sheet
}

TEST(VolumeShape, LargeLabelsAreTakenInBlocks) {
  const Shape<3> shape = shape_of(volume_of(grid_over({0, 0, 0}, {0.1, 1, 1}, {600, 16, 16}), [](const Vec<3>& x) {
    return ball(Vec<3>(x[0] / 4, x[1], x[2]), {7.5, 7.5, 7.5}, 6.5);
  }));
  EXPECT_TRUE(has_note(shape, "blocks of 4 x 1 x 1 voxels are taken as one"));
  EXPECT_NEAR(volume(shape.surface) / (16.0 / 3 * std::numbers::pi * 6.5 * 6.5 * 6.5), 1, 0.03);
}

// Sheets across the long axis: no block of 4 x 1 x 1 voxels is more than half full, and most are too empty for any
// level.
TEST(VolumeShape, TheLossOfThinPartsInBlocksIsSaid) {
  const Shape<3> shape = shape_of(volume_of(grid_over({0, 0, 0}, {0.1, 1, 1}, {600, 48, 16}), [](const Vec<3>& x) {
    const double i = std::round(10 * x[0]);
    const bool is_sheet = i == 20 || i == 580, is_thick = (i == 21 || i == 581) && x[1] < 8;
    return x[1] > 3 && x[1] < 44 && x[2] > 3 && x[2] < 12 && (is_sheet || is_thick) ? 1.0 : 0.0;
  }));
  EXPECT_TRUE(has_note(shape, "blocks of 4 x 1 x 1 voxels are taken as one"));
  EXPECT_FALSE(has_note(shape, "nan")) << shape.notes[0];
  const double n_voxels = 2 * 8 * 44, share = volume(shape.surface) / (0.1 * n_voxels);
  EXPECT_LT(share, 0.8);
  EXPECT_TRUE(has_note(shape, fmt::format("of a voxel, the surface has {:.2f} times their volume", share)))
      << shape.notes[0];
  EXPECT_TRUE(has_note(shape, fmt::format("the surface has only {:.0f} % of the label's volume", 100 * share)))
      << shape.notes[1];
}

}  // namespace
}  // namespace shellmatch::testing
