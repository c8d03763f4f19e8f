#include "matching/output/write_file.h"

#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(MountPoint, IsTheRootOfAFileSystemAlone) {
  const testing::TemporaryFolder tmp;
  EXPECT_TRUE(is_mount_point("/proc"));
  EXPECT_FALSE(is_mount_point("/proc/self/fd"));
  EXPECT_FALSE(is_mount_point(tmp / ""));
  EXPECT_FALSE(is_mount_point(tmp / "nothing"));
}

}  // namespace
}  // namespace shellmatch
