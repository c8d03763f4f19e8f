// What libFuzzer calls. SHELLMATCH_FUZZ_TARGET names the target (scripts/fuzz).
#include "tests/fuzz/run_input.h"

#include <cstdint>
#include <cstdlib>

namespace {

const shellmatch::fuzz::Target& chosen_target() {
  const char* name = std::getenv("SHELLMATCH_FUZZ_TARGET");
  return shellmatch::fuzz::target_named(name == nullptr ? "" : name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const shellmatch::fuzz::Target& target = chosen_target();
  shellmatch::fuzz::run_input(target, {reinterpret_cast<const char*>(data), size});
  return 0;
}
