#pragma once
/// \file
/// A request to stop that reaches into long computations: whoever is asked to stop says so, and the parallel loops
/// (base/parallel.h), which all long work goes through, end with an exception.

#include <stdexcept>

namespace shellmatch {

/// The work was stopped because somebody asked for it; no failure.
class Stopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// From now on every parallel loop asks `wanted` before each of its chunks, on any thread. Null: none asks.
void stop_loops_when(bool (*wanted)());

/// Where a stop is wanted, throws Stopped with a text that says that nothing was written.
void stop_if_wanted();

}  // namespace shellmatch
