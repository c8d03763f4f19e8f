// Tables that the program makes for the documentation are those of this program.

#include "tests/apps/cli_harness.h"
#include "tests/support/folders.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace shellmatch {
namespace {

TEST(Documents, TheTableOfOptionsIsThatOfThisProgram) {
  std::ifstream file(test::source_folder() / "docs/options.md");
  ASSERT_TRUE(file);
  std::ostringstream text;
  text << file.rdbuf();
  const ProgramResult made = run_program({"config", "--markdown"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string all = text.str();
  ASSERT_GE(all.size(), made.out.size());
  EXPECT_TRUE(all.ends_with(made.out)) << "docs/options.md is out of date: run scripts/make-docs";
}

}  // namespace
}  // namespace shellmatch
