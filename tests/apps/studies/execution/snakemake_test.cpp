// The same study by Snakemake, on this machine.

#include <cstdlib>

#include "tests/apps/studies/execution/study_harness.h"
#include "tests/support/folders.h"

namespace shellmatch {
namespace {

TEST_F(StudyProgram, SnakemakeGivesTheSameTable) {
  const std::string study = write("study.yaml", small_study);
  ASSERT_EQ(run_program({"study", study, "-o", path("direct"), "-q"}).exit_code, 0);
  const std::string command =
      "cd '" + folder_.string() + "' && HOME='" + folder_.string() + "' snakemake --cores 2 --snakefile '" +
      test::source_folder().string() +
      "/studies/workflow/Snakefile' --config study=study.yaml out=snake program='" SHELLMATCH_PROGRAM "' >log.txt 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << "see " << path("log.txt");
  const CsvTable direct = lasting_table(folder_ / "direct");
  EXPECT_EQ(direct.size(), 10u);
  EXPECT_EQ(lasting_table(folder_ / "snake"), direct);
}

}  // namespace
}  // namespace shellmatch
