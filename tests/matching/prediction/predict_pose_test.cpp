// Poses predicted from images of a reference on other shapes, and runs that begin with them.

#include "matching/prediction/predict_pose.h"

#include "geometry/generate/round.h"
#include "geometry/io/write_shape.h"
#include "matching/alignment/choose_pose.h"
#include "matching/experiment/yaml_options.h"
#include "matching/output/summary.h"
#include "matching/run_matching.h"
#include "tests/geometry/surface/test_surfaces.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

/// No motion carries it onto itself.
Surface<3> blob() {
  Surface<3> surface = geodesic_sphere(12);
  const Vec<3> top = Vec<3>(1, 0.7, 0.4).normalized();
  for (Vec<3>& x : surface.vertices)
    x = Vec<3>(1.3, 1.1, 0.9).cwiseProduct((1 + 0.25 * std::exp(-4 * (x - top).squaredNorm())) * x);
  return surface;
}

Surface<3> stretched(const Vec<3>& factors) {
  return test::mapped<3>(blob(), [&](const Vec<3>& x) { return Vec<3>(factors.cwiseProduct(x)); });
}

const Vec<3> offset(5, -3, 2);
const Mat<3> turn = Eigen::AngleAxisd(2.2, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();

Surface<3> moved(const Surface<3>& surface) {
  return test::mapped<3>(surface, [](const Vec<3>& x) { return Vec<3>(turn * x + offset); });
}

double greatest_error(const PredictedPose& found, const Surface<3>& reference, const Surface<3>& truth) {
  double greatest = 0;
  for (const CorrespondingPoints& pair : found.pairs) {
    const auto v = std::ranges::find(reference.vertices, pair.on_reference) - reference.vertices.begin();
    greatest = std::max(greatest, (truth.vertices[static_cast<std::size_t>(v)] - pair.on_template).norm());
  }
  return greatest / bounding_box(truth.vertices).diagonal();
}

TEST(PredictPose, DifferencesOfTheImagesBringTheMeanOntoWhatTheyCombineTo) {
  const Surface<3> reference = blob(), target = moved(stretched({1.2, 1, 0.85}));
  const std::vector<std::vector<Vec<3>>> images{stretched({1.3, 1, 1}).vertices, stretched({1, 1, 1}).vertices,
                                                moved(stretched({1, 1, 0.75})).vertices};
  const PredictedPose found = predict_pose(reference, images, target, {});
  EXPECT_LT(found.residual, 0.004);
  EXPECT_LT(found.farthest, 0.02);
  EXPECT_GT(found.margin, 1.5);
  ASSERT_GT(found.pairs.size(), 500u);
  EXPECT_LT(greatest_error(found, reference, target), 0.04);
  const PredictedPose of_one = predict_pose(reference, {images[1]}, target, {});
  EXPECT_GT(of_one.residual, 2 * found.residual) << "one image has no differences";
}

TEST(PredictPose, WhatNoImageKnowsTakesNoPart) {
  const Surface<3> reference = blob();
  std::vector<std::vector<Vec<3>>> images{reference.vertices};
  for (std::size_t v = 0; v < reference.vertices.size(); ++v)
    if (reference.vertices[v].z() > 0.6) images[0][v].setConstant(std::numeric_limits<double>::quiet_NaN());
  const PredictedPose found = predict_pose(reference, images, moved(reference), {});
  ASSERT_GT(found.pairs.size(), 100u);
  for (const CorrespondingPoints& pair : found.pairs) EXPECT_LE(pair.on_reference.z(), 0.6);
  for (Vec<3>& x : images[0]) x.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(predict_pose(reference, images, reference, {}).pairs.empty());
}

struct PredictedRun : testing::Test {
  fs::path folder = fs::temp_directory_path() / ("shellmatch_prediction_" + std::to_string(::getpid()));
  void SetUp() override {
    fs::create_directories(folder);
    write("reference.ply", blob());
    write("first.ply", stretched({1.15, 1, 1}));
    write("second.ply", moved(stretched({1.1, 1, 0.95})));
  }
  void TearDown() override { fs::remove_all(folder); }

  void write(const std::string& name, const Surface<3>& surface) const {
    OriginalShape<3> shape{surface.vertices, {}, {}};
    for (const auto& facet : surface.facets) shape.polygons.emplace_back(facet.begin(), facet.end());
    write_ply((folder / name).string(), shape);
  }
  MatchSummary run(const std::string& target, const std::vector<std::string>& images, const std::string& name) const {
    ExperimentOptions o = profile_defaults(Profile::standard);
    o.input.reference = folder / "reference.ply";
    o.input.template_file = folder / target;
    o.cascade.max_level = 3;
    o.align.search.functions = 40;
    o.align.search.refined = 1;
    o.pictures = Pictures::none;
    o.report = false;
    for (const std::string& image : images) o.start.images.push_back(folder / image);
    Observer nobody;
    run_matching(o, folder / name, {}, nobody);
    return read_summary(folder / name / "summary.json");
  }
};

TEST_F(PredictedRun, BeginsWithThePoseInPlaceOfASearch) {
  EXPECT_FALSE(run("first.ply", {}, "a").alignment->n_images);
  const MatchSummary begun = run("second.ply", {"a"}, "b");
  EXPECT_EQ(begun.alignment->n_images, 1);
  EXPECT_FALSE(begun.alignment->score) << "nothing was searched";
  EXPECT_NEAR(begun.alignment->angle, angle_in_degrees<3>(turn), 5);
  EXPECT_LT(begun.distance->template_to_deformed.mean, 0.005);
}

TEST_F(PredictedRun, SearchesWhereTheImagesDoNotTell) {
  run("first.ply", {}, "a");
  Surface<3> limb = stretched({1.1, 1, 0.95});
  for (Vec<3>& x : limb.vertices)
    if (x.x() < -1.1) x.x() *= 1.9;
  write("limb.ply", limb);
  EXPECT_FALSE(run("limb.ply", {"a"}, "b").alignment->n_images);
  write("ball.ply", geodesic_sphere(12));
  EXPECT_FALSE(run("ball.ply", {"a"}, "c").alignment->n_images) << "any pose is as good";
}

TEST_F(PredictedRun, RefusesResultsOfOtherReferences) {
  write("other.ply", geodesic_sphere(8));
  fs::create_directories(folder / "other");
  fs::copy(folder / "other.ply", folder / "other/deformed.ply");
  expect_input_error([&] { run("first.ply", {"other"}, "a"); }, {"start.images", "other", "vertices"});
  expect_input_error([&] { run("first.ply", {"nowhere"}, "a"); }, {"start.images", "nowhere"});
}

}  // namespace
}  // namespace shellmatch
