#pragma once
/// \file
/// The observer of a run that calls a Python function.

#include "matching/progress/observer.h"

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace shellmatch::python {

/// Keeps what the run says, and calls `callback` (kind, text, level, substep, n_substeps, iteration, energy,
/// gradient_norm), where it is not None. An exception of Python's ends the run (computation.h); False after a
/// step asks the run to end with what it has.
class PythonObserver final : public Observer {
 public:
  explicit PythonObserver(pybind11::object callback) : callback_(std::move(callback)) {}

  void note(const std::string& text) override;
  void warn(const std::string& text) override;
  void stage(const std::string& name) override;
  void trial_iterated() override;
  void minimisation_started(const LevelStart& start) override;
  bool iterated(const LevelStart& start, const IterationRecord& record) override;
  void minimisation_finished(const LevelStart& start, const MinimizerSummary& summary) override;

  /// The same call for a minimisation that belongs to no cascade.
  bool iterated(const IterationRecord& record);

  std::vector<std::string> notes, warnings;

 private:
  bool call(const char* kind, const std::string& text, const LevelStart& start = {}, int iteration = 0,
            double energy = 0, double gradient_norm = 0);

  pybind11::object callback_;
};

}  // namespace shellmatch::python
