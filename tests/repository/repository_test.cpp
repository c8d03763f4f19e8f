#include <gtest/gtest.h>

#include "tests/repository/include_rules.h"
#include "tests/repository/structure_rules.h"
#include "tests/support/folders.h"

// The rules held against this repository. That each rule can be broken is shown in rules_test.cpp.

namespace shellmatch::repository {
namespace {

const SourceTree& this_repository() {
  static const SourceTree tree = read_tree(test::source_folder());
  return tree;
}

void expect_none(const std::vector<Finding>& findings) { EXPECT_TRUE(findings.empty()) << to_text(findings); }

// A rule that sees no file holds always.
TEST(Repository, IsSeen) {
  EXPECT_TRUE(this_repository().files.contains("base/error.h"));
  EXPECT_TRUE(this_repository().files.contains("README.md"));
  EXPECT_GT(this_repository().files.size(), 50u);
}

TEST(Repository, IncludesRunOneWay) { expect_none(check_include_direction(this_repository())); }
TEST(Repository, LibrariesAreIncludedByTheirAdaptersOnly) { expect_none(check_adapters(this_repository())); }
TEST(Repository, FilesDoNotIncludeEachOther) { expect_none(check_unit_cycles(this_repository())); }
TEST(Repository, RoomsAreSmall) { expect_none(check_room_sizes(this_repository())); }
TEST(Repository, RoomsDoNotIncludeEachOther) { expect_none(check_room_cycles(this_repository(), {})); }
TEST(Repository, TestsMirrorTheFolders) { expect_none(check_test_folders(this_repository())); }
TEST(Repository, FilesAreShort) { expect_none(check_lengths(this_repository())); }

}  // namespace
}  // namespace shellmatch::repository
