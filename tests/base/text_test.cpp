#include "base/text.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(Text, CountsHaveTheirNoun) {
  EXPECT_EQ(counted(0, "vertex", "vertices"), "0 vertices");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(12, "vertex", "vertices"), "12 vertices");
}

TEST(Text, NamesOfFilesHaveNothingThatAShellOrAPathReads) {
  EXPECT_EQ(safe_file_name("a/b c=1e-3"), "a_b_c=1e-3");
  EXPECT_EQ(safe_file_name("AZaz09._+-=,"), "AZaz09._+-=,");
  EXPECT_EQ(safe_file_name("$(x)*?\\:\n@[`{"), "__x__________");
  EXPECT_EQ(safe_file_name("\xc3\xb6"), "__") << "of a letter beyond ASCII each byte";
}

}  // namespace
}  // namespace shellmatch
