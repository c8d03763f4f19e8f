// The class ShapeInput: a shape as a name, as arrays or as voxels.

#include "python/bindings/inputs.h"

#include "base/error.h"
#include "geometry/volume/make_volume.h"
#include "matching/experiment/yaml_options.h"
#include "matching/pairs/landmark_file.h"
#include "python/bindings/arrays.h"
#include "python/bindings/computation.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
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

ExperimentOptions options_of(const std::string& config, const OptionTexts& texts,
                             const std::array<ShapeInput, 2>& shapes) {
  std::vector<Override> overrides;
  for (const auto& [key, value, origin] : texts) {
    if (key == "input.reference" || key == "input.template")
      throw_input_error("{}: {}: the shapes are arguments of their own", origin, key);
    overrides.push_back({key, value, origin});
  }
  ExperimentOptions options = config.empty() ? make_experiment(overrides) : read_experiment(config, overrides);
  options.input.reference = shapes[0].contents.index() == 0 ? shapes[0].name : "";
  options.input.template_file = shapes[1].contents.index() == 0 ? shapes[1].name : "";
  check_experiment(options);
  if (!options.start.map.empty() || !options.start.images.empty())
    throw_input_error("start.{}: is for the command line, whose runs have files; leave it out",
                      options.start.map.empty() ? "images" : "map");
  return options;
}

GivenLandmarks landmarks_from(const py::object& given) {
  GivenLandmarks landmarks;
  if (given.is_none()) return landmarks;
  const auto parts = given.cast<py::tuple>();
  if (parts.size() != 3) throw_input_error("landmarks: expected points of both shapes and weights");
  for (std::size_t side = 0; side < 2; ++side) {
    GivenPoints& points = landmarks.sides[side];
    const auto array = parts[side].cast<py::array>();
    if (array.ndim() == 1) {
      const auto vertices = Integers(array);
      points.vertices.assign(vertices.data(), vertices.data() + vertices.size());
    } else {
      const auto positions = Doubles(array);
      if (positions.ndim() != 2 || positions.shape(1) == 0)
        throw_input_error("landmarks: expected rows of coordinates, or numbers of vertices");
      points.positions.assign(positions.data(), positions.data() + positions.size());
      points.n_columns = static_cast<int>(positions.shape(1));
    }
  }
  if (landmarks.sides[0].size() != landmarks.sides[1].size())
    throw_input_error("landmarks: {} points of the reference and {} of the template; expected as many of both",
                      landmarks.sides[0].size(), landmarks.sides[1].size());
  if (!py::object(parts[2]).is_none()) {
    const auto weights = Doubles(parts[2].cast<py::array>());
    landmarks.weights.assign(weights.data(), weights.data() + weights.size());
    if (landmarks.weights.size() != landmarks.sides[0].size())
      throw_input_error("landmarks: {} weights for {} landmarks", landmarks.weights.size(), landmarks.sides[0].size());
    for (const double w : landmarks.weights)
      if (!(w > 0 && std::isfinite(w))) throw_input_error("landmarks: a weight is {:g}; expected a number > 0", w);
  }
  return landmarks;
}

namespace {

template <int Dim>
Vec<Dim> point_of(const GivenPoints& points, std::size_t i, const OriginalShape<Dim>& shape, Space own,
                  const char* which) {
  if (points.n_columns == 0) {
    const std::int64_t v = points.vertices[i];
    if (v < 0 || v >= static_cast<std::int64_t>(shape.vertices.size()))
      throw_input_error("landmarks: number {} names vertex {} of the {}, which has vertices 0 to {}", i, v, which,
                        std::ssize(shape.vertices) - 1);
    return shape.vertices[static_cast<std::size_t>(v)];
  }
  if (points.n_columns != Dim)
    throw_input_error("landmarks: {} coordinates for points of the {}, which has {}", points.n_columns, which, Dim);
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = points.positions[i * Dim + static_cast<std::size_t>(k)];
  if constexpr (Dim == 3) return in_space(x, own, shape.space);
  return shape.frame(x);
}

}  // namespace

void check_all_but_template(const ShapeInput& reference, const OptionTexts& texts, const std::string& config,
                            const py::object& landmarks) {
  const GivenLandmarks given = landmarks_from(landmarks);
  compute([&] {
    const ExperimentOptions options = options_of(config, texts, {reference, reference});
    std::visit(
        [&]<int Dim>(const Shape<Dim>& shape) {
          for (std::size_t i = 0; i < given.sides[0].size(); ++i)
            point_of(given.sides[0], i, shape.original, shape.original.space, "reference");
        },
        open_shape(reference, options.input.close));
  });
}

template <int Dim>
std::vector<Landmark<Dim>> landmarks_of(const GivenLandmarks& given, const ExperimentOptions& options,
                                        const ShapePair<Dim>& shapes, Observer& observer) {
  std::vector<std::string> notes;
  std::vector<Landmark<Dim>> landmarks =
      read_landmarks<Dim>(options.landmarks, shapes.reference.original.vertices,
                          shapes.template_shape.original.vertices, landmark_spaces(shapes), &notes);
  for (const std::string& note : notes) observer.note(note);
  const LandmarkSpaces spaces = landmark_spaces(shapes);
  for (std::size_t i = 0; i < given.sides[0].size(); ++i) {
    Landmark<Dim> landmark;
    landmark.name = fmt::format("{}", i);
    landmark.on_reference = point_of(given.sides[0], i, shapes.reference.original, spaces.reference_file, "reference");
    landmark.on_template =
        point_of(given.sides[1], i, shapes.template_shape.original, shapes.template_shape.original.space, "template");
    if (!given.weights.empty()) landmark.weight = given.weights[i];
    landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

SHELLMATCH_2D_3D(landmarks_of);

}  // namespace shellmatch::python
