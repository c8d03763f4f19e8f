#pragma once
/// \file
/// A sign of life while nothing else is reported.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace shellmatch {

/// Calls a function about once a second, in a thread of its own, until it is destroyed.
class Heartbeat {
 public:
  explicit Heartbeat(std::function<void()> beat);
  ~Heartbeat();
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace shellmatch
