// Volumes as a user has them: one map whatever the format, what the map carries, and its fields in other programs.
#include "geometry/distance/surface_distance.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "geometry/label/volume_shape.h"
#include "geometry/volume/grid_file.h"
#include "geometry/volume/volume_file.h"
#include "matching/map_file/deformation_file.h"
#include "matching/map_file/user_map.h"
#include "tests/apps/cli_harness.h"
#include "tests/apps/itk_transform.h"
#include "tests/apps/volume_folder.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"
#include "tests/support/folders.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

namespace shellmatch {
namespace {

using namespace testing;

using Folder = VolumeFolder;

const VoxelGrid grid = grid_over({-12, 30, 4}, {1, 1, 1}, {28, 24, 22});
const VoxelGrid turned = grid_over({-12, 30, 4}, {1, 1, 1}, {28, 24, 22}, {true, true, false});

// Two lobes of two labels; the template's are bent and thicker.
double lobes(const Vec<3>& x, double bend, double thick) {
  const Vec<3> p(x[0] - 1.7, x[1] - 41.2 - bend * std::pow(x[0] - 1.7, 2), x[2] - 14.6);
  const bool is_in =
      std::pow(p[0] / 10.3, 2) + std::pow(p[1] / (5.1 + thick), 2) + std::pow(p[2] / (4.4 + 0.15 * p[0]), 2) < 1;
  return !is_in ? 0 : p[0] < 1 ? 1 : 2;
}
double in_reference(const Vec<3>& x) { return lobes(x, 0, 0); }
double in_template(const Vec<3>& x) { return lobes(x, 0.02, 1); }

ProgramResult run(const std::vector<std::string>& words) {
  ProgramResult result = run_program(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result;
}

void match(const std::string& reference, const std::string& target, const std::string& output,
           const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"match", reference, target,          "-o",      output, "--levels",
                                 "3:4",   "--set",   "pictures=none", "--align", "none", "-q"};
  words.insert(words.end(), more.begin(), more.end());
  run(words);
}

std::vector<Vec<3>> deformed(const std::string& folder) {
  return read_points_or_mesh_3d(folder + "/deformed.ply").vertices;
}

double largest_distance(const std::vector<Vec<3>>& a, const std::vector<Vec<3>>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t v = 0; v < std::min(a.size(), b.size()); ++v) largest = std::max(largest, (a[v] - b[v]).norm());
  return largest;
}

// One map for all tests.
class Volumes : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    tmp = new Folder;
    write(*tmp / "a.nii", nifti(volume_of(grid, in_reference)));
    write(*tmp / "b.nii", nifti(volume_of(grid, in_template)));
    match(*tmp / "a.nii", *tmp / "b.nii", *tmp / "out");
  }
  static void TearDownTestSuite() { delete tmp; }
  static ProgramResult refused(const std::vector<std::string>& words) {
    ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    return result;
  }
  static Folder* tmp;
};
Folder* Volumes::tmp = nullptr;

TEST_F(Volumes, OneMapWhateverTheFormatAndTheOrderOfVoxels) {
  const Folder other;
  const std::vector<Vec<3>> expected = deformed(*tmp / "out");
  write(other / "turned_a.nii", nifti(volume_of(turned, in_reference)));
  write(other / "turned_b.nii", nifti(volume_of(permuted(turned), in_template)));
  match(other / "turned_a.nii", other / "turned_b.nii", other / "turned");
  EXPECT_LT(largest_distance(deformed(other / "turned"), expected), 1e-6);
  write(other / "a.nrrd", nrrd(volume_of(turned, in_reference), true));
  write(other / "b.mha", meta_image(volume_of(turned, in_template)));
  match(other / "a.nrrd", other / "b.mha:1,2", other / "others");
  EXPECT_LT(largest_distance(deformed(other / "others"), expected), 1e-6);
  write_shape(other / "a.ply", volume_shape({*tmp / "a.nii", {}}, "a", Space::ras).original);
  match(other / "a.ply", *tmp / "b.nii", other / "mesh");
  EXPECT_LT(largest_distance(deformed(other / "mesh"), expected), 1e-6);
}

