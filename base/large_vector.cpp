#include "base/large_vector.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace shellmatch {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  // The result is ignored: memory without large pages works as well.
  static_cast<void>(::madvise(memory, bytes, MADV_HUGEPAGE));
#endif
}

}  // namespace shellmatch
