#include "base/stop.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

namespace shellmatch {

namespace {
std::atomic<StopCause (*)()> asked = nullptr;

// Of all threads; few, as each takes long.
std::mutex activities_mutex;
struct Begun {
  std::size_t id;
  const char* name;
  std::chrono::steady_clock::time_point begin;
  double n_steps, n_done = 0, n_present = 0;  // steps; those that are being done
};
std::vector<Begun> activities;  // in the order of their begin
std::size_t n_activities = 0;   // begun so far
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
  activities.push_back({id_, name, std::chrono::steady_clock::now(), static_cast<double>(n_steps)});
}

Activity::~Activity() {
  const std::lock_guard lock(activities_mutex);
  std::erase_if(activities, [&](const Begun& a) { return a.id == id_; });
}

void Activity::done(std::size_t n) {
  stop_if_wanted();
  if (n_steps_ == 0) return;
  const std::lock_guard lock(activities_mutex);
  for (Begun& a : activities)
    if (a.id == id_) a.n_done = static_cast<double>(n);
}

void Activity::next(std::size_t n) {
  stop_if_wanted();
  const std::lock_guard lock(activities_mutex);
  for (Begun& a : activities) {
    if (a.id != id_) continue;
    a.n_done += a.n_present;
    a.n_present = static_cast<double>(n);
  }
}

std::optional<ActivityState> last_activity() {
  const std::lock_guard lock(activities_mutex);
  if (activities.empty()) return std::nullopt;
  ActivityState state{activities.back().name, 0, activities.back().begin};
  for (auto a = activities.rbegin(); a != activities.rend(); ++a) {
    if (a->n_steps == 0) continue;
    state.share = std::min(1.0, (a->n_done + a->n_present * state.share) / a->n_steps);
    state.begin = a->begin;
  }
  return state;
}

}  // namespace shellmatch
