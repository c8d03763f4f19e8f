// `shellmatch study` as a user meets it: what is killed goes on, and what misbehaves costs its own row.

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

#include "matching/output/file_lock.h"
#include "tests/apps/studies/execution/study_harness.h"
#include "tests/support/slowdown.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

// Finished ones only: until it is renamed, a run's folder is a hidden one.
std::size_t n_results(const fs::path& folder) {
  std::size_t n = 0;
  if (fs::exists(folder / "runs"))
    for (const auto& entry : fs::directory_iterator(folder / "runs"))
      n += entry.path().filename().string().front() != '.' && fs::exists(entry.path() / "result.json");
  return n;
}

TEST_F(StudyProgram, KilledAtRandomAndResumedGivesTheSameTable) {
  const std::string study = write("study.yaml", small_study);
  ASSERT_EQ(run_program({"study", study, "-o", path("whole"), "-q"}).exit_code, 0);
  const CsvTable whole = lasting_table(folder_ / "whole");
  ASSERT_EQ(whole.size(), 10u);
  for (const auto& [run, columns] : whole) EXPECT_EQ(columns.at("status"), "finished") << run;

  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  std::mt19937 random(seed);
  using Clock = std::chrono::steady_clock;
  std::size_t at_last_kill = 0;
  for (int n_kills = 0; n_kills < 5; ++n_kills) {
    Program program({"study", study, "-o", path("torn"), "-q"});
    // However fast the machine: at the first new result it is too late to wait, or nothing is left to kill.
    const auto end = Clock::now() + std::chrono::milliseconds(std::uniform_int_distribution<>(20, 400)(random));
    while (Clock::now() < end && n_results(folder_ / "torn") == at_last_kill)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.send_signal(SIGKILL);
    program.wait();
    EXPECT_GE(n_results(folder_ / "torn"), at_last_kill) << "a result was lost";
    at_last_kill = n_results(folder_ / "torn");
    ASSERT_LT(at_last_kill, 10u) << "nothing was left to kill";
  }
  ASSERT_EQ(run_program({"study", study, "-o", path("torn"), "-q"}).exit_code, 0);
  EXPECT_EQ(lasting_table(folder_ / "torn"), whole);
  for (const auto& entry : fs::directory_iterator(folder_ / "torn" / "runs"))
    EXPECT_NE(entry.path().filename().string().front(), '.') << "left behind: " << entry.path();
}

// A kill after a run's folder is in its place and before its lock is removed leaves the lock of a finished run.
TEST_F(StudyProgram, LeftoversThatNobodyHoldsGoWhenAStudyGoesOn) {
  const std::string study = write("study.yaml", R"(version: 1
set:
  threads: 1
  pictures: none
  input: {reference: generate:leaf/deep, template: generate:leaf/shallow, placement: as-is}
  cascade: {min_level: 3, max_level: 3}
problems: {leaf: {set: {energy: {delta: 1}}}}
solvers: [newton, lbfgs]
)");
  const auto go_on = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"study", study, "-o", path("out"), "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = run_program(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  };
  const auto hidden = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out"))
      if (entry.path().filename().string().front() == '.')
        names.push_back(fs::relative(entry.path(), folder_ / "out").string());
    std::sort(names.begin(), names.end());
    return names;
  };
  using Names = std::vector<std::string>;
  go_on({});
  EXPECT_EQ(hidden(), Names{});

  // All of one run, or of one that the study does not have any more, and of a table that was being written.
  const auto leave = [&] {
    write("out/runs/.leaf-newton-r1.lock", "");
    write("out/runs/.leaf-lbfgs-r1.lock", "");
    fs::create_directories(folder_ / "out/runs/.leaf-lbfgs-r1.partial-1/output");
    write("out/runs/.gone-r1.lock", "");
    fs::create_directories(folder_ / "out/runs/.gone-r2.partial-1");
    write("out/.partial-0123456789abcdef.csv", "half");
    write("out/plots/.partial-0123456789abcdef.png", "half");
  };
  const Names left{".partial-0123456789abcdef.csv",
                   "plots/.partial-0123456789abcdef.png",
                   "runs/.gone-r1.lock",
                   "runs/.gone-r2.partial-1",
                   "runs/.leaf-lbfgs-r1.lock",
                   "runs/.leaf-lbfgs-r1.partial-1",
                   "runs/.leaf-newton-r1.lock"};
  leave();
  ASSERT_EQ(hidden(), left);
  go_on({});
  EXPECT_EQ(hidden(), Names{});
  leave();
  go_on({"--collect"});
  EXPECT_EQ(hidden(), Names{});
  {
    // What this process holds stays, and with it what its owner is writing.
    const FileLock held(path("out/runs/.leaf-lbfgs-r1.lock"), FileLock::Kind::exclusive);
    ASSERT_EQ(held.state(), FileLock::State::held);
    leave();
    go_on({});
    EXPECT_EQ(hidden(), (Names{"runs/.leaf-lbfgs-r1.lock", "runs/.leaf-lbfgs-r1.partial-1"}));
    go_on({"--collect"});
    EXPECT_EQ(hidden(), (Names{"runs/.leaf-lbfgs-r1.lock", "runs/.leaf-lbfgs-r1.partial-1"}));
  }
  go_on({});
  leave();
  // Others may be at work on the other runs.
  go_on({"--only", "leaf-lbfgs-r1"});
  const Names after = hidden();
  EXPECT_EQ(std::count(after.begin(), after.end(), "runs/.leaf-lbfgs-r1.lock"), 0);
  EXPECT_EQ(std::count(after.begin(), after.end(), "runs/.leaf-lbfgs-r1.partial-1"), 0);
  EXPECT_EQ(std::count(after.begin(), after.end(), "runs/.leaf-newton-r1.lock"), 1);
}

