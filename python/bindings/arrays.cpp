#include "python/bindings/arrays.h"

#include "base/error.h"

namespace shellmatch::python {

namespace py = pybind11;

py::str text_of(std::string_view bytes) {
  PyObject* const text = PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "backslashreplace");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

py::list texts_of(const std::vector<std::string>& texts) {
  py::list list;
  for (const std::string& text : texts) list.append(text_of(text));
  return list;
}

template <int Dim>
std::vector<Vec<Dim>> points_of(const Doubles& rows, const std::string& name) {
  if (rows.ndim() != 2 || rows.shape(1) != Dim) throw_input_error("{}: expected an array with {} columns", name, Dim);
  const auto values = rows.unchecked<2>();
  std::vector<Vec<Dim>> points(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    for (int k = 0; k < Dim; ++k) points[static_cast<std::size_t>(i)][k] = values(i, k);
    if (!points[static_cast<std::size_t>(i)].allFinite())
      throw_input_error("{}: row {} (counted from 0) is not finite", name, i);
  }
  return points;
}

SHELLMATCH_2D_3D(points_of);

std::vector<std::vector<Index>> polygons_of(const Integers& rows, std::size_t n_vertices, const std::string& name) {
  if (rows.ndim() != 2) throw_input_error("{}: expected an array of two axes", name);
  const auto values = rows.unchecked<2>();
  std::vector<std::vector<Index>> polygons(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    for (py::ssize_t k = 0; k < rows.shape(1); ++k) {
      const std::int64_t v = values(i, k);
      if (v < 0 || v >= static_cast<std::int64_t>(n_vertices))
        throw_input_error("{}: row {} names vertex {}; there are vertices 0 to {}", name, i, v,
                          static_cast<std::int64_t>(n_vertices) - 1);
      polygons[static_cast<std::size_t>(i)].push_back(static_cast<Index>(v));
    }
  return polygons;
}

py::array_t<double> view_of(const double* data, std::vector<py::ssize_t> shape, py::handle owner) {
  py::array_t<double> array(std::move(shape), data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace shellmatch::python
