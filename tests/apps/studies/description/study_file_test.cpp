// A study's file: what it may say, and what is said of mistakes.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "apps/studies/description/study.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

class StudyFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("shellmatch_studyfile_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& text) const {
    std::ofstream(folder_ / "study.yaml") << text;
    return (folder_ / "study.yaml").string();
  }

  // The message of the InputError that reading and expanding `text` ends with; "" if there is none.
  std::string refusal(const std::string& text) const {
    try {
      runs_of(read_study(write(text)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  void expect_refused(const std::string& text, std::initializer_list<const char*> parts) const {
    const std::string message = refusal(text);
    EXPECT_NE(message.find("study.yaml"), std::string::npos) << message;
    for (const char* part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in: " << message;
  }

  fs::path folder_;
};

const std::string pair = "problems: {a: {set: {input: {reference: generate:circle, template: generate:ellipse}}}}\n";
const std::string good = "version: 1\n" + pair + "solvers: [newton]\n";

TEST_F(StudyFile, TheLeastThatRuns) {
  const auto runs = runs_of(read_study(write(good)));
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].name, "a-newton-r1");
  EXPECT_EQ(runs[0].options.solver.name, "newton");
}

TEST_F(StudyFile, LaterWins) {
  std::ofstream(folder_ / "base.yaml")
      << "input: {reference: shape.csv, template: generate:ellipse}\n"
         "energy: {delta: 1}\ncascade: {min_level: 2, max_level: 3, nu: 1}\nsolver: {metric: l2}\n";
  std::ofstream(folder_ / "shape.csv") << "0,0\n1,0\n0,1\n";
  const std::string text =
      "version: 1\nset: {energy: {delta: 2}, cascade.nu: 0.5}\nproblems: {a: {base: base.yaml, set: "
      "{cascade: {nu: 0.25}}}}\n"
      "solvers: {x: {name: lbfgs, metric: l2, stop: {max_iterations: 7}}}\nmetrics: [euclidean]\n"
      "parameters: {cascade.nu_substeps: [1, 4]}\n";
  const auto runs = runs_of(read_study(write(text), {{"cascade.volume", "0.125", "--set"}, {"repeats", "2", "--set"}}));
  ASSERT_EQ(runs.size(), 4u);
  const ExperimentOptions& o = runs[2].options;
  EXPECT_EQ(o.energy.delta, 2);                   // set over base
  EXPECT_EQ(o.cascade.nu, 0.25);                  // problem over set
  EXPECT_EQ(o.solver.metric, Metric::euclidean);  // metrics over solver
  EXPECT_EQ(o.solver.stop.max_iterations, 7);
  EXPECT_EQ(o.cascade.nu_substeps, 4);
  EXPECT_EQ(o.cascade.volume, 0.125);
  EXPECT_EQ(fs::path(o.input.reference), folder_ / "shape.csv");  // relative to the file that names it
}

TEST_F(StudyFile, PathsOfTheStudyAreRelativeToIt) {
  std::ofstream(folder_ / "shape.csv") << "0,0\n1,0\n0,1\n";
  const auto runs =
      runs_of(read_study(write("version: 1\nproblems: {a: {set: {input: {reference: shape.csv, template: "
                               "generate:circle}}}}\nsolvers: [lbfgs]\n")));
  EXPECT_EQ(fs::path(runs.at(0).options.input.reference), folder_ / "shape.csv");
  EXPECT_EQ(runs.at(0).options.input.template_file, "generate:circle");
}

TEST_F(StudyFile, MistakesOfTheFrame) {
  expect_refused("version: 2\nproblms: 1\n", {":1:", "version", "version 1"});
  expect_refused(pair + "solvers: [newton]\n", {"version is missing"});
  expect_refused("version: 1\nsolvers: [newton]\n", {"no problem", "nothing to run"});
  expect_refused("version: 1\nproblems: {}\nsolvers: [newton]\n", {":2:", "nothing to run"});
  expect_refused("version: 1\n" + pair, {"solvers", "nothing to run", "fletcher_reeves"});
  expect_refused("version: 1\n" + pair + "solvers: []\n", {"solvers", "nothing to run"});
  expect_refused(good + "metric: [l2]\n", {":4:", "unknown key \"metric\"", "did you mean metrics?"});
  expect_refused(good + "limits: {second: 3}\n", {":4:", "did you mean limits.seconds?"});
  expect_refused(good + "limits: {seconds: -1}\n", {"limits.seconds", "x >= 0"});
  expect_refused(good + "repeats: 0\n", {"repeats", "1 <= x <= 1000"});
  expect_refused(good + "repeats: 1\nrepeats: 2\n", {":5:", "repeats", "line 4"});
  expect_refused(good + "set: &a {energy: *a}\n", {"unfolds to too many values"});
}

TEST_F(StudyFile, MistakesWithin) {
  expect_refused(good + "set: {energy: {detla: 1}}\n", {":4: set", "energy.delta"});
  expect_refused(good + "set: {energy: {delta: }}\n", {":4: set", "energy.delta", "no value"});
  expect_refused(good + "set: {energy: {delta: \"1\"}}\n", {":4: set", "energy.delta"});
  expect_refused(good + "parameters: {energy.detla: [1]}\n", {"parameters.energy.detla", "energy.delta"});
  expect_refused(good + "parameters: {energy.delta: 1}\n", {"parameters.energy.delta", "list"});
  expect_refused(good + "parameters: {energy.delta: []}\n", {"parameters.energy.delta", "empty list"});
  expect_refused("version: 1\n" + pair + "solvers: [newtn]\n",
                 {":3: solvers", "newton", "fletcher_reeves", "nlopt_ccsaq"});
  expect_refused("version: 1\n" + pair + "solvers: [lbfgs]\nmetrics: [l3]\n", {":4: metrics", "euclidean", "l2"});
  expect_refused("version: 1\n" + pair + "solvers: {x: {name: lbfgs, metrc: l2}}\n",
                 {":3: solvers.x", "did you mean solver.metric?"});
  expect_refused("version: 1\n" + pair + "solvers: {bad-name: {name: lbfgs}}\n", {":3: solvers", "bad-name"});
  expect_refused("version: 1\nproblems: {a: {bse: x.yaml}}\nsolvers: [newton]\n",
                 {":2: problems.a", "bse", "base, set"});
  expect_refused("version: 1\nproblems: {a: {base: gone.yaml}}\nsolvers: [newton]\n",
                 {":2: problems.a.base", "gone.yaml", "no such file"});
  expect_refused("version: 1\nproblems: {a: {base: " + std::string(5000, 'b') + "}}\nsolvers: [newton]\n",
                 {":2: problems.a.base", "no such file"});
  expect_refused("version: 1\nproblems: {a: {set: {energy: {delta: 1}}}}\nsolvers: [newton]\n",
                 {"problems.a", "input.reference"});
  expect_refused(
      "version: 1\nproblems: {a: {set: {input: {reference: generate:hnd, template: "
      "generate:hand}}}}\nsolvers: [newton]\n",
      {"problems.a", "hand"});
  expect_refused(
      "version: 1\nproblems: {a: {set: {input: {reference: gone.ply, template: generate:hand}}}}\nsolvers: "
      "[newton]\n",
      {"problems.a", "gone.ply"});
}

TEST_F(StudyFile, TwoRunsOfOneNameAreRefused) {
  expect_refused("version: 1\n" + pair + "solvers: [lbfgs, lbfgs]\n", {"two runs are called a-lbfgs-r1"});
  expect_refused(good + "parameters: {energy.delta: [0.5, 5e-1]}\n",
                 {"two runs are called a-newton-energy.delta=0.5-r1"});
  expect_refused("version: 1\n" + pair + "solvers: [lbfgs]\nmetrics: [l2, l2]\n",
                 {"two runs are called a-lbfgs-l2-r1"});
}

}  // namespace
}  // namespace shellmatch