TEST_F(StudyProgram, CtrlCStopsAndTheSameCommandGoesOn) {
  const std::string study = write("study.yaml", small_study);
  Program program({"study", study, "-o", path("out")});
  ASSERT_TRUE(program.wait_for_stderr("finished after"));
  program.send_signal(SIGINT);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_NE(stopped.err.find("goes on where it was"), std::string::npos) << stopped.err;
  const std::size_t done = n_results(folder_ / "out");
  EXPECT_GE(done, 1u);
  EXPECT_LT(done, 10u);
  const ProgramResult resumed = run_program({"study", study, "-o", path("out")});
  EXPECT_EQ(resumed.exit_code, 0);
  std::size_t n_run = 0;
  for (std::size_t at = resumed.err.find("finished after"); at != std::string::npos;
       at = resumed.err.find("finished after", at + 1))
    ++n_run;
  EXPECT_EQ(n_run, 10 - done) << resumed.err;
  // With everything done nothing runs.
  EXPECT_EQ(run_program({"study", study, "-o", path("out")}).err.find("finished after"), std::string::npos);
}

TEST_F(StudyProgram, ARaisedLimitOrAnotherConfigurationRunsAgain) {
  const std::string text =
      "version: 1\nset: {threads: 1, pictures: none, cascade: {min_level: 3, max_level: 3}}\n"
      "problems: {leaf: {set: {input: {reference: generate:leaf/deep, template: generate:leaf/shallow, "
      "placement: as-is}}}}\n"
      "solvers: [ceres_ncg]\n";
  const std::string study = write("study.yaml", text + "limits: {seconds: 0.2, grace_seconds: 0.1}\n");
  run_program({"study", study, "-o", path("out"), "-q", "--program", MISBEHAVING_PROGRAM});
  EXPECT_EQ(read_table(folder_ / "out").at("leaf-ceres_ncg-r1").at("status"), "timed_out");
  write("study.yaml", text + "limits: {seconds: 30}\n");
  run_program({"study", study, "-o", path("out"), "-q"});
  const CsvTable first = read_table(folder_ / "out");
  EXPECT_EQ(first.at("leaf-ceres_ncg-r1").at("status"), "finished");
  run_program({"study", study, "-o", path("out"), "-q", "--set", "energy.delta=0.3"});
  const CsvTable second = read_table(folder_ / "out");
  EXPECT_NE(second.at("leaf-ceres_ncg-r1").at("fingerprint"), first.at("leaf-ceres_ncg-r1").at("fingerprint"));
  EXPECT_NE(second.at("leaf-ceres_ncg-r1").at("energy"), first.at("leaf-ceres_ncg-r1").at("energy"));
}

// Or its times would be those of half a run.
TEST_F(StudyProgram, ARunThatWasEndedBeginsAtItsFirstLevelAgain) {
  // Its coarse levels take a tenth of a second, all of them many seconds.
  const std::string study = write("study.yaml", R"(version: 1
set:
  resume: {min_seconds: 0}
  input: {reference: generate:leaf/deep, template: generate:leaf/shallow, placement: as-is}
  cascade: {min_level: 3, max_level: 13}
problems: {leaf: {set: {threads: 1}}}
solvers: [newton]
)");
  for (const double seconds : {0.8, 1.0}) {
    const std::string limit = fmt::format("limits.seconds={}", seconds * test::slowdown);
    SCOPED_TRACE(limit);
    run_program({"study", study, "-o", path("out"), "-q", "--set", limit});
    ASSERT_EQ(read_table(folder_ / "out").at("leaf-newton-r1").at("status"), "timed_out");
    const fs::path run = folder_ / "out/runs/leaf-newton-r1";
    std::vector<std::string> entries;
    for (const auto& entry : fs::directory_iterator(run)) entries.push_back(entry.path().filename().string());
    std::sort(entries.begin(), entries.end());
    EXPECT_EQ(entries, (std::vector<std::string>{"config.yaml", "files.json", "log.txt", "result.json"}));
    std::ifstream log(run / "log.txt");
    std::string first;
    // Lines of progress come before it on a busy machine.
    while (std::getline(log, first) && !first.starts_with("level")) {
    }
    EXPECT_TRUE(first.starts_with("level 3/13")) << first;
  }
}

