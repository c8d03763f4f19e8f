#include "python/bindings/observer.h"

#include "base/stop.h"
#include "python/bindings/arrays.h"
#include "python/bindings/computation.h"

namespace shellmatch::python {

namespace py = pybind11;

// False where the function has returned False.
bool PythonObserver::call(const char* kind, const std::string& text, const LevelStart& start, int iteration,
                          double energy, double gradient_norm) {
  stop_if_wanted();
  if (callback_.is_none()) return true;
  bool raised = false, goes_on = true;
  {
    py::gil_scoped_acquire lock;
    try {
      const py::object answer = callback_(kind, text_of(text), start.level, start.substep, start.n_substeps, iteration,
                                          energy, gradient_norm);
      goes_on = answer.ptr() != Py_False;
    } catch (py::error_already_set& error) {
      error.restore();
      stop_with_python_error();
      raised = true;
    }
  }
  if (raised) throw Stopped("stopped by an exception");
  return goes_on;
}

void PythonObserver::note(const std::string& text) {
  notes.push_back(text);
  call("note", text);
}

void PythonObserver::warn(const std::string& text) {
  warnings.push_back(text);
  call("warning", text);
}

void PythonObserver::stage(const std::string& name) { call("stage", name); }

void PythonObserver::trial_iterated() { stop_if_wanted(); }

void PythonObserver::minimisation_started(const LevelStart& start) { call("start", "", start); }

bool PythonObserver::iterated(const LevelStart& start, const IterationRecord& record) {
  return call("step", record.solver, start, record.iteration, record.value, record.l2_gradient_norm);
}

bool PythonObserver::iterated(const IterationRecord& record) { return iterated(LevelStart{}, record); }

void PythonObserver::minimisation_finished(const LevelStart& start, const MinimizerSummary& summary) {
  call("finish", summary.message, start, summary.iterations, summary.final_value, summary.final_gradient_norm);
}

}  // namespace shellmatch::python
