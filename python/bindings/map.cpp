#include "python/bindings/map.h"

#include "base/error.h"
#include "base/parallel.h"
#include "matching/map_file/deformation_file.h"
#include "python/bindings/arrays.h"
#include "python/bindings/computation.h"

#include <pybind11/stl.h>

#include <limits>
#include <utility>

namespace shellmatch::python {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The same of a file, with the interpreter's lock given away.
template <int Dim>
Map read_map(const std::string& path) {
  return compute([&] { return Map(std::make_shared<const Deformation<Dim>>(read_deformation<Dim>(path))); });
}

py::array_t<double> matrix_of(const Mat<4>& m) {
  py::array_t<double> array({4, 4});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) array.mutable_at(i, j) = m(i, j);
  return array;
}

template <int Dim>
void refuse_bent(const Deformation<Dim>& map, const char* what) {
  if (map.bend)
    throw_input_error(
        "{}: this run has bent the surface of the reference first, and its map is one of the surface, not of space; "
        "match again with align.bend: never",
        what);
}

// The pose and the placement as one matrix, padded where the map is one of the plane.
template <int Dim>
Mat<4> to_unit_domain(const Deformation<Dim>& map) {
  refuse_bent(map, "to_unit_domain");
  Mat<4> m = Mat<4>::Identity();
  const Vec<Dim> origin = map.to_unit_domain(Vec<Dim>::Zero());
  m.topLeftCorner<Dim, Dim>() = map.placement.scale * map.pose.scale * map.placement.rotation * map.pose.rotation;
  m.topRightCorner<Dim, 1>() = origin;
  return m;
}

}  // namespace

py::array_t<double> Map::carry(const py::array& points, Toward toward) const {
  return std::visit(
      [&]<int Dim>(const std::shared_ptr<MapOf<Dim>>& map) {
        const std::vector<Vec<Dim>> from = points_of<Dim>(Doubles(points), "points");
        std::vector<double> to(from.size() * Dim);
        compute([&] {
          const PointMap<Dim>& carries = map->toward(toward);
          parallel_for(from.size(), [&](std::size_t i) {
            const Vec<Dim> y = carries(from[i]).value_or(Vec<Dim>::Constant(nan));
            for (std::size_t k = 0; k < Dim; ++k) to[i * Dim + k] = y[static_cast<int>(k)];
          });
        });
        return array_of(std::move(to), {static_cast<py::ssize_t>(from.size()), Dim});
      },
      map_);
}

py::array_t<double> Map::jacobian(const py::array& points) const {
  return std::visit(
      [&]<int Dim>(const std::shared_ptr<MapOf<Dim>>& map) {
        const std::vector<Vec<Dim>> from = points_of<Dim>(Doubles(points), "points");
        std::vector<double> to(from.size() * Dim * Dim);
        refuse_bent(map->deformation(), "jacobian");
        compute([&] {
          const PointMap<Dim>& carries = map->toward(Toward::template_shape);
          parallel_for(from.size(), [&](std::size_t i) {
            const Mat<Dim> m = carries.jacobian(from[i]).value_or(Mat<Dim>::Constant(nan));
            for (int row = 0; row < Dim; ++row)
              for (int column = 0; column < Dim; ++column)
                to[i * Dim * Dim + static_cast<std::size_t>(row * Dim + column)] = m(row, column);
          });
        });
        return array_of(std::move(to), {static_cast<py::ssize_t>(from.size()), Dim, Dim});
      },
      map_);
}

void bind_map(py::module_& module) {
  py::class_<Map>(module, "Map", "A map of the plane or of space; shellmatch.Map shows it.")
      .def_property_readonly("dimension", &Map::dimension)
      .def(
          "apply", [](const Map& map, const py::array& points) { return map.carry(points, Toward::template_shape); },
          py::arg("points"))
      .def(
          "inverse", [](const Map& map, const py::array& points) { return map.carry(points, Toward::reference); },
          py::arg("points"))
      .def("jacobian", &Map::jacobian, py::arg("points"))
      .def_property_readonly("is_backward",
                             [](const Map& map) {
                               return std::visit([](const auto& m) { return m->deformation().is_backward; }, map.map_);
                             })
      .def_property_readonly("is_bent",
                             [](const Map& map) {
                               return std::visit([](const auto& m) { return m->deformation().bend != nullptr; },
                                                 map.map_);
                             })
      .def_property_readonly("to_unit_domain", [](const Map& map) {
        return matrix_of(std::visit([](const auto& m) { return to_unit_domain(m->deformation()); }, map.map_));
      });
  module.def(
      "load_map",
      [](const std::string& path) { return deformation_dimension(path) == 2 ? read_map<2>(path) : read_map<3>(path); },
      py::arg("path"));
}

}  // namespace shellmatch::python
