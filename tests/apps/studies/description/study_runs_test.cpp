// The product of a study: its runs, their names, and what tells them apart.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "apps/studies/description/study.h"
#include "tests/support/folders.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

const std::string head =
    "version: 1\nproblems: {a: {set: {input: {reference: generate:circle, template: generate:ellipse}}},"
    " b: {set: {input: {reference: generate:star, template: generate:circle}}}}\n";

std::vector<StudyRun> runs(const std::string& text, std::vector<Override> overrides = {}) {
  const fs::path file =
      fs::path(testing::TempDir()) /
      (std::string("shellmatch_runs_") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml");
  std::ofstream(file) << text;
  const auto list = runs_of(read_study(file.string(), std::move(overrides)));
  fs::remove(file);
  return list;
}

TEST(StudyRuns, TheProduct) {
  const auto list = runs(head +
                         "solvers: [newton, lbfgs, ceres_ncg]\nmetrics: [euclidean, l2]\nrepeats: 3\n"
                         "parameters: {energy.delta: [1, 0.5], cascade.max_level: [3, 4]}\n");
  // Newton's method brings its metric: once for each problem, not twice.
  EXPECT_EQ(list.size(), 2u * (1 + 2 + 2) * 2 * 2 * 3);
  std::set<std::string> names, fingerprints;
  for (const StudyRun& run : list) {
    names.insert(run.name);
    fingerprints.insert(run.fingerprint);
  }
  EXPECT_EQ(names.size(), list.size());
  EXPECT_EQ(fingerprints.size(), list.size() / 3);
  EXPECT_EQ(list.front().name, "a-newton-energy.delta=1-cascade.max_level=3-r1");
  EXPECT_EQ(list.back().name, "b-ceres_ncg-l2-energy.delta=0.5-cascade.max_level=4-r3");
}

TEST(StudyRuns, NamesAreFileNames) {
  const auto list =
      runs(head + "solvers: [lbfgs]\nparameters: {input.template: [generate:ellipse, generate:circle]}\n");
  for (const StudyRun& run : list) EXPECT_EQ(run.name.find_first_of("/: \""), std::string::npos) << run.name;
}

TEST(StudyRuns, AParameterMayBeOfOneLevel) {
  const auto list = runs(head + "solvers: [lbfgs]\nparameters: {solver.levels.4.name: [newton, lbfgs]}\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].name, "a-lbfgs-solver.levels.4.name=newton-r1");
  EXPECT_NE(list[0].fingerprint, list[1].fingerprint);
}

// Equal functions, equal keys: only then are energies compared.
TEST(StudyRuns, TheEnergysKeySeesWhatChangesTheEnergyAndNothingElse) {
  const std::string study = head + "solvers: [lbfgs]\n";
  const auto key = [&](const std::string& option, const std::string& value) {
    return runs(study, {{option, value, "--set"}}).front().energy_key;
  };
  const std::string base = runs(study).front().energy_key;
  EXPECT_NE(base, runs(study).back().energy_key);
  for (const auto& [option, value] : {std::pair{"solver.name", "newton"},
                                      {"solver.metric", "euclidean"},
                                      {"solver.stop.max_iterations", "5"},
                                      {"cascade.nu_substeps", "7"},
                                      {"solver.newton.max_forcing", "0.2"},
                                      {"threads", "1"},
                                      {"pictures", "none"}})
    EXPECT_EQ(key(option, value), base) << option;
  for (const auto& [option, value] : {std::pair{"energy.delta", "0.123"},
                                      {"cascade.nu", "0.0123"},
                                      {"cascade.max_level", "5"},
                                      {"cascade.volume", "0.4"},
                                      {"cascade.sigma_cells", "3"},
                                      {"coefficients.tau", "1.5"},
                                      {"energy.quadrature_order", "3"}})
    EXPECT_NE(key(option, value), base) << option;
}

TEST(StudyRuns, TheFingerprintSeesTheContentsOfInputs) {
  const fs::path folder = fs::path(testing::TempDir()) / "shellmatch_fingerprint";
  fs::create_directories(folder / "one");
  fs::create_directories(folder / "two");
  const auto fingerprint = [&](const std::string& place, const std::string& shape) {
    std::ofstream(folder / place / "shape.csv") << shape;
    std::ofstream(folder / place / "study.yaml")
        << "version: 1\nproblems: {a: {set: {input: {reference: shape.csv, template: "
           "generate:circle}}}}\nsolvers: [lbfgs]\n";
    return runs_of(read_study((folder / place / "study.yaml").string())).front().fingerprint;
  };
  const std::string first = fingerprint("one", "0,0\n1,0\n0,1\n");
  EXPECT_EQ(fingerprint("one", "0,0\n1,0\n0,1\n"), first);
  EXPECT_EQ(fingerprint("two", "0,0\n1,0\n0,1\n"), first);  // wherever it lies
  EXPECT_NE(fingerprint("one", "0,0\n1,0\n0,2\n"), first);
  fs::remove_all(folder);
}

// What the program ships can be read.
TEST(StudyRuns, ShippedStudiesAreGood) {
  int n = 0;
  for (const auto& entry : fs::directory_iterator(test::source_folder() / "configs/studies")) {
    EXPECT_FALSE(runs_of(read_study(entry.path().string())).empty()) << entry.path();
    ++n;
  }
  EXPECT_GE(n, 2);
}

}  // namespace
}  // namespace shellmatch
