#pragma once
/// \file
/// Calls that compute: without the interpreter's lock, one at a time in the process, and stopped by Python's
/// signals.

#include "base/stop.h"

#include <type_traits>

namespace shellmatch::python {

/// While it lives, the interpreter's lock is released, and this thread has the turn: other threads that want
/// to compute wait. The stop question of the parallel loops (base/stop.h) asks Python for signals, at most
/// every twentieth of a second. May be nested, in a callback of Python's. \pre the interpreter's lock is held
/// where it begins and ends
class Computation {
 public:
  Computation();
  ~Computation();
  Computation(const Computation&) = delete;
  Computation& operator=(const Computation&) = delete;

 private:
  void* thread_state_;
};

/// Keeps the Python error that is set, and makes the loops stop. \pre the interpreter's lock is held
void stop_with_python_error();

/// Throws the Python error that stop_with_python_error() has kept, if there is one. \pre the interpreter's
/// lock is held
void throw_kept_error();

/// body() within a Computation. Where Python code that it called has raised, that error goes on from here,
/// whatever became of body().
template <class Body>
auto compute(Body&& body) {
  try {
    if constexpr (std::is_void_v<decltype(body())>) {
      {
        Computation computation;
        body();
      }
      throw_kept_error();
    } else {
      auto result = [&] {
        Computation computation;
        return body();
      }();
      throw_kept_error();
      return result;
    }
  } catch (...) {  // of a worker, beside what ended the others
    throw_kept_error();
    throw;
  }
}

/// Whether this thread is within a Computation: it was called back.
bool is_called_back();

}  // namespace shellmatch::python
