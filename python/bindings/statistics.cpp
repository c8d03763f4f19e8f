// Statistics of corresponding points: functions of arrays, which shellmatch.ShapeModel and its neighbours call.

#include "base/error.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/computation.h"
#include "geometry/statistics/group_difference.h"
#include "geometry/statistics/model_curves.h"
#include "geometry/statistics/procrustes.h"
#include "geometry/statistics/products.h"
#include "geometry/statistics/shape_model.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch::python {

namespace {

// An array of (n, V, d) is, in memory, a matrix of a column for each shape.
PointSets sets_of(const Doubles& points) {
  if (points.ndim() != 3 || (points.shape(2) != 2 && points.shape(2) != 3))
    throw_input_error("points: expected an array of three axes, (shapes, points, 2 or 3)");
  return {static_cast<int>(points.shape(2)),
          Eigen::Map<const Eigen::MatrixXd>(points.data(), points.shape(1) * points.shape(2), points.shape(0))};
}

Eigen::VectorXd vector_of(const Doubles& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

// Rows of an array as columns of a matrix, in the array's memory.
Eigen::Map<const Eigen::MatrixXd> columns_of(const Doubles& rows, py::ssize_t row_length, const char* name) {
  if (rows.ndim() < 2 || rows.size() != rows.shape(0) * row_length)
    throw_input_error("{}: rows of {} numbers are expected", name, row_length);
  return {rows.data(), row_length, rows.shape(0)};
}

/// An array that owns the matrix, column after column.
py::array_t<double> array_from(Eigen::MatrixXd matrix, std::vector<py::ssize_t> shape) {
  auto kept = std::make_unique<Eigen::MatrixXd>(std::move(matrix));
  const double* const data = kept->data();
  const py::capsule owner(kept.release(), [](void* all) { delete static_cast<Eigen::MatrixXd*>(all); });
  return py::array_t<double>(std::move(shape), data, owner);
}

py::array_t<double> array_from(const Eigen::VectorXd& vector) {
  return array_from(Eigen::MatrixXd(vector), {vector.size()});
}

// Of shapes in columns.
py::array_t<double> shapes_from(Eigen::MatrixXd columns, int dimension) {
  const py::ssize_t n = columns.cols(), n_points = columns.rows() / dimension;
  return array_from(std::move(columns), {n, n_points, dimension});
}

py::array_t<double> points_from(const Eigen::VectorXd& coordinates, int dimension) {
  return array_from(Eigen::MatrixXd(coordinates), {coordinates.size() / dimension, dimension});
}

py::array_t<double> rows_from(const Eigen::MatrixXd& matrix) {
  return array_from(matrix.transpose(), {matrix.rows(), matrix.cols()});
}

ProcrustesKind kind_of(const std::string& name) {
  for (const auto& [kind, known] : EnumNames<ProcrustesKind>::names)
    if (known == name) return kind;
  throw_input_error("procrustes=\"{}\": expected none, rigid or similarity", name);
}

template <int Dim>
Eigen::VectorXd mean_area_weights(const PointSets& sets, const std::vector<std::vector<Index>>& polygons) {
  std::vector<std::array<Index, Dim>> facets(polygons.size());
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    if (polygons[f].size() != Dim)
      throw_input_error("faces: row {} has {} points; {} are expected", f, polygons[f].size(), Dim);
    std::copy(polygons[f].begin(), polygons[f].end(), facets[f].begin());
  }
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(sets.n_points());
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i) sum += area_weights<Dim>(sets.coordinates.col(i), facets);
  return sum / static_cast<double>(sets.n_sets());
}

py::array_t<double> weights_by_area(const Doubles& points, const Integers& faces) {
  const PointSets sets = sets_of(points);
  const auto polygons = polygons_of(faces, static_cast<std::size_t>(sets.n_points()), "faces");
  return array_from(compute([&] {
    return sets.dimension == 2 ? mean_area_weights<2>(sets, polygons) : mean_area_weights<3>(sets, polygons);
  }));
}

// In the frame of the first shape.
AlignedSets align_to_first(PointSets sets, const Eigen::VectorXd& weights, const std::string& kind) {
  check_point_sets(sets, weights);
  const Eigen::VectorXd start = sets.coordinates.col(0);
  return procrustes(std::move(sets), weights, start, kind_of(kind));
}

py::tuple align(const Doubles& points, const Doubles& weights, const Doubles& start, const std::string& kind) {
  PointSets sets = sets_of(points);
  const Eigen::VectorXd of_points = vector_of(weights), from = vector_of(start);
  AlignedSets aligned = compute([&] { return procrustes(std::move(sets), of_points, from, kind_of(kind)); });
  const int dimension = aligned.sets.dimension;
  return py::make_tuple(shapes_from(std::move(aligned.sets.coordinates), dimension),
                        points_from(aligned.mean, dimension), aligned.n_iterations, aligned.enlargement);
}

