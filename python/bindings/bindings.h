#pragma once
/// \file
/// The parts of the module shellmatch._core.

#include <pybind11/pybind11.h>

namespace shellmatch::python {

namespace py = pybind11;

/// Class Match and the function match.
void bind_match(py::module_& module);
/// Class Problem.
void bind_problem(py::module_& module);
/// Functions for shapes with corresponding points.
void bind_statistics(py::module_& module);

}  // namespace shellmatch::python