TEST_F(Volumes, AMeshInLpsAndAVolumeLieInOnePlace) {
  const Folder other;
  write_shape(other / "plain.ply", volume_shape({*tmp / "a.nii", {}}, "a", Space::lps).original);
  std::ifstream file(other / "plain.ply", std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  write(other / "slicer.ply", bytes.insert(bytes.find("element vertex"), "comment 3D Slicer output. SPACE=LPS\n"));
  match(other / "slicer.ply", *tmp / "b.nii", other / "out");
  std::vector<Vec<3>> expected = deformed(*tmp / "out");
  for (Vec<3>& x : expected) x = exchange_space(x);
  EXPECT_LT(largest_distance(deformed(other / "out"), expected), 0.5);
  EXPECT_EQ(read_deformation<3>(other / "out").space, Space::lps);
  EXPECT_EQ(read_deformation<3>(*tmp / "out").space, Space::ras);
  // The carried volume does not know of that.
  run({"apply", *tmp / "out", *tmp / "a.nii", "-o", other / "from_ras.nii"});
  run({"apply", other / "out", *tmp / "a.nii", "-o", other / "from_lps.nii"});
  const Volume a = read_volume(other / "from_ras.nii"), b = read_volume(other / "from_lps.nii");
  std::size_t n_different = 0;
  for (std::size_t v = 0; v < a.values.size(); ++v) n_different += a.values[v] != b.values[v];
  EXPECT_LT(n_different, 40u);
  // The user's word counts more than the mesh's, which is converted.
  const ProgramResult result =
      run_program({"match", other / "slicer.ply", *tmp / "b.nii", "-o", other / "ras", "--levels", "3:3", "--set",
                   "pictures=none", "--align", "none", "--set", "input.space=ras"});
  EXPECT_NE(result.err.find("slicer.ply: from LPS to RAS"), std::string::npos) << result.err;
  EXPECT_EQ(read_deformation<3>(other / "ras").space, Space::ras);
}

TEST_F(Volumes, LabelsAreCarriedOntoTheTemplate) {
  run({"apply", *tmp / "out", *tmp / "a.nii", "-o", *tmp / "carried.nii.gz", "--like", *tmp / "b.nii"});
  const Volume carried = read_volume(*tmp / "carried.nii.gz"), target = volume_of(grid, in_template);
  EXPECT_EQ(carried.type, VoxelType::uint8);
  double both = 0, sum = 0;
  for (std::size_t v = 0; v < carried.values.size(); ++v) {
    both += carried.values[v] > 0 && target.values[v] > 0;
    sum += (carried.values[v] > 0) + (target.values[v] > 0);
    EXPECT_LE(carried.values[v], 2);
  }
  EXPECT_GT(2 * both / sum, 0.97);
  // A label's surface is carried as a mesh.
  run({"apply", *tmp / "out", *tmp / "a.nii:2", "-o", *tmp / "second.ply"});
  EXPECT_EQ(read_points_or_mesh_3d(*tmp / "second.ply").vertices.size(),
            volume_shape({*tmp / "a.nii", {{2}, 0}}, "a", Space::ras).original.vertices.size());
}

TEST_F(Volumes, GreyValuesArePulledBackExactly) {
  const Deformation<3> map = read_deformation<3>(*tmp / "out");
  for (const bool inverse : {false, true}) {
    // The value is a coordinate of the place that it comes from.
    write_volume(*tmp / "grey.nrrd",
                 volume_of(
                     grid_over({-20, 20, -5}, {2, 2, 2}, {25, 25, 25}, {true, false, true}),
                     [](const Vec<3>& x) { return x[1] + 0.53 * x[0]; }, VoxelType::float64),
                 Existing::is_replaced);
    std::vector<std::string> words{"apply",  *tmp / "out",   *tmp / "grey.nrrd", "-o", *tmp / "pulled.mha",
                                   "--like", *tmp / "a.nii", "--force"};
    if (inverse) words.push_back("--inverse");
    run(words);
    const Volume pulled = read_volume(*tmp / "pulled.mha");
    const UserMap<3> back(map, inverse ? Toward::template_shape : Toward::reference, false);
    std::size_t n_inside = 0;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 0; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          const auto x = back.within_domain(pulled.grid.position(Vec<3>(i, j, k)));
          const float value = pulled.values[grid.number(i, j, k)];
          EXPECT_NEAR(value, x ? (*x)[1] + 0.53 * (*x)[0] : 0, 1e-4);
          n_inside += x.has_value();
        }
    EXPECT_GT(n_inside, 5000u);
  }
}

