// What a signal does, and a second one.

#include "apps/process/interrupt.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace shellmatch {
namespace {

using testing::TemporaryFolder;

// In a process of its own.
TEST(Signals, ASecondOneOfAnyKindEndsTheProgram) {
  const auto after = [](int first, int second) {
    catch_interrupts();
    raise(first);
    if (!interrupt_requested()) _exit(1);
    raise(second);
    _exit(0);
  };
  EXPECT_EXIT(after(SIGINT, SIGTERM), ::testing::KilledBySignal(SIGTERM), "");
  EXPECT_EXIT(after(SIGTERM, SIGINT), ::testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(after(SIGHUP, SIGHUP), ::testing::KilledBySignal(SIGHUP), "");
}

TEST(Signals, OneThatNothingAsksForEndsTheProgramWithinTwoSeconds) {
  const auto ended_by_itself = [](bool is_heard) {
    catch_interrupts();
    std::raise(SIGTERM);
    if (is_heard && !interrupt_requested()) _exit(1);
    for (int second = 0; second < 3; ++second)
      for (unsigned left = 1; left > 0;) left = sleep(left);  // a signal cuts it short
    _exit(7);
  };
  EXPECT_EXIT(ended_by_itself(false), ::testing::ExitedWithCode(128 + SIGTERM), "stopped at once");
  EXPECT_EXIT(ended_by_itself(true), ::testing::ExitedWithCode(7), "");
}

TEST(Signals, OneThatIsIgnoredStaysIgnored) {
  const auto ignored = [](int signal) {
    std::signal(signal, SIG_IGN);
    catch_interrupts();
    raise(signal);
    _exit(interrupt_requested() ? 1 : 0);
  };
  EXPECT_EXIT(ignored(SIGHUP), ::testing::ExitedWithCode(0), "");
  EXPECT_EXIT(ignored(SIGINT), ::testing::ExitedWithCode(0), "");
}

TEST(Signals, TheEndOfTheTerminalStopsARunInOrder) {
  const TemporaryFolder tmp;
  Program program({"match", "generate:sphere", "generate:ellipsoid/long", "-o", tmp / "o", "--levels", "3:7", "--align",
                   "none", "--set", "resume.min_seconds=0", "--set", "pictures=none"});
  ASSERT_TRUE(program.wait_for_stderr("level 4/7"));
  program.send_signal(SIGHUP);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 129) << stopped.err;
  EXPECT_TRUE(has(stopped.err, "goes on from there")) << stopped.err;
}

TEST(Signals, AShapeThatIsBeingMadeIsGivenUpInOrder) {
  const TemporaryFolder tmp;
  Program program({"generate", "hand", "-o", tmp / "h.ply", "--edge-length", "0.003"});
  ASSERT_TRUE(program.wait_for_handler(SIGTERM));
  program.send_signal(SIGTERM);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 143);
  EXPECT_TRUE(has(stopped.err, "stopped; nothing was written")) << stopped.err;
  EXPECT_EQ(tmp.entries(), Words{});
}

}  // namespace
}  // namespace shellmatch