py::dict fit(const Doubles& points, const Doubles& weights, const std::string& kind, int max_modes) {
  PointSets sets = sets_of(points);
  const Eigen::VectorXd of_points = vector_of(weights);
  double enlargement = 1;
  ShapeModel model = compute([&] {
    const AlignedSets aligned = align_to_first(std::move(sets), of_points, kind);
    enlargement = aligned.enlargement;
    return fit_shape_model(aligned.sets, of_points, max_modes);
  });
  py::dict result;
  result["mean"] = points_from(model.mean, model.dimension);
  result["modes"] = shapes_from(std::move(model.modes), model.dimension);
  result["variances"] = array_from(model.variances);
  result["scores"] = rows_from(model.scores);
  result["total_variance"] = model.total_variance;
  result["enlargement"] = enlargement;
  return result;
}

py::array_t<double> scores_of_shapes(const Doubles& points, const Doubles& weights, const Doubles& mean,
                                     const Doubles& modes, const std::string& kind, double enlargement) {
  PointSets sets = sets_of(points);
  const Eigen::VectorXd of_points = vector_of(weights), centre = vector_of(mean);
  const auto columns = columns_of(modes, centre.size(), "modes");
  return rows_from(compute([&]() -> Eigen::MatrixXd {
    const PointSets aligned = align_to_mean(std::move(sets), of_points, centre, kind_of(kind), enlargement);
    return inner_products({aligned.coordinates, &centre}, {columns}, of_points);
  }));
}

py::array_t<double> shapes_of_scores(const Doubles& scores, const Doubles& mean, const Doubles& modes) {
  const Eigen::VectorXd centre = vector_of(mean);
  const auto columns = columns_of(modes, centre.size(), "modes");
  const Eigen::MatrixXd coefficients = columns_of(scores, columns.cols(), "scores");
  Eigen::MatrixXd shapes = compute([&] {
    Eigen::MatrixXd sums = combinations({columns}, coefficients);
    sums.colwise() += centre;
    return sums;
  });
  return shapes_from(std::move(shapes), static_cast<int>(mean.shape(mean.ndim() - 1)));
}

py::array_t<double> sample_scores(const Doubles& variances, int n, std::uint64_t seed) {
  const Eigen::VectorXd of_modes = vector_of(variances);
  return rows_from(compute([&] { return normal_scores(of_modes, n, seed); }));
}

py::dict curves(const Doubles& variances, const Doubles& scores, double total_variance, int n_samples,
                std::uint64_t seed) {
  ShapeModel model;  // its points are not needed
  model.variances = vector_of(variances);
  model.scores = columns_of(scores, variances.size(), "scores").transpose();
  model.total_variance = total_variance;
  const ModelCurves result = compute([&] { return model_curves(model, n_samples, seed); });
  py::dict arrays;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    arrays[name] = array_of(values, {std::ssize(values)});
  };
  add("compactness", result.compactness);
  add("generalisation", result.generalisation);
  add("generalisation_error", result.generalisation_error);
  add("specificity", result.specificity);
  add("specificity_error", result.specificity_error);
  return arrays;
}

py::dict compare_groups(const Doubles& points, const Doubles& weights, const std::string& kind,
                        const std::vector<bool>& is_b, int n_permutations, std::uint64_t seed) {
  PointSets sets = sets_of(points);
  const Eigen::VectorXd of_points = vector_of(weights);
  const int dimension = sets.dimension;
  const GroupDifference result = compute([&] {
    const AlignedSets aligned = align_to_first(std::move(sets), of_points, kind);
    return group_difference(aligned.sets, of_points, {is_b.begin(), is_b.end()}, n_permutations, seed);
  });
  py::dict values;
  values["n_a"] = result.n_a;
  values["n_b"] = result.n_b;
  values["n_permutations"] = result.n_permutations;
  values["all_permutations"] = result.all_permutations;
  values["difference"] = points_from(result.difference, dimension);
  values["statistic"] = array_from(result.statistic);
  values["p"] = array_from(result.p);
  values["p_corrected"] = array_from(result.p_corrected);
  values["q"] = array_from(result.q);
  values["distance"] = result.distance;
  values["global_p"] = result.global_p;
  return values;
}

}  // namespace

void bind_statistics(py::module_& module) {
  module.def("area_weights", weights_by_area, py::arg("points"), py::arg("faces"));
  module.def("procrustes", align, py::arg("points"), py::arg("weights"), py::arg("start"), py::arg("kind"));
  module.def("fit_shape_model", fit, py::arg("points"), py::arg("weights"), py::arg("kind"), py::arg("max_modes"));
  module.def("scores_of_shapes", scores_of_shapes, py::arg("points"), py::arg("weights"), py::arg("mean"),
             py::arg("modes"), py::arg("kind"), py::arg("enlargement"));
  module.def("shapes_of_scores", shapes_of_scores, py::arg("scores"), py::arg("mean"), py::arg("modes"));
  module.def("sample_scores", sample_scores, py::arg("variances"), py::arg("n"), py::arg("seed"));
  module.def("model_curves", curves, py::arg("variances"), py::arg("scores"), py::arg("total_variance"),
             py::arg("n_samples"), py::arg("seed"));
  module.def("group_difference", compare_groups, py::arg("points"), py::arg("weights"), py::arg("kind"),
             py::arg("in_b"), py::arg("n_permutations"), py::arg("seed"));
}

}  // namespace shellmatch::python
