#include "matching/output/mount_point.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace shellmatch {

bool is_mount_point(const std::filesystem::path& folder) {
  struct statx found {};
  if (::statx(AT_FDCWD, folder.c_str(), 0, STATX_BASIC_STATS, &found) != 0) return false;
  if ((found.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT) != 0)
    return (found.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
  struct statx above {};
  return ::statx(AT_FDCWD, folder.parent_path().c_str(), 0, STATX_BASIC_STATS, &above) == 0 &&
         (found.stx_dev_major != above.stx_dev_major || found.stx_dev_minor != above.stx_dev_minor);
}

}  // namespace shellmatch
