// The same cohort by Snakemake, on this machine.

#include <cstdlib>

#include "tests/apps/cohorts/execution/cohort_harness.h"
#include "tests/support/folders.h"

namespace shellmatch {
namespace {

TEST_F(CohortProgram, SnakemakeGivesTheSameFiles) {
  const std::string file = write_cohort(3, "{kind: mean, rounds: 3, tolerance: 0.1}");
  ASSERT_EQ(cohort({file, "-o", "direct", "-q"}).exit_code, 0);
  const std::string command =
      "cd '" + folder_.string() + "' && HOME='" + folder_.string() + "' snakemake --cores 2 --snakefile '" +
      test::source_folder().string() +
      "/cohorts/workflow/Snakefile' --config cohort=cohort.yaml out=snake program='" SHELLMATCH_PROGRAM
      "' >log.txt 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << text_of("log.txt");
  const auto direct = lasting_files("direct");
  EXPECT_GT(direct.size(), 20u);
  EXPECT_EQ(lasting_files("snake"), direct);
}

}  // namespace
}  // namespace shellmatch
