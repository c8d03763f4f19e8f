// Runs that begin with the map of an earlier one.

#include "base/error.h"
#include "energies/terms/term_names.h"
#include "matching/experiment/yaml_options.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/summary.h"
#include "matching/run_matching.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

struct StartMap : ::testing::Test {
  struct Listener final : Observer {
    std::vector<std::string> lines;
    void note(const std::string& text) override { lines.push_back(text); }
    void warn(const std::string& text) override { lines.push_back(text); }
    bool has(const std::string& part) const {
      return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(part) != std::string::npos; });
    }
  };

  fs::path folder = fs::temp_directory_path() / ("shellmatch_start_map_" + std::to_string(::getpid()));
  Listener listener;
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  static ExperimentOptions options(const std::string& reference, const std::string& target, int max_level) {
    ExperimentOptions o = profile_defaults(Profile::standard);
    o.input.reference = reference;
    o.input.template_file = target;
    o.cascade.max_level = max_level;
    o.pictures = Pictures::none;
    o.report = false;
    return o;
  }
  MatchSummary run(const ExperimentOptions& o, const std::string& name) {
    listener.lines.clear();
    run_matching(o, folder / name, {}, listener);
    return read_summary(folder / name / "summary.json");
  }
};

TEST_F(StartMap, TheLevelsBeforeAreLeftOutAndTheResultIsAsGood) {
  run(options("generate:leaf/deep", "generate:leaf/shallow", 6), "coarse");
  ExperimentOptions o = options("generate:leaf/deep", "generate:leaf/shallow", 7);
  const MatchSummary whole = run(o, "whole");
  o.start.map = folder / "coarse";
  const MatchSummary begun = run(o, "begun");
  EXPECT_TRUE(listener.has("begins at level 7 with the map of")) << listener.lines.size();
  ASSERT_EQ(begun.levels.size(), 1u);
  EXPECT_EQ(begun.levels[0].level, 7);
  EXPECT_EQ(begun.levels[0].n_nodes, whole.levels.back().n_nodes) << "the grid is that of the shapes, not of the map";
  const auto energy = [](const MatchSummary& s) { return s.levels.back().energy_minimised.back().second; };
  EXPECT_NEAR(energy(begun), energy(whole), 0.01 * energy(whole));
  EXPECT_TRUE(std::ranges::any_of(begun.levels[0].energy_minimised, [](const auto& term) {
    return term.first == "coverage" && term.second > 0;
  })) << "the finest level is two-sided";
  EXPECT_LT(begun.distance->deformed_to_template.mean, 1.1 * whole.distance->deformed_to_template.mean);
  EXPECT_EQ(begun.levels.back().folds.n_uncertified_cells, 0);
  // The pose that alignment has found is taken over, and no other one is sought.
  EXPECT_EQ(read_deformation<2>(folder / "begun").pose.rotation, read_deformation<2>(folder / "coarse").pose.rotation);
}

TEST_F(StartMap, TheFinestLevelMayBeMinimisedAgain) {
  const MatchSummary first = run(options("generate:circle", "generate:ellipse/long", 5), "first");
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 5);
  o.start.map = folder / "first";
  const MatchSummary again = run(o, "again");
  ASSERT_EQ(again.levels.size(), 1u);
  EXPECT_EQ(again.levels[0].level, 5);
  o.start.level = 3;
  EXPECT_EQ(run(o, "from_three").levels.size(), 3u);
}

TEST_F(StartMap, InSpaceAndBackward) {
  ExperimentOptions o = options("generate:sphere", "generate:ellipsoid/long", 4);
  o.align.mode = AlignMode::none;
  o.align.direction = MatchDirection::backward;
  run(o, "coarse");
  o.cascade.max_level = 5;
  o.start.map = folder / "coarse";
  const MatchSummary s = run(o, "fine");
  ASSERT_EQ(s.levels.size(), 1u);
  ASSERT_TRUE(s.direction);
  EXPECT_TRUE(s.direction->backward);
  EXPECT_LT(s.distance->deformed_to_template.mean, 2e-3);
}

