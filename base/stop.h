#pragma once
/// \file
/// Cancellation of long computations. The parallel loops (base/parallel.h), which all long computations use,
/// ask a question and throw an exception once the answer is a cause to stop.

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
  explicit Stopped(const std::string& text, StopCause cause = StopCause::request) : std::runtime_error(text), cause_(cause) {}
  StopCause cause() const { return cause_; }

 private:
  StopCause cause_;
};

/// Sets the question that every parallel loop asks before each of its chunks, on any thread; null for none.
void stop_loops_when(StopCause (*question)());

/// Throws Stopped if there is a cause to stop. Its text says that nothing was written.
void stop_if_wanted();

}  // namespace shellmatch
