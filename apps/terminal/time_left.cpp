#include "apps/terminal/time_left.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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

void TimeLeft::started(int level, int substep, int n_substeps, double n_nodes, double now) {
  if (level != level_) {
    if (level_ >= 0 && n_nodes_ > 0) {
      seconds_per_node_ = (now - level_start_) / n_nodes_;
      growth_ = n_nodes / n_nodes_;
    }
    level_ = level;
    n_nodes_ = n_nodes;
    level_start_ = now;
  }
  substep_ = substep;
  n_substeps_ = n_substeps;
}

std::optional<double> TimeLeft::at(double now) const {
  if (!seconds_per_node_) return std::nullopt;
  const double elapsed = now - level_start_;
  // If the level takes longer than estimated, the share of its substeps is used; the present one counts as half done.
  const double done = (substep_ - 0.5) / n_substeps_;
  const double foreseen = *seconds_per_node_ * n_nodes_;
  const double level_total = elapsed < foreseen ? foreseen : std::max(foreseen, elapsed / done);
  double sum = level_total - elapsed, next = level_total;
  for (int level = level_ + 1; level <= max_level_; ++level) {
    next *= growth_;
    sum += next;
  }
  return sum;
}

std::string time_left_text(double seconds) {
  if (seconds < 99.5) return fmt::format("about {} s left", std::max(1L, std::lround(seconds)));
  const long minutes = std::lround(seconds / 60);
  if (minutes < 100) return fmt::format("about {} min left", minutes);
  return fmt::format("about {} h {:02} min left", minutes / 60, minutes % 60);
}

}  // namespace shellmatch
