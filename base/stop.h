#pragma once
/// \file
/// Cancellation of long computations, and what they do meanwhile. The parallel loops (base/parallel.h) and the longer
/// of the serial ones ask a question and throw an exception once the answer is a cause to stop.

#include <chrono>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace shellmatch {

/// Why a computation is to stop.
enum class StopCause {
  none,
  request,       ///< of the user or the system, by a signal
  time_limit,    ///< the time that the user has given is over
  memory_limit,  ///< more memory is needed than the user has given
};

/// The computation was cancelled. This is not a failure.
class Stopped : public std::runtime_error {
 public:
  explicit Stopped(const std::string& text, StopCause cause = StopCause::request)
      : std::runtime_error(text), cause_(cause) {}
  StopCause cause() const { return cause_; }

 private:
  StopCause cause_;
};

/// Sets the question that every parallel loop asks before each of its chunks, on any thread; null for none.
void stop_loops_when(StopCause (*question)());

/// Throws Stopped if there is a cause to stop. Its text says that nothing was written.
void stop_if_wanted();

/// Asks at the first and then at every 1024th call, for what takes less than a millisecond and is done millions of
/// times.
class StopCheck {
 public:
  void operator()() {
    if (n_calls_++ % 1024 == 0) stop_if_wanted();
  }

 private:
  unsigned n_calls_ = 0;
};

/// Says what a long computation does, from its construction to its end, to those who show it
/// (apps/terminal/progress.h).
class Activity {
 public:
  /// Asks whether to stop. \param name in words for the user, a literal \param n_steps of work, where they can be
  /// counted
  explicit Activity(const char* name, std::size_t n_steps = 0);
  ~Activity();
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;

  /// `n` steps are done since the beginning. Asks whether to stop.
  void done(std::size_t n);

  /// What went before is done, and the next `n` steps begin: activities that they begin tell how much of them is done.
  /// Asks whether to stop.
  void next(std::size_t n = 1);

 private:
  std::size_t n_steps_;
  std::size_t id_;
};

/// What is done at the moment.
struct ActivityState {
  std::string name;  ///< of the activity that was begun last, of all threads
  /// How much of the outermost activity is done whose steps are counted, those within it taken along; 0 without any.
  double share = 0;
  std::chrono::steady_clock::time_point begin;  ///< of that one
};

/// Nothing where there is no activity.
std::optional<ActivityState> last_activity();

}  // namespace shellmatch
