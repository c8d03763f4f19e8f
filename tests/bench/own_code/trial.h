#pragma once
/// \file
/// A piece of work in a process of its own: its seconds, its memory, and whether it survives.

#include <array>
#include <functional>

namespace shellmatch::own_code {

struct Trial {
  bool returned = false;          ///< else it crashed, called exit() or was out of time
  double seconds[2] = {};         ///< CPU seconds that the work states itself, of building and of asking for example
  double megabytes = 0;           ///< rise of the largest resident memory
  std::array<double, 4> found{};  ///< whatever the work returns
};

/// CPU seconds of this process so far, of all threads.
double cpu_seconds();

/// Runs the work in a child process. \throws std::runtime_error if there can be none
Trial run_trial(const std::function<void(Trial&)>& work, unsigned limit_seconds = 300);

}  // namespace shellmatch::own_code
