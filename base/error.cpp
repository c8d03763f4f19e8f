#include "base/error.h"

namespace shellmatch {

void invariant_failed(const char* condition, const char* file, int line, std::string_view what) {
  throw std::logic_error(fmt::format("internal error: {} ({} does not hold at {}:{}); please report it", what,
                                     condition, file, line));
}

}  // namespace shellmatch
