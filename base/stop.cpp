#include "base/stop.h"

#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {
std::atomic<StopCause (*)()> asked = nullptr;

// Of all threads; few, as each takes long.
std::mutex activities_mutex;
std::vector<std::pair<std::size_t, ActivityState>> activities;  // by number
std::size_t n_activities = 0;                                   // begun so far
}  // namespace

void stop_loops_when(StopCause (*question)()) { asked = question; }

void stop_if_wanted() {
  StopCause (*const question)() = asked.load(std::memory_order_relaxed);
  if (question == nullptr) return;
  if (const StopCause cause = question(); cause != StopCause::none)
    throw Stopped("stopped; nothing was written", cause);
}

Activity::Activity(const char* name, std::size_t n_steps) : n_steps_(n_steps) {
  stop_if_wanted();
  const std::lock_guard lock(activities_mutex);
  id_ = n_activities++;
  activities.emplace_back(id_, ActivityState{name, 0, std::chrono::steady_clock::now()});
}

Activity::~Activity() {
  const std::lock_guard lock(activities_mutex);
  std::erase_if(activities, [&](const auto& a) { return a.first == id_; });
}

void Activity::done(std::size_t n) {
  stop_if_wanted();
  if (n_steps_ == 0) return;
  const std::lock_guard lock(activities_mutex);
  for (auto& [id, state] : activities)
    if (id == id_) state.share = static_cast<double>(n) / static_cast<double>(n_steps_);
}

std::optional<ActivityState> last_activity() {
  const std::lock_guard lock(activities_mutex);
  if (activities.empty()) return std::nullopt;
  return activities.back().second;
}

}  // namespace shellmatch
