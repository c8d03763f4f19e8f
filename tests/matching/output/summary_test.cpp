#include "matching/output/summary.h"
#include "base/error.h"
#include "matching/progress/process_info.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

MatchSummary some_summary() {
  MatchSummary s;
  s.version = "1.2.3";
  s.profile = "paper";
  s.dimension = 3;
  s.reference = {"a.ply", 100, 196, {"2 duplicate vertices welded", "\"quoted\"\n"}};
  s.template_shape = {"b.obj", 200, 396, {}};
  s.placement = {"fit", 1 / 3.0, {0.1, 0.2, 1e-17}};
  s.distance = TwoSidedDistance{{1e-4 / 3, 2e-4, 3e-4}, {4e-4, 5e-4, 6e-4}};
  s.area_distortion = DistortionSummary{1.01, 0.7, 1.6};
  s.n_flipped_facets = 0;
  LevelSummary level;
  level.level = 5;
  level.nu = 0.1 + 0.2;
  level.n_nodes = 12345;
  level.energy_minimised = {{"volume", 2}, {"match", 1.0 / 7}};
  level.energy_reported = {{"match", std::numeric_limits<double>::infinity()}};
  level.folds.min_determinant = std::nan("");
  level.band = {7.5, 0.25};
  level.stop_reason = "relative_decrease";
  s.levels = {level, level};
  s.levels[1].distance = s.distance;
  s.run = {"gcc 12", 2, 12.5, {{"reading", 0.5}, {"level", 12}}, {1.5, 11}, std::uint64_t{1} << 40, {}};
  s.run.level_memory_estimates = {1.5e6, 3e6};
  return s;
}

TEST(SummaryTest, ParsesBackToTheSameText) {
  const TemporaryFolder tmp;
  const MatchSummary s = some_summary();
  write_summary(s, tmp / "summary.json");
  const MatchSummary back = read_summary(tmp / "summary.json");
  EXPECT_EQ(summary_json(back), summary_json(s));
  EXPECT_EQ(back.placement.scale, s.placement.scale);
  EXPECT_EQ(back.levels[0].nu, s.levels[0].nu);
  EXPECT_EQ(back.distance->deformed_to_template.mean, s.distance->deformed_to_template.mean);
  EXPECT_FALSE(back.distance_before);
  EXPECT_FALSE(back.levels[0].distance);
  EXPECT_TRUE(back.levels[1].distance);
  EXPECT_EQ(back.n_flipped_facets, 0u);
  EXPECT_EQ(back.levels[0].energy_minimised, s.levels[0].energy_minimised);  // in their order
  EXPECT_TRUE(std::isnan(back.levels[0].folds.min_determinant));
  EXPECT_EQ(back.levels[0].band.normal_angle, 7.5);
  EXPECT_EQ(back.levels[0].band.folded_share, 0.25);
  EXPECT_TRUE(std::isnan(back.levels[0].energy_reported[0].second));
  EXPECT_EQ(back.run.peak_memory_bytes, s.run.peak_memory_bytes);
  EXPECT_EQ(back.reference.notes, s.reference.notes);
  EXPECT_FALSE(back.run.resumed_after);
  EXPECT_EQ(back.run.level_memory_estimates, s.run.level_memory_estimates);
  EXPECT_FALSE(back.run.level_memory_peaks);
}

TEST(SummaryTest, WhatDiffersBetweenRunsIsUnderOneKeyAtTheEnd) {
  const MatchSummary a = some_summary();
  MatchSummary b = a;
  b.run = {"clang 15", 1, 99, {{"reading", 7}}, {3, 4}, 5, std::vector<int>{3, 6}};
  const std::string ja = summary_json(a), jb = summary_json(b);
  EXPECT_NE(ja, jb);
  const std::size_t run = ja.find("\n  \"run\": {");
  ASSERT_NE(run, std::string::npos);
  EXPECT_EQ(ja.substr(0, run), jb.substr(0, run));
  EXPECT_EQ(ja.substr(0, run).find("second"), std::string::npos);
  EXPECT_EQ(ja.find("\n  \"", run + 3), std::string::npos);  // nothing follows it
}

