// A run replaces and removes what a run wrote, and nothing else.

#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iterator>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

Words match(const std::string& out, const Words& more = {}, const std::string& levels = "3:4") {
  Words words{"match", "generate:circle", "generate:ellipse", "-o", out, "--levels", levels};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool contains_name(const Words& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// The files of a folder with their contents.
std::vector<std::pair<std::string, std::string>> files_in(const TemporaryFolder& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& name : folder.entries())
    if (fs::is_regular_file(folder / name)) files.emplace_back(name, contents_of(folder / name));
  return files;
}

// Levels up to 4 are kept then.
void stop_in_level_5(const Words& words) {
  Program run(words);
  ASSERT_TRUE(run.wait_for_stderr("level 5/6"));
  run.send_signal(SIGINT);
  ASSERT_EQ(run.wait().exit_code, 130);
}

TEST(ForeignFiles, AFolderThatOnlyLooksLikeACheckpointStays) {
  const TemporaryFolder tmp;
  fs::create_directories(tmp / "o.unfinished");
  put(tmp / "o.unfinished/state.json", "{}");
  put(tmp / "o.unfinished/thesis", "years of work");
  const ProgramResult result = run_program(match(tmp / "o", {"--set", "resume.min_seconds=0"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "o.unfinished") && has(result.err, "of no run")) << result.err;
  EXPECT_EQ(contents_of(tmp / "o.unfinished/thesis"), "years of work");
  EXPECT_EQ(contents_of(tmp / "o.unfinished/state.json"), "{}");
}

TEST(ForeignFiles, WhatIsPutIntoACheckpointStaysWhenTheRunIsDone) {
  const TemporaryFolder tmp;
  stop_in_level_5(match(tmp / "o", {"--set", "resume.min_seconds=0"}, "3:6"));
  put(tmp / "o.unfinished/notes", "years of work");
  put(tmp / "points.csv", "0.1,0.2\n");
  ASSERT_EQ(
      run_program({"apply", tmp / "o.unfinished", tmp / "points.csv", "-o", tmp / "o.unfinished/moved.csv"}).exit_code,
      0);
  const ProgramResult result = run_program(match(tmp / "o", {"--set", "resume.min_seconds=0"}, "3:6"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "going on after level")) << result.err;
  const Words names = tmp.entries();
  EXPECT_TRUE(contains_name(names, "o.unfinished/notes") && contains_name(names, "o.unfinished/moved.csv"));
  EXPECT_FALSE(contains_name(names, "o.unfinished/state.json") || contains_name(names, "o.unfinished/deformation.vtu"));
  EXPECT_TRUE(contains_name(names, "o/summary.json"));
}

TEST(ForeignFiles, LevelsOfAnotherConfigurationStayUntilALevelIsKept) {
  const TemporaryFolder tmp;
  stop_in_level_5(match(tmp / "o", {"--set", "resume.min_seconds=0"}, "3:6"));
  const auto before = contents_of(tmp / "o.unfinished/deformation.vtu");
  const ProgramResult other = run_program(match(tmp / "o", {"--set", "resume.min_seconds=1000"}));
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_TRUE(has(other.err, "the configuration has changed")) << other.err;
  EXPECT_EQ(contents_of(tmp / "o.unfinished/deformation.vtu"), before);
}

TEST(ForeignFiles, ForceReplacesNoFileOfTheUser) {
  struct Case {
    std::string file, contents;
  };
  for (const Case& c : {Case{"pictures/mine.png", "mine"}, Case{"README.txt", "mine"}, Case{"log.txt", "mine"},
                        Case{"config.yaml", "threads: 1  # edited\n"}}) {
    SCOPED_TRACE(c.file);
    const TemporaryFolder tmp;
    ASSERT_EQ(run_program(match(tmp / "o", {"-q"})).exit_code, 0);
    put(tmp / ("o/" + c.file), c.contents);
    const auto before = files_in(tmp);
    const ProgramResult result = run_program(match(tmp / "o", {"--force", "-q"}));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_TRUE(has(result.err, "'" + c.file + "'")) << result.err;
    EXPECT_EQ(files_in(tmp), before);
    fs::remove(tmp / ("o/" + c.file));
    EXPECT_EQ(run_program(match(tmp / "o", {"--force", "-q"})).exit_code, 0);
  }
}

constexpr const char* study_text =
    "version: 1\nproblems: {{leaf: {{set: {{input: {{reference: 'generate:circle', template: 'generate:ellipse'}}, "
    "cascade: {{min_level: 3, max_level: 3, nu: {}}}}}}}}}\nsolvers: [newton, lbfgs]\n";

TEST(ForeignFiles, AChangedStudyRemovesNoFileOfTheUser) {
  const TemporaryFolder tmp;
  put(tmp / "s.yaml", fmt::format(study_text, 0.001));
  ASSERT_EQ(run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "-q"}).exit_code, 0);
  put(tmp / "o/runs/leaf-newton-r1/thesis", "years of work");
  put(tmp / "s.yaml", fmt::format(study_text, 0.002));
  const ProgramResult result = run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "-q"});
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_TRUE(has(result.err, "'thesis'")) << result.err;
  EXPECT_EQ(contents_of(tmp / "o/runs/leaf-newton-r1/thesis"), "years of work");
  fs::remove(tmp / "o/runs/leaf-newton-r1/thesis");
  EXPECT_EQ(run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "-q"}).exit_code, 0);
}

