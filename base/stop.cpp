#include "base/stop.h"

#include <atomic>

namespace shellmatch {

namespace {
std::atomic<StopCause (*)()> asked = nullptr;
}

void stop_loops_when(StopCause (*question)()) { asked = question; }

void stop_if_wanted() {
  StopCause (*const question)() = asked.load(std::memory_order_relaxed);
  if (question == nullptr) return;
  if (const StopCause cause = question(); cause != StopCause::none) throw Stopped("stopped; nothing was written", cause);
}

}  // namespace shellmatch
