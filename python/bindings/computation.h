#pragma once
/// \file
/// Calls that compute: without the interpreter's lock, one at a time in the process, and stopped by Python's
/// signals.

#include "base/error.h"
#include "base/stop.h"

#include <new>
#include <type_traits>

namespace shellmatch::python {

/// While it lives, the interpreter's lock is released, and this thread has the turn: other threads that want
/// to compute wait. Python is asked for signals while a thread waits, and by the stop question of the
/// parallel loops (base/stop.h), at most every twentieth of a second. May be nested, in a callback of
/// Python's. \pre the interpreter's lock is held where it begins and ends
class Computation {
 public:
  /// \throws pybind11::error_already_set where a signal has raised while this thread waited
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
auto compute(auto&& body) {
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

/// compute(body) of a matching. \throws MemoryError with what needs less memory, where there is not enough
auto compute_matching(auto&& body) {
  try {
    return compute(body);
  } catch (const std::bad_alloc&) {
    throw MemoryError("not enough memory; a lower finest level (levels) needs less");
  }
}

/// Whether this thread is within a Computation: it was called back.
bool is_called_back();

}  // namespace shellmatch::python