// Before any run: hours may lie between the first and the one that may not be replaced.
TEST(ForeignFiles, AChangedStudySaysFirstWhatItMayNotReplace) {
  const TemporaryFolder tmp;
  put(tmp / "s.yaml", fmt::format(study_text, 0.001));
  ASSERT_EQ(run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "-q"}).exit_code, 0);
  put(tmp / "o/runs/leaf-lbfgs-r1/thesis", "years of work");
  const std::string before = contents_of(tmp / "o/runs/leaf-newton-r1/result.json");
  put(tmp / "s.yaml", fmt::format(study_text, 0.002));
  const ProgramResult result = run_program({"study", tmp / "s.yaml", "-o", tmp / "o"});
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_TRUE(has(result.err, "'thesis'")) << result.err;
  EXPECT_FALSE(has(result.err, "leaf-newton-r1 ...")) << result.err;
  EXPECT_EQ(contents_of(tmp / "o/runs/leaf-newton-r1/result.json"), before);
}

TEST(ForeignFiles, AStudyReplacesNoTablesWhereNoStudyHasRun) {
  const TemporaryFolder tmp;
  put(tmp / "s.yaml", fmt::format(study_text, 0.001));
  for (const char* file : {"summary.md", "table.csv", "study.yaml"}) {
    SCOPED_TRACE(file);
    fs::create_directories(tmp / "mine");
    put(tmp / ("mine/" + std::string(file)), "years of work");
    const ProgramResult result = run_program({"study", tmp / "s.yaml", "-o", tmp / "mine", "-q"});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_TRUE(has(result.err, file)) << result.err;
    EXPECT_EQ(contents_of(tmp / ("mine/" + std::string(file))), "years of work");
    fs::remove_all(tmp / "mine");
  }
  // The study's own file may lie where its results go.
  fs::create_directories(tmp / "own");
  fs::copy_file(tmp / "s.yaml", tmp / "own/study.yaml");
  EXPECT_EQ(run_program({"study", tmp / "own/study.yaml", "-o", tmp / "own", "-q"}).exit_code, 0);
  // It stays there, also when another study is given.
  const std::string own = contents_of(tmp / "own/study.yaml");
  put(tmp / "other.yaml", fmt::format(study_text, 0.002));
  const ProgramResult other = run_program({"study", tmp / "other.yaml", "-o", tmp / "own", "-q"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(has(other.err, "study.yaml: is not replaced, since it has been written or edited by somebody"))
      << other.err;
  EXPECT_EQ(contents_of(tmp / "own/study.yaml"), own);
}

TEST(ForeignFiles, OneDamagedSummaryDoesNotHideTheOthers) {
  const TemporaryFolder tmp;
  put(tmp / "s.yaml", fmt::format(study_text, 0.001));
  ASSERT_EQ(run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "-q"}).exit_code, 0);
  put(tmp / "o/runs/leaf-newton-r1/output/summary.json", "{\"version\": ");
  const ProgramResult result = run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "--collect", "-q"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string report = contents_of(tmp / "o/summary.md");
  EXPECT_TRUE(has(report, "1 failed, 1 finished") && has(report, "its result cannot be read")) << report;
}

