// The self-test of the program as a user runs it. What it says of planted errors: tests/matching/self_test.

#include "tests/apps/cli_harness.h"
#include "tests/support/slowdown.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>

namespace shellmatch {
namespace {

TEST(SelfTestCommand, PassesWithinSeconds) {
  rusage before{}, after{};
  getrusage(RUSAGE_CHILDREN, &before);
  const ProgramResult result = run_program({"self-test"}, "", std::chrono::minutes(10));
  getrusage(RUSAGE_CHILDREN, &after);
  // Of the processor, which does not depend on what else the machine does.
  EXPECT_LT(after.ru_utime.tv_sec - before.ru_utime.tv_sec, 20 * test::slowdown);
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_FALSE(has(result.out, "FAILED")) << result.out;
  for (const char* group :
       {"closed forms", "gradients, 2D", "gradients, 3D", "folds, 2D", "folds, 3D", "match, 2D", "match, 3D"})
    EXPECT_TRUE(has(result.out, group)) << group;
  EXPECT_GE(std::ranges::count(result.out, '\n'), 25);
}

}  // namespace
}  // namespace shellmatch
