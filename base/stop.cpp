#include "base/stop.h"

#include <atomic>

namespace shellmatch {

namespace {
std::atomic<bool (*)()> question = nullptr;
}

void stop_loops_when(bool (*wanted)()) { question = wanted; }

void stop_if_wanted() {
  bool (*const wanted)() = question.load(std::memory_order_relaxed);
  if (wanted != nullptr && wanted()) throw Stopped("stopped on request; nothing was written");
}

}  // namespace shellmatch