TEST(ForeignFiles, AFileBesideIsNotWrittenThrough) {
  const TemporaryFolder tmp;
  put(tmp / "precious", "years of work");
  for (const char* name : {"o.csv.part", ".o.csv.part"}) fs::create_symlink(tmp / "precious", tmp / name);
  // A link that leads nowhere is a name that is taken.
  fs::create_symlink(tmp / "nowhere", tmp / "link.csv");
  EXPECT_EQ(run_program({"generate", "circle", "-o", tmp / "link.csv"}).exit_code, 2);
  EXPECT_TRUE(fs::is_symlink(tmp / "link.csv"));
  EXPECT_EQ(run_program({"generate", "circle", "-o", tmp / "o.csv"}).exit_code, 0);
  EXPECT_EQ(contents_of(tmp / "precious"), "years of work");
}

TEST(ForeignFiles, ALockThatIsALinkCreatesNothing) {
  const TemporaryFolder tmp;
  fs::create_symlink(tmp / "created", tmp / ".o.lock");
  const ProgramResult result = run_program(match(tmp / "o", {"-q"}));
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_TRUE(has(result.err, "is a link")) << result.err;
  EXPECT_FALSE(fs::exists(tmp / "created"));
}

TEST(ForeignFiles, NamesMayBeAsLongAsTheFileSystemTakes) {
  const TemporaryFolder tmp;
  const std::string name(240, 'a');
  const ProgramResult matched = run_program(match(tmp / name, {"-q", "--set", "resume.min_seconds=0"}));
  EXPECT_EQ(matched.exit_code, 0) << matched.err;
  const ProgramResult generated = run_program({"generate", "circle", "-o", tmp / (name + ".csv")});
  EXPECT_EQ(generated.exit_code, 0) << generated.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(tmp / ""), fs::directory_iterator()), 2);
}

