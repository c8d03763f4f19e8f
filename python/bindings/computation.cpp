#include "python/bindings/computation.h"

#include "base/stop.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <mutex>

namespace shellmatch::python {

namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

// A thread that waits for the turn holds no lock of the interpreter's, so that who has the turn can always
// call Python.
std::recursive_timed_mutex turn;
int depth = 0;  // of nested computations; belongs to whoever has the turn
thread_local bool has_turn = false;
std::atomic<bool> stop_wanted = false;  // read by all threads of the loops
Clock::time_point last_check;
struct KeptError {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
};
thread_local KeptError kept;  // of stop_with_python_error()

constexpr auto interval = std::chrono::milliseconds(50);  // between questions for signals

// Asked before each chunk of each loop, by all its threads. Signals are Python's business, so the thread that
// was called asks it.
StopCause question() {
  if (stop_wanted.load(std::memory_order_relaxed)) return StopCause::request;
  if (!has_turn) return StopCause::none;
  const Clock::time_point now = Clock::now();
  if (now - last_check < interval) return StopCause::none;
  py::gil_scoped_acquire lock;
  const bool raised = PyErr_CheckSignals() != 0;
  last_check = Clock::now();
  if (raised) stop_with_python_error();
  return raised ? StopCause::request : StopCause::none;
}

}  // namespace

Computation::Computation() : thread_state_(PyEval_SaveThread()) {
  while (!turn.try_lock_for(interval)) {
    PyEval_RestoreThread(static_cast<PyThreadState*>(thread_state_));
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    thread_state_ = PyEval_SaveThread();
  }
  has_turn = true;
  if (depth++ > 0) return;
  stop_wanted = false;
  last_check = Clock::now();
  stop_loops_when(question);
}

Computation::~Computation() {
  if (--depth == 0) {
    stop_loops_when(nullptr);
    has_turn = false;
  }
  turn.unlock();
  PyEval_RestoreThread(static_cast<PyThreadState*>(thread_state_));
}

void stop_with_python_error() {
  if (kept.type != nullptr) {  // the first one counts
    PyErr_Clear();
  } else {
    PyErr_Fetch(&kept.type, &kept.value, &kept.trace);
  }
  stop_wanted = true;
}

void throw_kept_error() {
  if (kept.type == nullptr) return;
  PyErr_Restore(kept.type, kept.value, kept.trace);
  kept = {};
  throw py::error_already_set();
}

bool is_called_back() { return has_turn; }

}  // namespace shellmatch::python