TEST_F(StartMap, FromASurfaceThatIsBentFirst) {
  ExperimentOptions o = options("generate:sphere", "generate:ellipsoid/long", 4);
  const MatchSummary plain = run(o, "coarse");
  EXPECT_FALSE(plain.bent);
  Deformation<3> map = read_deformation<3>(folder / "coarse");
  Surface<3> sphere = std::get<ShapePair<3>>(open_shape_pair(o.input, {}, listener)).reference.surface;
  map.bend = std::make_shared<const SurfaceBend<3>>(sphere, sphere.vertices);
  write_deformation(folder / "bent.vtu", map);
  o.start.map = folder / "bent.vtu";
  const MatchSummary begun = run(o, "begun");
  EXPECT_TRUE(listener.has("begins at level 4 with the map of")) << listener.lines.size();
  EXPECT_TRUE(listener.has("from the surface that it bends first")) << listener.lines.size();
  EXPECT_TRUE(begun.bent);
  ASSERT_TRUE(read_deformation<3>(folder / "begun").bend);
  EXPECT_NEAR(begun.distance->deformed_to_template.mean, plain.distance->deformed_to_template.mean, 1e-3);
  const double diagonal = bounding_box(sphere.vertices).diagonal();
  for (Vec<3>& x : sphere.vertices) x.z() += 0.01 * diagonal;
  map.bend = std::make_shared<const SurfaceBend<3>>(sphere, sphere.vertices);
  write_deformation(folder / "other.vtu", map);
  o.start.map = folder / "other.vtu";
  EXPECT_FALSE(run(o, "anew").bent);
  EXPECT_TRUE(listener.has("do not lie where those of that run do")) << "another surface was bent";
  o.start.map = folder / "bent.vtu";
  o.align.bend = BendMode::never;
  expect_input_error([&] { run(o, "never"); }, {"start.map", "bent.vtu", "align.bend: never"});
  o.align.direction = MatchDirection::backward;
  expect_input_error([&] { run(o, "never"); }, {"start.map", "bent.vtu", "align.direction: backward"});
}

TEST_F(StartMap, ShapesThatLieElsewhereBeginAnew) {
  run(options("generate:circle/small", "generate:circle/small", 4), "small");
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 4);
  o.start.map = folder / "small";
  const MatchSummary s = run(o, "out");
  EXPECT_TRUE(listener.has("do not lie where those of that run do"))
      << "the unit domain of the small ones does not hold these";
  EXPECT_EQ(s.levels.size(), 2u);
}

TEST_F(StartMap, Mistakes) {
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 4);
  o.start.map = folder / "nowhere";
  expect_input_error([&] { run(o, "out"); }, {"nowhere"});
  EXPECT_FALSE(fs::exists(folder / "out"));
  o.start.level = 9;
  expect_input_error([&] { check_experiment(o); }, {"start.level", "9 is not from"});
  o.start.map.clear();
  o.start.level = 3;
  expect_input_error([&] { check_experiment(o); }, {"start.level", "start.map names none"});
}

TEST_F(StartMap, WhatContradictsTheMapIsRefused) {
  run(options("generate:circle", "generate:ellipse/long", 4), "first");
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 4);
  o.start.map = folder / "first";
  o.align.direction = MatchDirection::backward;
  expect_input_error([&] { run(o, "out"); }, {"start.map", "first", "leave out align.direction"});
  o.align.direction = MatchDirection::forward;
  o.input.placement = PlacementKind::as_is;
  expect_input_error([&] { run(o, "out"); }, {"start.map", "first", "leave out input.placement"});
}

TEST_F(StartMap, AnEnergyThatIsNotFiniteIsRefusedAsInAnyRun) {
  run(options("generate:circle", "generate:ellipse/long", 4), "first");
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 5);
  o.start.map = folder / "first";
  o.energy.terms.factor("membrane"_term) = 1e308;
  o.energy.delta = 100;
  expect_input_error([&] { run(o, "second"); }, {"level 5", "the energy cannot be evaluated", "membrane"});
  EXPECT_FALSE(fs::exists(folder / "second"));
}

}  // namespace
}  // namespace shellmatch
