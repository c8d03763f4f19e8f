#include "base/error.h"

#include <cerrno>

namespace shellmatch {

std::string without_nul(std::string text) {
  for (std::size_t at = text.find('\0'); at != text.npos; at = text.find('\0', at)) text.replace(at, 1, "\\x00");
  return text;
}

void cannot_be_written(int error, const std::string& text) {
  if (error == 0 || error == ENOSPC || error == EDQUOT) throw DiskError(text);
  throw EnvironmentError(text);
}

void invariant_failed(const char* condition, const char* file, int line, std::string_view what) {
  throw std::logic_error(
      fmt::format("internal error: {} ({} does not hold at {}:{}); please report it", what, condition, file, line));
}

}  // namespace shellmatch
