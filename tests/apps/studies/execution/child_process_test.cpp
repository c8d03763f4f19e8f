#include "apps/studies/execution/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

std::string log_file() {
  return testing::TempDir() + "shellmatch_child_" + testing::UnitTest::GetInstance()->current_test_info()->name() +
         ".txt";
}

std::string contents(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

ProcessResult result_of(const std::string& script, const ProcessLimits& limits = {}) {
  ChildProcess child({"/bin/sh", "-c", script}, log_file(), limits);
  for (;;) {
    if (const auto result = child.poll()) return *result;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

TEST(ChildProcess, TellsItsExitCodeAndWords) {
  const ProcessResult result = result_of("echo out; echo err >&2; exit 7");
  EXPECT_EQ(result.end, ProcessEnd::exited);
  EXPECT_EQ(result.exit_code, 7);
  EXPECT_EQ(contents(log_file()), "out\nerr\n");
}

TEST(ChildProcess, TellsItsSignal) {
  const ProcessResult result = result_of("kill -ABRT $$");
  EXPECT_EQ(result.end, ProcessEnd::signalled);
  EXPECT_EQ(result.signal, SIGABRT);
}

TEST(ChildProcess, IsAskedToStopBeforeItIsKilled) {
  const ProcessResult polite =
      result_of("trap 'echo stopping; exit 3' TERM; while :; do sleep 0.02; done", {0.2, 5, 0});
  EXPECT_EQ(polite.end, ProcessEnd::timed_out);
  EXPECT_EQ(polite.exit_code, 3);
  EXPECT_NE(contents(log_file()).find("stopping\n"), std::string::npos);
  const ProcessResult deaf = result_of("trap '' TERM; while :; do sleep 0.02; done", {0.2, 0.2, 0});
  EXPECT_EQ(deaf.end, ProcessEnd::timed_out);
  EXPECT_EQ(deaf.signal, SIGKILL);
  EXPECT_GE(deaf.seconds, 0.4);
}

// The memory of what it has started counts, too.
TEST(ChildProcess, IsEndedForItsMemory) {
  const ProcessResult result = result_of("head -c 200000000 /dev/zero | tail | wc -c; sleep 5", {20, 0, 100000000});
  EXPECT_EQ(result.end, ProcessEnd::out_of_memory);
  EXPECT_GT(result.peak_memory_bytes, 100000000u);
}

// Whether it goes by itself or with the object: what it has started goes with it.
TEST(ChildProcess, LeavesNothingBehind) {
  const std::string mark = testing::TempDir() + "shellmatch_child_mark";
  for (const bool by_itself : {true, false}) {
    fs::remove(mark);
    const std::string script = "(sleep 0.5; echo x > " + mark + ") & " + (by_itself ? "exit 0" : "sleep 10");
    if (by_itself) result_of(script);
    else ChildProcess(std::vector<std::string>{"/bin/sh", "-c", script}, log_file(), ProcessLimits{});
    std::this_thread::sleep_for(std::chrono::milliseconds(900));
    EXPECT_FALSE(fs::exists(mark)) << by_itself;
  }
}

TEST(ChildProcess, SaysWhatCannotBeExecuted) {
  try {
    ChildProcess({"/nowhere/program"}, log_file(), {});
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/program: cannot be executed"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace shellmatch