TEST_F(StudyProgram, RunsOneByOneAndCollected) {
  const std::string study = write("study.yaml", small_study);
  const ProgramResult list = run_program({"study", study, "--list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(std::count(list.out.begin(), list.out.end(), '\n'), 10);
  EXPECT_NE(list.out.find("leaf-paper-l2-energy.delta=0.5-r1\n"), std::string::npos) << list.out;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  ASSERT_EQ(run_program({"study", study, "--only", "leaf-newton-energy.delta=1-r1", "-o", path("out"), "-q"}).exit_code,
            0);
  EXPECT_FALSE(fs::exists(folder_ / "out/table.csv"));
  ASSERT_EQ(run_program({"study", study, "--collect", "-o", path("out"), "-q"}).exit_code, 0);
  const CsvTable table = read_table(folder_ / "out");
  ASSERT_EQ(table.size(), 10u);
  for (const auto& [run, columns] : table)
    EXPECT_EQ(columns.at("status"), run == "leaf-newton-energy.delta=1-r1" ? "finished" : "not_run") << run;
}

// Shapes and base files are found from there, whatever form the file has.
TEST_F(StudyProgram, TheCopyInTheOutputFolderRunsFromThere) {
  fs::create_directories(folder_ / "shapes");
  for (const char* shape : {"circle", "ellipse"})
    run_program({"generate", shape, "-o", path(fmt::format("shapes/{}.csv", shape))});
  write("base.yaml",
        "input: {reference: shapes/circle.csv, template: shapes/ellipse.csv}\ncascade: {min_level: 3, max_level: 3}\n");
  int n = 0;
  for (const char* text :
       {"# by hand\nversion: 1\nset: {threads: 1, pictures: none}\nproblems: {leaf: {base: base.yaml}}\nsolvers: "
        "[newton]",
        "{version: 1, set: {threads: 1, pictures: none}, problems: {leaf: {base: base.yaml}}, solvers: [newton]}\n",
        "  version: 1\n  problems: {leaf: {base: base.yaml}}\n  solvers: [newton]\n"}) {
    SCOPED_TRACE(text);
    const std::string study = write("study.yaml", text), out = path(fmt::format("out{}", ++n)),
                      again = path(fmt::format("again{}", n));
    ASSERT_EQ(run_program({"study", study, "-o", out, "-q"}).exit_code, 0);
    const ProgramResult copy = run_program({"study", "study.yaml", "-o", again, "-q"}, out);
    EXPECT_EQ(copy.exit_code, 0) << copy.err;
    EXPECT_EQ(lasting_table(out), lasting_table(again));
    EXPECT_EQ(run_program({"study", study, "-o", out}).err.find("finished after"), std::string::npos)
        << "the same study";
  }
  // A folder that the command line names stands in the copy, too.
  fs::create_directories(folder_ / "elsewhere");
  const std::string moved =
      write("elsewhere/study.yaml", "version: 1\nproblems: {leaf: {base: base.yaml}}\nsolvers: [newton]\n");
  ASSERT_EQ(run_program({"study", moved, "-o", path("out9"), "-q", "--set", "folder=" + folder_.string()}).exit_code,
            0);
  const ProgramResult copied = run_program({"study", "study.yaml", "-o", path("again9"), "-q"}, path("out9"));
  EXPECT_EQ(copied.exit_code, 0) << copied.err;
  const ProgramResult relative =
      run_program({"study", write("study.yaml", fmt::format("folder: here\n{}", small_study)), "-o", path("r")});
  EXPECT_EQ(relative.exit_code, 2);
  EXPECT_NE(relative.err.find("folder: here is no absolute path"), std::string::npos) << relative.err;
}

TEST_F(StudyProgram, MistakesAreRefusedWithOneClearLine) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& part) {
    const ProgramResult result = run_program(words, folder_.string());
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(part), std::string::npos) << part << " is missing in: " << result.err;
  };
  const std::string study = write("study.yaml", small_study);
  refused({"study", "nowhere.yaml"}, "no such file");
  refused({"study", study, "--only", "leaf-newtn-energy.delta=1-r1"}, "did you mean leaf-newton-energy.delta=1-r1?");
  refused({"study", study, "--jobs", "0"}, "--jobs 0: expected a whole number from 1 to 1024");
  refused({"study", study, "--collect", "--only", "leaf-newton-energy.delta=1-r1"}, "--collect is for the whole study");
  refused({"study", study, "--set", "limits.memory_mb=1e30"}, "limits.memory_mb");
  refused({"study", study, "--program", "nowhere"}, "no program");
  refused({"study", study, "--set", "energy.detla=1"}, "energy.delta");
  fs::create_directories(folder_ / "mine");
  write("mine/letter.txt", "dear");
  refused({"study", study, "-o", "mine"}, "letter.txt");
  EXPECT_FALSE(fs::exists(folder_ / "mine/study.yaml"));
}

}  // namespace
}  // namespace shellmatch
