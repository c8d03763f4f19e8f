// The program as a user meets it: help, exit codes and one clear message for every mistake.

#include "matching/experiment/option_tree.h"
#include "matching/experiment/options.h"
#include "tests/apps/cli_harness.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

std::string joined(const Words& words) {
  std::string text = "shellmatch";
  for (const std::string& word : words) text += fmt::format(" {}", word.substr(0, 80));
  return text;
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is missing in: " << text;
}

// Exit code 2, nothing on stdout, and exactly one line on stderr that says all of `parts`.
void expect_refused(const Words& words, std::initializer_list<std::string> parts, const std::string& folder = "",
                    int exit_code = 2) {
  SCOPED_TRACE(joined(words));
  const ProgramResult result = run_program(words, folder);
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("shellmatch: error: ", 0), 0u) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  for (const std::string& part : parts) expect_contains(result.err, part);
}

class Cli : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("shellmatch_cli_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::size_t n_files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(Cli, EveryCommandHelps) {
  for (const char* command : {"match", "run", "generate", "apply", "inspect", "curvature", "check-gradient",
                              "self-test", "view", "render", "study", "config"}) {
    SCOPED_TRACE(command);
    const ProgramResult result = run_program({command, "--help"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    expect_contains(result.out, fmt::format("Usage: shellmatch {}", command));
    expect_contains(result.out, "Examples:");
    expect_contains(result.out, fmt::format("  shellmatch {} ", command));
    // The first page of the manual names it too.
    expect_contains(run_program({"--help"}).out, fmt::format("\n  {} ", command));
  }
  for (const char* option :
       {"-o", "--levels", "--placement", "--profile", "--threads", "--set", "-q", "-v", "--force", "--restart"})
    for (const char* command : {"match", "run"}) expect_contains(run_program({command, "--help"}).out, option);
}

TEST_F(Cli, VersionIsPrinted) {
  const ProgramResult result = run_program({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out.rfind("shellmatch ", 0), 0u) << result.out;
}

TEST_F(Cli, MisspeltCommandsAndOptionsGetASuggestion) {
  expect_refused({}, {"a command is missing",
                      "match, run, study, cohort, generate, apply, inspect, curvature, check-gradient, self-test, "
                      "view, render, config"});
  expect_refused({"mtach", "a", "b"}, {"unknown command mtach", "did you mean match?"});
  expect_refused({"dance"}, {"unknown command dance", "match, run"});
  expect_refused({"match", "--levls", "3:7", "a", "b", "-o", "out"},
                 {"--levls", "did you mean --levels?", "match --help"});
  expect_refused({"run", "--thread=4", "a.yaml"}, {"--thread", "did you mean --threads?"});
  expect_refused({"--versoin"}, {"--versoin", "did you mean --version?"});
  expect_refused({"match", "-x", "a", "b", "-o", "out"}, {"unknown option -x"});
}

TEST_F(Cli, MissingAndSuperfluousWords) {
  expect_refused({"match", "a.ply"}, {"TEMPLATE", "match --help"});
  expect_refused({"match", "a.ply", "b.ply"}, {"match", "-o DIR"});
  expect_refused({"match", "a.ply", "b.ply", "c.ply", "-o", "out"}, {"c.ply"});
  expect_refused({"run"}, {"CONFIG"});
  expect_refused({"apply", "out", "a.ply"}, {"-o FILE"});
  expect_refused({"generate"}, {"--list"});
  expect_refused({"generate", "hand"}, {"-o FILE"});
  expect_refused({"inspect"}, {"FILE"});
  expect_refused({"match", "a", "b", "-o", "out", "-q", "-v"}, {"--quiet", "--verbose"});
  expect_refused({"match", "a", "b", "-o"}, {"--output"});
}

TEST_F(Cli, GenerateListsShapesAndTheirParameters) {
  const ProgramResult all = run_program({"generate", "--list"});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(all.err, "");
  for (const char* part : {"sphere (3D): ", "leaf (2D): ", "\n  hand/bent ", "`shellmatch generate NAME --list`"})
    expect_contains(all.out, part);
  const ProgramResult one = run_program({"generate", "leaf", "--list"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  for (const char* part :
       {"leaf (2D): ", "Variants:\n", "\n  shallow ", "Parameters:\n", "\n  lobes ", "(3 <= x <= 9; default 5)"})
    expect_contains(one.out, part);
  EXPECT_EQ(one.out.find("sphere"), std::string::npos) << one.out;
}

TEST_F(Cli, GenerateTakesParametersAndSaysWhichItDoesNotKnow) {
  const std::string file = (folder_ / "leaf.csv").string();
  const ProgramResult made = run_program({"generate", "leaf", "-o", file, "--set", "lobes=3", "--set", "depth=0.1"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const auto size = fs::file_size(file);
  EXPECT_GT(size, 1000u);
  expect_refused({"generate", "laef", "--list"}, {"laef", "did you mean leaf?", "generate --list"});
  expect_refused({"generate", "leaf", "-o", file, "--force", "--set", "lobs=3"}, {"lobs", "lobes"});
  expect_refused({"generate", "leaf", "-o", file, "--force", "--set", "lobes"}, {"--set lobes", "parameter=value"});
  expect_refused({"generate", "leaf", "-o", file, "--force", "--set", "=3"}, {"--set =3", "parameter=value"});
  expect_refused({"generate", "leaf", "-o", file, "--force", "--set", "lobes=many"},
                 {"lobes", "many", "expected a number"});
  EXPECT_EQ(fs::file_size(file), size);
}

TEST_F(Cli, WrongValuesNameTheOption) {
  const auto match = [](Words words) {
    words.insert(words.begin(), {"match", "a.ply", "b.ply", "-o", "out"});
    return words;
  };
  expect_refused(match({"--levels", "7"}), {"--levels 7", "MIN:MAX"});
  expect_refused(match({"--levels", "3:x"}), {"--levels 3:x", "cascade.max_level", "an integer"});
  expect_refused(match({"--levels", "7:3"}), {"--levels 7:3", "cascade.max_level", "below"});
  expect_refused(match({"--levels", "0:3"}), {"--levels 0:3", "out of range"});
  expect_refused(match({"--placement", "fti"}), {"--placement fti", "did you mean fit?"});
  expect_refused(match({"--profile", "papre"}), {"--profile papre", "did you mean paper?"});
  expect_refused(match({"--threads", "many"}), {"--threads many", "an integer"});
  expect_refused(match({"--set", "cascade.nuu=3"}), {"--set cascade.nuu=3", "did you mean cascade.nu?"});
  expect_refused(match({"--set", "cascade.nu=2", "--set", "energy.delta=-1"}),
                 {"--set energy.delta=-1", "out of range"});
  expect_refused(match({"--set", "nonsense"}), {"--set nonsense", "key.sub=value"});
  expect_refused({"config", "--profile", "defualt"}, {"did you mean default?"});
}

TEST_F(Cli, WrongConfigurationsNameFileAndLine) {
  expect_refused({"run", "none.yaml"}, {"none.yaml", "no such file"}, folder_.string());
  const std::string misspelt = write("misspelt.yaml", "threads: 1\ncascade:\n  max_levle: 5\n");
  expect_refused({"run", misspelt}, {"misspelt.yaml:3:", "max_levle", "did you mean cascade.max_level?"});
  const ProgramResult twice = run_program({"run", write("twice.yaml", "thread: 1\ncascade: {max_levle: 5}\n")});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_EQ(std::ranges::count(twice.err, '\n'), 2) << twice.err;
  EXPECT_TRUE(has(twice.err, "\nshellmatch: error: ") && has(twice.err, "did you mean threads?") &&
              has(twice.err, "twice.yaml:2:"))
      << twice.err;
  expect_refused({"run", write("no_input.yaml", "threads: 1\n")}, {"no_input.yaml", "input.reference", "missing"});
  expect_refused({"run", write("empty.yaml", "")}, {"empty.yaml", "empty"});
  EXPECT_EQ(n_files(), 4u) << "something was written";
}

// A file that sets all options leaves nothing to a profile, which would only be recorded.
TEST_F(Cli, AProfileThatChangesNothingIsRefused) {
  const std::string all = write("all.yaml", run_program({"config"}).out), few = write("few.yaml", "threads: 1\n");
  expect_refused({"run", all, "--profile", "paper"},
                 {"--profile paper", "all.yaml sets every option in which the profiles differ", "--set"});
  expect_refused({"run", all, "--profile", "default"}, {"input.reference"});
  expect_refused({"run", few, "--profile", "paper"}, {"input.reference"});
}

TEST_F(Cli, MissingShapesAreNamed) {
  expect_refused({"match", "none.ply", "none.ply", "-o", "out"}, {"none.ply"}, folder_.string());
  expect_refused({"inspect", "none.ply"}, {"none.ply"}, folder_.string());
  expect_refused({"apply", "none", "none.ply", "-o", "moved.ply"}, {"none"}, folder_.string());
  expect_refused({"inspect", "generate:hnad"}, {"hnad", "hand"}, folder_.string());
  EXPECT_EQ(n_files(), 0u) << "something was written";
}

// Newton's matrix is kept in single precision, which has no room for such weights; another method goes on.
TEST_F(Cli, WhatIsNotFiniteIsNamed) {
  const Words words{"match", "generate:circle", "generate:ellipse", "-o", "out", "--levels", "3:3", "--align", "none"};
  Words weighted = words;
  weighted.insert(weighted.end(), {"--set", "cascade.nu=1e-60", "--set", "solver.stop.max_iterations=3"});
  const ProgramResult result = run_program(weighted, folder_.string());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_contains(result.err, "newton gave up");
  expect_contains(result.err, "the Newton model of the term match is not finite in the cell of side 0.125 at (");
  expect_contains(result.err, ", at the point (");
  Words infinite = words;
  infinite[4] = "infinite";
  infinite.insert(infinite.end(), {"--set", "cascade.nu=1e-320"});
  const ProgramResult refused = run_program(infinite, folder_.string());
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  expect_contains(refused.err, "the value of the term match is not finite in the cell of side 0.125 at (");
}

TEST_F(Cli, CurvatureWritesItsFolder) {
  const ProgramResult result = run_program(
      {"curvature", "generate:circle", "-o", "curvature", "--levels", "3:5", "--rings", "3"}, folder_.string());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  expect_contains(result.out, "against the formula");
  for (const char* name :
       {"summary.json", "config.yaml", "curvature.csv", "pictures/scatter.png", "pictures/curvature.png"})
    EXPECT_GT(fs::file_size(folder_ / "curvature" / name), 0u) << name;
  // It is an output folder like any other: kept, or replaced with --force.
  expect_refused({"curvature", "generate:circle", "-o", "curvature"}, {"not empty", "--force"}, folder_.string());
  EXPECT_EQ(run_program({"curvature", "generate:box", "-o", "curvature", "--levels", "3:3", "-q", "--force"},
                        folder_.string())
                .exit_code,
            0);
  EXPECT_GT(fs::file_size(folder_ / "curvature" / "curvature.ply"), 0u);
  EXPECT_EQ(n_files(), 1u);
}

TEST_F(Cli, CurvatureRefusesWhatItCannotUse) {
  expect_refused({"curvature", "generate:circle"}, {"curvature", "-o DIR"});
  expect_refused({"curvature", "none.ply", "-o", "out"}, {"none.ply"}, folder_.string());
  expect_refused({"curvature", "generate:circle", "-o", "out", "--rings", "0"}, {"--rings 0", "from 1 to 10"},
                 folder_.string());
  expect_refused({"curvature", "generate:circle", "-o", "out", "--degree", "5"}, {"--degree 5", "from 2 to 4"},
                 folder_.string());
  expect_refused({"curvature", write("big.csv", "0,0\n9,0\n9,9\n"), "-o", "out", "--placement", "as-is"}, {"big.csv"},
                 folder_.string());
  expect_refused({"curvature", "generate:sphere", "-o", "out", "--levels", "3:15"}, {"level 15", "--levels"},
                 folder_.string(), 3);
  EXPECT_EQ(n_files(), 1u) << "something was written";
}

TEST_F(Cli, HostileWordsEndInAMessage) {
  for (const Words& words :
       {Words{""}, Words{"-"}, Words{"--"}, Words{"--", "match"}, Words{"match", ""}, Words{"match", "--set"},
        Words{"run", "/"}, Words{std::string(100000, 'x')}, Words{"match", "a", "b", "-o", ""}, Words{"inspect", ""}}) {
    SCOPED_TRACE(joined(words));
    const ProgramResult result = run_program(words, folder_.string());
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

void expect_every_path(const OptionNode& section, const std::string& table) {
  for (const OptionNode& option : section.children) {
    if (option.kind != OptionKind::section) expect_contains(table, fmt::format("| `{}` |", option.path));
    expect_every_path(option, table);
  }
}

TEST_F(Cli, ConfigPrintsEveryOption) {
  ExperimentOptions options;
  const OptionNode root = option_tree(options);
  const ProgramResult table = run_program({"config", "--markdown"});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  expect_every_path(root, table.out);
}

TEST_F(Cli, ConfigOfAProfileIsReadBack) {
  const ProgramResult config = run_program({"config", "--profile", "paper"});
  EXPECT_EQ(config.exit_code, 0) << config.err;
  expect_contains(config.out, "\nprofile: paper\n");
  // All that is wrong with it is that no shapes are named yet.
  expect_refused({"run", write("paper.yaml", config.out)}, {"input.reference", "missing"});
}

TEST_F(Cli, DerivativesOfAnExperimentAreChecked) {
  const std::string config = write("circle.yaml",
                                   "input: {reference: generate:circle, template: generate:ellipse, placement: as-is}\n"
                                   "cascade: {min_level: 3, max_level: 5}\n");
  const std::string json = (folder_ / "check.json").string();
  const ProgramResult result = run_program({"check-gradient", config, "--level", "4", "--json", json});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* part : {"match", "membrane", "bending", "volume", "barrier", "sum", "at level 4", "\npassed\n"})
    expect_contains(result.out, part);
  EXPECT_TRUE(fs::exists(json));
  expect_refused({"check-gradient", config, "--json", json}, {"check.json", "exists already", "--force"});
  expect_refused({"check-gradient", config, "--json", "none/x.json"}, {"none/x.json", "no folder"}, folder_.string());
  EXPECT_EQ(run_program({"check-gradient", config, "-q", "--level", "3", "--json", json, "--force"}).out, "");
}

TEST_F(Cli, ChecksThatCannotBeMadeSayWhy) {
  const std::string config = write("circle.yaml",
                                   "input: {reference: generate:circle, template: generate:ellipse}\ncascade: "
                                   "{min_level: 3, max_level: 5}\nalign: {mode: none}\n");
  const auto check = [&](Words words) {
    words.insert(words.begin(), {"check-gradient", config});
    return words;
  };
  expect_refused(check({"--level", "6"}), {"--level 6", "3 to 5"});
  expect_refused(check({"--level", "x"}), {"--level x", "a whole number"});
  expect_refused(check({"--state", "idenity"}), {"--state idenity", "identity", "random:AMPLITUDE"});
  expect_refused(check({"--state", "random:0.9"}), {"--state random:0.9", "folds", "smaller"});
  expect_refused(check({"--state", folder_.string()}), {"deformation.vtu"});
  expect_refused(check({"--directions", "0"}), {"--directions 0", "whole number, at least 1"});
  expect_refused({"check-gradient", "none.yaml"}, {"none.yaml", "no such file"});
}

TEST_F(Cli, AFullDiskIsTheMachinesFault) {
  const std::string command = fmt::format("{} config > /dev/full 2> {}/err", SHELLMATCH_PROGRAM, folder_.string());
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 6);
}

}  // namespace
}  // namespace shellmatch
