#pragma once
/// \file
/// Cancellation of long computations. The parallel loops (base/parallel.h), which all long computations use,
/// poll a predicate and throw an exception once it holds.

#include <stdexcept>

namespace shellmatch {

/// The computation was cancelled on request. This is not a failure.
class Stopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Sets the predicate that every parallel loop calls before each of its chunks, on any thread; null for none.
void stop_loops_when(bool (*wanted)());

/// Throws Stopped if the predicate holds. Its text says that nothing was written.
void stop_if_wanted();

}  // namespace shellmatch