TEST_F(Volumes, ResultsAreInTheUnitOfTheirVoxels) {
  const Folder other;
  Volume a = volume_of(grid, in_reference);
  for (const std::string unit : {"cm", ""}) {
    a.grid = grid;
    a.grid.unit = unit;
    if (unit == "cm") {  // the same place
      a.grid.axes /= 10;
      a.grid.origin /= 10;
    }
    write_volume(other / "a.nrrd", a, Existing::is_replaced);
    run({"apply", *tmp / "out", other / "a.nrrd", "-o", other / "moved.nrrd", "--displacement", other / "u.nii",
         "--jacobian", other / "j.nii", "--force"});
    run({"apply", *tmp / "out", *tmp / "a.nii", "--like", other / "a.nrrd", "-o", other / "like.nrrd", "--force"});
    for (const char* name : {"moved.nrrd", "like.nrrd"}) {
      EXPECT_EQ(read_voxel_grid(other / name).unit, unit.empty() ? "" : "mm") << name;
      EXPECT_EQ(read_voxel_grid(other / name).file->unit, unit) << name;
      EXPECT_NEAR(read_voxel_grid(other / name).axes(0, 0), 1, 1e-12) << name;
    }
    EXPECT_EQ(read_voxel_grid(other / "j.nii").unit, unit.empty() ? "" : "mm");
    EXPECT_NEAR(read_voxel_grid(other / "j.nii").axes(0, 0), 1, 1e-6);
    EXPECT_EQ(other.read("u.nii")[123], unit.empty() ? 0 : 2);
  }
}

TEST_F(Volumes, ItkMovesPointsByOurField) {
  const Deformation<3> map = read_deformation<3>(*tmp / "out");
  for (const bool inverse : {false, true}) {
    std::vector<std::string> words{"apply",  *tmp / "out",   "--displacement", *tmp / "field.nii.gz",
                                   "--like", *tmp / "a.nii", "--force"};
    if (inverse) words.push_back("--inverse");
    run(words);
    const UserMap<3> ours(map, inverse ? Toward::reference : Toward::template_shape, false);
    const auto displacement = [&](const Vec<3>& x) { return Vec<3>(ours(x).value() - x); };
    std::vector<LpsPoint> points;
    std::vector<Vec<3>> in_ras;
    const auto add = [&](const Vec<3>& x) {
      const Vec<3> lps = exchange_space(x);
      in_ras.push_back(x);
      points.push_back({lps[0], lps[1], lps[2]});
    };
    for (int i = 1; i < 20; ++i) add(grid.position(Vec<3>(i, i, i)));  // centres of voxels
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(2, 18);
    for (int n = 0; n < 500; ++n) add(grid.position(Vec<3>(anywhere(random), anywhere(random), anywhere(random))));
    // Linear interpolation errs by an eighth of the second differences along each axis; the corners' own count as well.
    double second = 0;
    for (std::size_t n = 19; n < in_ras.size(); ++n)
      for (int k = 0; k < 3; ++k)
        second = std::max(second, (displacement(in_ras[n] + Vec<3>::Unit(k)) - 2 * displacement(in_ras[n]) +
                                   displacement(in_ras[n] - Vec<3>::Unit(k)))
                                      .norm());
    const double tolerance = 3 * second / 4;
    EXPECT_LT(tolerance, 0.6);
    const std::vector<LpsPoint> moved = moved_by_itk(*tmp / "field.nii.gz", points);
    double largest = 0, mean_displacement = 0;
    for (std::size_t n = 0; n < points.size(); ++n) {
      const Vec<3> expected = exchange_space(ours(in_ras[n]).value());
      const double error = (Vec<3>(moved[n][0], moved[n][1], moved[n][2]) - expected).norm();
      if (n < 19) {
        EXPECT_LT(error, 1e-5);
      }
      largest = std::max(largest, error);
      mean_displacement += displacement(in_ras[n]).norm() / static_cast<double>(points.size());
    }
    EXPECT_LT(largest, tolerance);
    EXPECT_GT(mean_displacement, 3 * largest) << "the field says something";
  }
}

