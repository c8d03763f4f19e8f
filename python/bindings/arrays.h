#pragma once
/// \file
/// Between numpy's arrays and Python's texts, and the library's. Shapes and types of arrays are checked in Python.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "base/types.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch::python {

/// Bytes that are no UTF-8 become \xNN, so that the text can be printed. \pre the interpreter's lock is held
pybind11::str text_of(std::string_view bytes);

/// The same of several, as a list.
pybind11::list texts_of(const std::vector<std::string>& texts);

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// Points from rows of an array. \throws InputError where it has not Dim columns, or where a coordinate is
/// not finite: `name`, row
template <int Dim>
std::vector<Vec<Dim>> points_of(const Doubles& rows, const std::string& name);

/// Polygons from rows of indices. \throws InputError for indices below 0 or from n_vertices on
std::vector<std::vector<Index>> polygons_of(const Integers& rows, std::size_t n_vertices, const std::string& name);

/// An array of the same memory that cannot be written to, and that keeps `owner` alive. \param shape of the
/// array
py::array_t<double> view_of(const double* data, std::vector<py::ssize_t> shape, py::handle owner);

/// An array that owns the values. \param shape their number in all, by axes
template <class T>
py::array_t<T> array_of(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  T* const data = kept->data();
  const py::capsule owner(kept.release(), [](void* all) { delete static_cast<std::vector<T>*>(all); });
  return py::array_t<T>(std::move(shape), data, owner);
}

}  // namespace shellmatch::python
