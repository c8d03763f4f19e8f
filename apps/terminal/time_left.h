#pragma once
/// \file
/// How long the rest of a cascade may take, and a sign of life while nothing else is reported.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
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

/// Assumes that the time per node is that of the previous level, and that the number of nodes grows by the same factor
/// from level to level. Times are in seconds of any one clock.
class TimeLeft {
 public:
  explicit TimeLeft(int max_level) : max_level_(max_level) {}

  /// A minimisation begins, of a new level or of another substep of the same level.
  void started(int level, int substep, int n_substeps, double n_nodes, double now);

  /// Estimated seconds until the end of the last level; nothing on the first level, for which there are no
  /// measurements.
  std::optional<double> at(double now) const;

 private:
  int max_level_;
  int level_ = -1, substep_ = 1, n_substeps_ = 1;
  double n_nodes_ = 0, level_start_ = 0;
  double growth_ = 3;                       // factor of the number of nodes; about 4 for surfaces, 2 for curves
  std::optional<double> seconds_per_node_;  // of the previous level
};

/// The estimate as text: "about 40 s left", "about 3 min left", "about 2 h 10 min left".
std::string time_left_text(double seconds);

}  // namespace shellmatch