TEST_F(Volumes, DeterminantsSayHowVolumesChange) {
  run({"apply", *tmp / "out", "--jacobian", *tmp / "j.nii", "--log-jacobian", *tmp / "log.nii", "--like",
       *tmp / "a.nii"});
  run({"apply", *tmp / "out", "--jacobian", *tmp / "back.nii", "--like", *tmp / "a.nii", "--inverse"});
  const Volume j = read_volume(*tmp / "j.nii"), log = read_volume(*tmp / "log.nii"),
               back = read_volume(*tmp / "back.nii");
  const Volume from = volume_of(grid, in_reference), to = volume_of(grid, in_template);
  double n_from = 0, n_to = 0, forward = 0, backward = 0;
  for (std::size_t v = 0; v < j.values.size(); ++v) {
    EXPECT_NEAR(log.values[v], std::log(j.values[v]), 1e-5);
    if (from.values[v] > 0) {
      ++n_from;
      forward += j.values[v];
    }
    if (to.values[v] > 0) {
      ++n_to;
      backward += back.values[v];
    }
  }
  EXPECT_NEAR(forward / n_to, 1, 0.03);
  EXPECT_NEAR(backward / n_from, 1, 0.03);
  EXPECT_GT(std::abs(n_to / n_from - 1), 0.1);
}

// Two segmentations of the Medical Segmentation Decathlon: distance in millimetres, and the carried label against the
// other one.
TEST(VolumeData, HippocampusOntoAnother) {
  const std::string folder = (test::data_folder() / "hippocampus_msd").string() + "/";
  const std::string from = folder + "hippocampus_001_label.nii.gz", to = folder + "hippocampus_006_label.nii.gz";
  if (!std::ifstream(from).good()) GTEST_SKIP() << "no file " << from << "; set SHELLMATCH_DATA to the data folder";
  const Folder tmp;
  run({"match", from, to, "-o", tmp / "out", "--set", "pictures=none", "-q"});
  run({"apply", tmp / "out", from, "-o", tmp / "carried.nii.gz", "--like", to});
  const SignedDistance<3> surface(volume_shape({to, {}}, to, Space::ras).surface);
  const std::vector<double> distances = distances_to(deformed(tmp / "out"), surface);
  EXPECT_LT(statistics(distances).mean, 0.05);
  const Volume carried = read_volume(tmp / "carried.nii.gz"), target = read_volume(to);
  double both = 0, sum = 0;
  for (std::size_t v = 0; v < carried.values.size(); ++v) {
    both += carried.values[v] > 0 && target.values[v] > 0;
    sum += (carried.values[v] > 0) + (target.values[v] > 0);
  }
  EXPECT_GT(2 * both / sum, 0.98);
}

TEST_F(Volumes, Refusals) {
  const std::string a = *tmp / "a.nii", out = *tmp / "out", to = *tmp / "new.nii";
  const auto says = [&](const std::vector<std::string>& words, const std::string& text) {
    const ProgramResult result = refused(words);
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
    EXPECT_FALSE(std::ifstream(to).good());
  };
  says({"apply", out}, "say what to move");
  says({"apply", out, "-o", to}, "say what to move");
  says({"apply", out, "--jacobian", to}, "say on which voxels: --like VOLUME");
  says({"apply", out, a + ":1", "-o", to}, "a volume is carried as a whole");
  says({"apply", out, a, "-o", a}, "exists already");
  says({"apply", out, a, "-o", to, "--sampling", "cubic"}, "expected nearest, label or linear");
  says({"apply", out, *tmp / "out/deformed.ply", "-o", *tmp / "new.ply", "--like", a},
       "--like and --sampling are for volumes");
  says({"apply", out, *tmp / "out/deformed.ply", "-o", *tmp / "new.ply", "--jacobian", to}, "without a file to move");
  says({"apply", out, a, "-o", to, "--jacobian", to}, "is named for two results");
  says({"apply", out, "--jacobian", to, "--like", a, "--sampling", "label"}, "for a volume that is carried");
  says({"match", a, "generate:circle", "-o", *tmp / "plane"}, "both shapes must have the same dimension");
  write(*tmp / "far.nii",
        nifti(volume_of(grid_over({500, 0, 0}, {1, 1, 1}, {4, 4, 4}), [](const Vec<3>&) { return 1; })));
  says({"apply", out, a, "-o", to, "--like", *tmp / "far.nii"}, "none of its voxels lies where the map is defined");
  // The second of two results has no place: the first one is not left alone.
  const ProgramResult half = run_program({"apply", out, a, "-o", to, "--jacobian", "/proc/new.nii"});
  EXPECT_NE(half.exit_code, 0);
  EXPECT_NE(half.err.find("/proc/new.nii"), std::string::npos) << half.err;
  EXPECT_FALSE(std::ifstream(to).good());
}

}  // namespace
}  // namespace shellmatch
