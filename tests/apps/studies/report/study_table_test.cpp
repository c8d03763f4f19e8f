// Rows, comparison groups and columns, from results written by hand.

#include "apps/studies/report/study_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "apps/studies/report/study_csv.h"
#include "apps/studies/report/study_plots.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

// Two solvers, two values of a parameter that changes the energy and two of one that does not.
class StudyTableTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("shellmatch_table_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "study.yaml")
        << "version: 1\nproblems: {a: {set: {input: {reference: generate:circle, template: "
           "generate:ellipse}, cascade: {min_level: 3, max_level: 3}}}}\n"
           "solvers: {s: {name: lbfgs}, t: {name: newton}}\nparameters: {energy.delta: [1, 0.5], "
           "cascade.nu_substeps: [1, 2]}\n";
    study_ = read_study((folder_ / "study.yaml").string());
    runs_ = runs_of(study_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void add_result(const RunsFolder& out, const StudyRun& run, double energy) const {
    const fs::path place = out.run_folder(run);
    fs::create_directories(place / "output");
    RunResult result;
    result.status = RunStatus::finished;
    result.fingerprint = run.fingerprint;
    result.message = "with, comma and \"quotes\"";
    write_run_result(result, (place / "result.json").string());
    MatchSummary summary;
    LevelSummary level;
    level.level = 3;
    level.energy_minimised = level.energy_reported = {{"match", energy}, {"total", energy}};
    summary.levels = {level};
    summary.run.level_seconds = {1};
    write_summary(summary, (place / "output/summary.json").string());
    write_history({{"match"},
                   {{3, 1, 1.0, {0, 2 * energy, {2 * energy}, 0, 0, 0, 1, 1, 0.5, ""}},
                    {3, 1, 1.0, {1, energy, {energy}, 0, 0, 0, 2, 2, 1, ""}}}},
                  (place / "output/history.csv").string());
  }

  fs::path folder_;
  Study study_;
  std::vector<StudyRun> runs_;
};

TEST_F(StudyTableTest, OnlyEqualFunctionsAreCompared) {
  const RunsFolder out((folder_ / "out").string(), study_folder_kind, true);
  ASSERT_EQ(runs_.size(), 8u);
  double energy = 1;
  for (const StudyRun& run : runs_) add_result(out, run, energy *= 1.05);
  const StudyTable table = make_study_table(study_, runs_, out);
  EXPECT_EQ(instances_of(table), (std::vector<std::string>{"a energy.delta=1", "a energy.delta=0.5"}));
  EXPECT_EQ(methods_of(table), (std::vector<std::string>{"s (l2) cascade.nu_substeps=1", "s (l2) cascade.nu_substeps=2",
                                                         "t cascade.nu_substeps=1", "t cascade.nu_substeps=2"}));
  // The first of each delta is the best: runs 0 and 2.
  for (const StudyRow& row : table.rows)
    EXPECT_DOUBLE_EQ(row.best, row.run.options.energy.delta == 1 ? 1.05 : std::pow(1.05, 3)) << row.run.name;
  EXPECT_EQ(table.rows[1].to_gap[0]->evaluations, 2);
  EXPECT_FALSE(table.rows[1].to_gap[1]);  // 5 % above
  EXPECT_EQ(table.rows[0].to_gap[2]->evaluations, 2);
}

TEST_F(StudyTableTest, AResultOfAnotherConfigurationIsNone) {
  const RunsFolder out((folder_ / "out").string(), study_folder_kind, true);
  add_result(out, runs_[0], 1);
  EXPECT_EQ(out.result_of(runs_[0]).status, RunStatus::finished);
  StudyRun changed = runs_[0];
  changed.fingerprint = "another";
  EXPECT_EQ(out.result_of(changed).status, RunStatus::not_run);
  std::ofstream(out.run_folder(runs_[0]) + "/result.json") << "{\"status\": \"fin";  // cut off
  EXPECT_EQ(out.result_of(runs_[0]).status, RunStatus::not_run);
}

// The number of commas outside of quotes on each line.
std::vector<std::ptrdiff_t> commas_of(const std::string& csv) {
  std::vector<std::ptrdiff_t> commas;
  std::size_t at = 0;
  for (std::size_t end; (end = csv.find('\n', at)) != std::string::npos; at = end + 1) {
    bool inside = false;
    commas.push_back(0);
    for (const char c : csv.substr(at, end - at)) {
      inside ^= c == '"';
      commas.back() += c == ',' && !inside;
    }
  }
  return commas;
}

TEST_F(StudyTableTest, EveryLineHasEveryColumn) {
  const RunsFolder out((folder_ / "out").string(), study_folder_kind, true);
  add_result(out, runs_[0], 1);
  const std::string csv = study_csv(make_study_table(study_, runs_, out));
  EXPECT_NE(csv.find("\"with, comma and \"\"quotes\"\"\""), std::string::npos) << csv;
  const std::vector<std::ptrdiff_t> commas = commas_of(csv);
  EXPECT_EQ(commas, std::vector<std::ptrdiff_t>(9, commas.front()));
}

TEST_F(StudyTableTest, NamesWithCommasStayInTheirColumn) {
  std::ofstream(folder_ / "lists.yaml")
      << "version: 1\nproblems: {a: {set: {input: {reference: generate:circle, template: generate:ellipse}, cascade: "
         "{min_level: 3, max_level: 3}}}}\n"
         "solvers: [newton]\nparameters: {solver.fallback: [[lbfgs], [lbfgs, nlopt_lbfgs]]}\n";
  const Study study = read_study((folder_ / "lists.yaml").string());
  const std::vector<StudyRun> runs = runs_of(study);
  ASSERT_NE(runs[1].name.find(','), std::string::npos) << runs[1].name;
  const RunsFolder out((folder_ / "out").string(), study_folder_kind, true);
  for (const StudyRun& run : runs) add_result(out, run, 1);
  const StudyTable table = make_study_table(study, runs, out);
  for (const std::string& csv : {study_csv(table), convergence_csv(table)}) {
    const std::vector<std::ptrdiff_t> commas = commas_of(csv);
    EXPECT_EQ(commas, std::vector<std::ptrdiff_t>(commas.size(), commas.front())) << csv;
  }
}

TEST_F(StudyTableTest, OnlyOneWorksOnTheWholeOfAFolder) {
  const auto one = std::make_unique<RunsFolder>((folder_ / "out").string(), study_folder_kind, true);
  EXPECT_THROW(RunsFolder((folder_ / "out").string(), study_folder_kind, true), std::runtime_error);
  EXPECT_THROW(RunsFolder((folder_ / "out").string(), study_folder_kind, false), std::runtime_error);
}

TEST_F(StudyTableTest, SeveralWorkOnSingleRuns) {
  const RunsFolder one((folder_ / "out").string(), study_folder_kind, false);
  EXPECT_NO_THROW(RunsFolder((folder_ / "out").string(), study_folder_kind, false));
  EXPECT_THROW(RunsFolder((folder_ / "out").string(), study_folder_kind, true), std::runtime_error);
}

TEST(Median, OfRepeats) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1}), 2.5);
  EXPECT_EQ(median({infinity, 1, infinity}), infinity);
  EXPECT_EQ(median({1, infinity}), infinity);
}

}  // namespace
}  // namespace shellmatch