TEST(SummaryTest, NumbersAreShortAndNotFiniteOnesAreNull) {
  const std::string json = summary_json(some_summary());
  EXPECT_NE(json.find("\"nu\": 0.30000000000000004"), std::string::npos);
  EXPECT_NE(json.find("\"p95\": 0.0002"), std::string::npos);
  EXPECT_NE(json.find("\"min_determinant\": null"), std::string::npos);
  EXPECT_NE(json.find("\"match\": null"), std::string::npos);
}

TEST(SummaryTest, NamesThatAreNoUtf8AreWritten) {
  MatchSummary s = some_summary();
  s.reference.file = "hand\xff.ply";
  EXPECT_NE(summary_json(s).find("hand"), std::string::npos);
}

std::string replaced(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

// The library would cast them: to any number at all, or to another one.
TEST(SummaryTest, NumbersThatNoIntegerHasAreRefused) {
  const TemporaryFolder tmp;
  const std::string good = summary_json(some_summary());
  for (const char* bad : {"1e300", "-1e300", "3.5", "4294967299", "-4294967299", "\"3\"", "null", "true", "[3]"}) {
    put(tmp / "s.json", replaced(good, "\"dimension\": 3", std::string("\"dimension\": ") + bad));
    EXPECT_THROW(read_summary(tmp / "s.json"), InputError) << bad;
  }
  put(tmp / "s.json", replaced(good, "\"vertices\": 100", "\"vertices\": -1"));
  EXPECT_THROW(read_summary(tmp / "s.json"), InputError);
}

TEST(SummaryTest, AListIsAList) {
  const TemporaryFolder tmp;
  for (const char* bad : {"\"a\"", "null", "{\"a\": \"b\"}"}) {
    put(tmp / "s.json", replaced(summary_json(some_summary()), "\"notes\": []", std::string("\"notes\": ") + bad));
    EXPECT_THROW(read_summary(tmp / "s.json"), InputError) << bad;
  }
}

// Each key is looked for among those before it: 300,000 of them took minutes.
TEST(SummaryTest, ObjectsOfVeryManyKeysAreRefusedAtOnce) {
  const TemporaryFolder tmp;
  std::string text = "{\"a\": [{}, {\"b\": {}}]";
  for (int i = 0; i < 300000; ++i) text += ", \"k" + std::to_string(i) + "\": 0";
  put(tmp / "s.json", text + "}");
  try {
    read_summary(tmp / "s.json");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("too many keys"), std::string::npos) << error.what();
  }
}

TEST(SummaryTest, DamageIsAnInputError) {
  const TemporaryFolder tmp;
  const std::string good = summary_json(some_summary());
  for (const std::string& bad :
       {std::string(), good.substr(0, good.size() / 2), std::string("{}"), std::string("[1]")}) {
    put(tmp / "s.json", bad);
    EXPECT_THROW(read_summary(tmp / "s.json"), InputError);
  }
  EXPECT_THROW(read_summary(tmp / "not_there.json"), InputError);
}

TEST(ProcessInfoTest, PeakMemoryGrowsWithWhatIsTaken) {
  const std::uint64_t before = peak_memory_bytes();
  EXPECT_GT(before, 1u << 20);
  std::vector<char> block(before + (std::size_t{64} << 20), 1);
  EXPECT_GT(peak_memory_bytes() + block[7] - 1, before + (std::uint64_t{32} << 20));
  EXPECT_GT(available_memory_bytes(), 0u);
  EXPECT_EQ(free_disk_bytes("/no/such/folder") > 0, free_disk_bytes("/") > 0);
  EXPECT_FALSE(compiler_name().empty());
}

}  // namespace
}  // namespace shellmatch
