#include "apps/terminal/heartbeat.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace shellmatch {

Heartbeat::Heartbeat(std::function<void()> beat) {
  try {
    thread_ = std::thread([this, beat = std::move(beat)] {
      std::unique_lock lock(mutex_);
      while (!ended_.wait_for(lock, std::chrono::seconds(1), [this] { return is_over_; })) beat();
    });
  } catch (const std::system_error&) {  // a machine that starts no further thread goes without
  }
}

Heartbeat::~Heartbeat() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  ended_.notify_all();
  if (thread_.joinable()) thread_.join();
}

}  // namespace shellmatch
