#include "base/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace shellmatch {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  // A wish: memory without large pages is as good, so whether it is granted does not matter.
  static_cast<void>(::madvise(memory, bytes, MADV_HUGEPAGE));
#endif
}

}  // namespace shellmatch