TEST(ForeignFiles, AParentThatIsNotThereIsPassedOver) {
  const TemporaryFolder tmp;
  const ProgramResult result = run_program(match(tmp / "nope/../o", {"-q"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(fs::exists(tmp / "o/summary.json"));
  EXPECT_FALSE(fs::exists(tmp / "nope"));
}

TEST(ForeignFiles, AFileThatMayNotGrowIsAnErrorAndLeavesNothing) {
  const TemporaryFolder tmp;
  const auto limit_to = [](rlim_t bytes) {
    return [bytes] {
      const rlimit limit{bytes, bytes};
      return setrlimit(RLIMIT_FSIZE, &limit) == 0;
    };
  };
  const ProgramResult result = run_in_child(match(tmp / "o", {"-q"}), limit_to(8000));
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_TRUE(has(result.err, "cannot be written")) << result.err;
  EXPECT_EQ(tmp.entries(), Words{});
  // Pictures are larger than the result: without them it is written all the same.
  const ProgramResult without = run_in_child(match(tmp / "o"), limit_to(64000));
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_TRUE(has(without.err, "pictures/result.png is missing")) << without.err;
  const ProgramResult quiet = run_in_child(match(tmp / "quiet", {"-q"}), limit_to(64000));
  EXPECT_EQ(quiet.exit_code, 0) << quiet.err;
  EXPECT_TRUE(has(quiet.err, "pictures/result.png is missing")) << quiet.err;
  const Words names = tmp.entries();
  EXPECT_TRUE(contains_name(names, "o/summary.json"));
  EXPECT_FALSE(contains_name(names, "o/pictures/result.png"));
}

TEST(ForeignFiles, AFolderThatCannotBeLookedIntoIsRefusedBeforeAnyWork) {
  const TemporaryFolder tmp;
  fs::create_directories(tmp / "o");
  put(tmp / "o/thesis", "years of work");
  fs::permissions(tmp / "o", fs::perms(0300));
  const ProgramResult result = run_in_child(match(tmp / "o"), obey_permissions);
  fs::permissions(tmp / "o", fs::perms(0755));
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_TRUE(has(result.err, "cannot be looked into")) << result.err;
  EXPECT_FALSE(has(result.err, "level 3")) << result.err;
}

// Some schedulers and shells (trap '' CHLD) start programs so, and the system then forgets how a child ended.
TEST(ForeignFiles, AStudyThatIsStartedWithSIGCHLDIgnoredKnowsHowItsRunsEnd) {
  const TemporaryFolder tmp;
  put(tmp / "s.yaml", fmt::format(study_text, 0.001));
  run_in_child({"study", tmp / "s.yaml", "-o", tmp / "o", "-q", "--program", "/bin/false"},
               [] { return std::signal(SIGCHLD, SIG_IGN) != SIG_ERR; });
  EXPECT_TRUE(has(contents_of(tmp / "o/runs/leaf-newton-r1/result.json"), "\"exit_code\": 1"))
      << contents_of(tmp / "o/runs/leaf-newton-r1/result.json");
}

// As a mount point is, which cannot be renamed either (is_mount_point() has a test of its own).
TEST(ForeignFiles, AFolderInAParentThatMayNotBeWrittenIsFilledInPlace) {
  const TemporaryFolder tmp;
  const std::string mine = tmp / "shared/mine";
  fs::create_directories(mine);
  fs::permissions(tmp / "shared", fs::perms(0555));
  const auto run = [&](const Words& more) { return run_in_child(match(mine, more), obey_permissions); };
  const ProgramResult result = run({});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "levels are not kept")) << result.err;
  // A second run finds the first one's result, replaces it by --force, and leaves nothing hidden.
  EXPECT_EQ(run({"-q"}).exit_code, 2);
  const ProgramResult forced = run({"-q", "--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  fs::permissions(tmp / "shared", fs::perms(0755));
  EXPECT_TRUE(fs::exists(mine + "/summary.json"));
  for (const fs::directory_entry& entry : fs::directory_iterator(mine))
    EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

// What the system does not remove is no file of the user's, and goes with the next run.
TEST(ForeignFiles, FilesOfARunThatCannotBeRemovedStayHidden) {
  const TemporaryFolder tmp;
  const std::string out = tmp / "o";
  ASSERT_EQ(run_program(match(out, {"-q"})).exit_code, 0);
  fs::permissions(out + "/pictures", fs::perms(0555));
  const ProgramResult result = run_in_child(match(out, {"-q", "--force"}), obey_permissions);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tmp / "."))
    if (entry.is_directory()) fs::permissions(entry, fs::perms(0755));
  for (const fs::directory_entry& entry : fs::directory_iterator(tmp / "."))
    EXPECT_TRUE(entry.path().filename() == "o" || entry.path().filename().string().starts_with(".o.partial-"))
        << entry.path();
  EXPECT_EQ(run_program(match(out, {"-q", "--force"})).exit_code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(tmp / "."), fs::directory_iterator()), 1);
}

// Both have seen that there is no such file.
TEST(WithoutForce, TwoProgramsDoNotWriteOneFile) {
  const TemporaryFolder tmp;
  for (int i = 0; i < 10; ++i) {
    const std::string file = tmp / fmt::format("o{}.csv", i);
    Program first({"generate", "circle", "-o", file}), second({"generate", "circle", "-o", file});
    const ProgramResult a = first.wait(), b = second.wait();
    EXPECT_EQ(a.exit_code + b.exit_code, 2) << a.exit_code << " " << a.err << b.exit_code << " " << b.err;
    EXPECT_TRUE(has(a.err + b.err, "exists")) << a.err << b.err;
    EXPECT_TRUE(fs::exists(file));
  }
  EXPECT_EQ(tmp.entries().size(), 10u);
}

}  // namespace
}  // namespace shellmatch
