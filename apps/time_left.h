#pragma once
/// \file
/// A guess of how long a cascade goes on.

#include <optional>
#include <string>

namespace shellmatch {

/// Assumes that a level costs as much per node as the one before it, and that the nodes go on growing by the
/// same factor. Times are in seconds on any one clock.
class TimeLeft {
 public:
  explicit TimeLeft(int max_level) : max_level_(max_level) {}

  /// A minimisation begins; a new level or another substep of the same.
  void started(int level, int substep, int n_substeps, double n_nodes, double now);

  /// Seconds left for this and all further levels; nothing on the first level, where there is nothing to go by.
  std::optional<double> at(double now) const;

 private:
  int max_level_;
  int level_ = -1, substep_ = 1, n_substeps_ = 1;
  double n_nodes_ = 0, level_start_ = 0;
  double growth_ = 3;                       // of the nodes; surfaces in space give about 4, curves 2
  std::optional<double> seconds_per_node_;  // of the level before
};

/// "about 40 s left", "about 3 min left", "about 2 h 10 min left".
std::string time_left_text(double seconds);

}  // namespace shellmatch
