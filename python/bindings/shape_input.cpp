// The class ShapeInput: a shape as a name, as arrays or as voxels.

#include "base/error.h"
#include "geometry/volume/make_volume.h"
#include "python/bindings/arrays.h"
#include "python/bindings/inputs.h"
#include "python/bindings/text.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace shellmatch::python {

namespace {

ShapeInput file(const std::string& name) {
  if (name.empty()) throw_input_error("the name of a file is empty");
  return {name};
}

// Vertices in the order given, in which the result has them, too: also those of no polygon.
template <int Dim>
ShapeInput of_polygons(const std::string& name, const Doubles& vertices, const std::vector<Integers>& polygons) {
  OriginalShape<Dim> shape;
  shape.vertices = points_of<Dim>(vertices, name + " vertices");
  for (const Integers& block : polygons)
    for (std::vector<Index>& polygon :
         polygons_of(block, shape.vertices.size(), name + (Dim == 3 ? " faces" : " rings")))
      shape.polygons.push_back(std::move(polygon));
  if (shape.polygons.empty()) throw_input_error("{}: no {}", name, Dim == 3 ? "faces" : "rings");
  return {name, std::move(shape)};
}

ShapeInput volume(const std::string& name, const py::array_t<float, py::array::f_style | py::array::forcecast>& values,
                  const Doubles& affine, bool is_integer, const std::vector<double>& labels, double above,
                  bool is_lps) {
  if (values.ndim() != 3) throw_input_error("{}: expected an array of three axes", name);
  if (affine.ndim() != 2 || affine.shape(0) != 4 || affine.shape(1) != 4)
    throw_input_error("{}: expected an affine matrix of 4 by 4", name);
  Mat<4> to_space;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) to_space(i, j) = affine.at(i, j);
  VolumePart part;
  part.volume = make_volume(name, {values.shape(0), values.shape(1), values.shape(2)}, to_space,
                            is_lps ? Space::lps : Space::ras, is_integer ? VoxelType::int32 : VoxelType::float32,
                            std::vector<float>(values.data(), values.data() + values.size()));
  part.choice = {labels, above};
  return {name, std::move(part)};
}

}  // namespace

void bind_shape_input(py::module_& module) {
  py::class_<ShapeInput>(
      module, "ShapeInput",
      "A shape as a name, as arrays or as voxels; shellmatch makes it of whatever register() is given.")
      .def_static("file", file, py::arg("name"))
      .def_static("mesh", of_polygons<3>, py::arg("name"), py::arg("vertices"), py::arg("polygons"))
      .def_static("rings", of_polygons<2>, py::arg("name"), py::arg("vertices"), py::arg("rings"))
      .def_static("volume", volume, py::arg("name"), py::arg("values"), py::arg("affine"), py::arg("is_integer"),
                  py::arg("labels"), py::arg("above"), py::arg("is_lps"))
      .def_property_readonly("name", [](const ShapeInput& input) { return text_of(input.name); });
}

}  // namespace shellmatch::python
