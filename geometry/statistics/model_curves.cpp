#include "geometry/statistics/model_curves.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/statistics/leave_one_out.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

std::vector<double> compactness_of(const Eigen::VectorXd& values, std::size_t n_entries) {
  const double total = values.sum();
  std::vector<double> compactness(n_entries, 1);
  double sum = 0;
  for (Eigen::Index k = 0; k < values.size() && total > 0; ++k) {
    sum += values[k];
    compactness[static_cast<std::size_t>(k)] = std::min(sum / total, 1.0);
  }
  return compactness;
}

// Means of the columns and their standard errors; rows are shapes.
void summarise(const Eigen::MatrixXd& distances, std::vector<double>& mean, std::vector<double>& error) {
  const auto n = static_cast<double>(distances.rows());
  mean.clear();
  error.clear();
  for (Eigen::Index k = 0; k < distances.cols(); ++k) {
    stop_if_wanted();
    double sum = 0, squares = 0;
    for (const double d : distances.col(k)) sum += d;
    mean.push_back(sum / n);
    for (const double d : distances.col(k)) squares += (d - mean.back()) * (d - mean.back());
    error.push_back(n > 1 ? std::sqrt(squares / (n - 1) / n) : 0);
  }
}

void add_generalisation(const ShapeModel& model, ModelCurves& curves) {
  const Eigen::Index n = model.scores.rows(), n_modes = model.variances.size();
  const Eigen::VectorXd values = static_cast<double>(n - 1) * model.variances;
  Eigen::MatrixXd distances(n, n - 2);
  parallel_for(
      static_cast<std::size_t>(n),
      [&](std::size_t i) {
        const auto row = static_cast<Eigen::Index>(i);
        const Eigen::VectorXd squares = left_out_distances(values, model.scores.row(row).transpose(), n);
        for (Eigen::Index m = 1; m <= n - 2; ++m) distances(row, m - 1) = std::sqrt(squares[std::min(m, n_modes)]);
      },
      1);
  summarise(distances, curves.generalisation, curves.generalisation_error);
}

void add_specificity(const ShapeModel& model, int n_samples, std::uint64_t seed, ModelCurves& curves) {
  const Eigen::Index n = model.scores.rows(), n_modes = model.variances.size();
  const Eigen::MatrixXd drawn = model.sample_scores(n_samples, seed).transpose();
  const Eigen::MatrixXd scores = model.scores.transpose();  // a column for each shape
  // What the modes from the M-th on (counted from 0) add to the square of the distance of any shape that has M modes.
  Eigen::MatrixXd remainder = Eigen::MatrixXd::Zero(n_modes + 1, n);
  for (Eigen::Index k = n_modes; k-- > 0;)
    remainder.row(k) = remainder.row(k + 1).array() + scores.row(k).array().square();
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(n_samples, n - 1);
  parallel_for(
      static_cast<std::size_t>(n_samples),
      [&](std::size_t sample) {
        const auto row = static_cast<Eigen::Index>(sample);
        Eigen::ArrayXd nearest = Eigen::ArrayXd::Constant(n_modes, infinity);
        for (Eigen::Index i = 0; i < n; ++i) {
          double square = 0;
          for (Eigen::Index k = 0; k < n_modes; ++k) {
            const double difference = drawn(k, row) - scores(k, i);
            square += difference * difference;
            nearest[k] = std::min(nearest[k], square + remainder(k + 1, i));
          }
        }
        if (n_modes > 0) distances.row(row).setConstant(std::sqrt(nearest[n_modes - 1]));
        distances.row(row).head(n_modes) = nearest.sqrt().transpose();
      },
      1);
  summarise(distances, curves.specificity, curves.specificity_error);
}

}  // namespace

ModelCurves model_curves(const ShapeModel& model, int n_samples, std::uint64_t seed) {
  const Eigen::Index n = model.scores.rows();
  if (n < 3) throw_input_error("the curves of a shape model need at least three shapes; there are {}", n);
  if (n_samples < 1) throw_input_error("specificity of {} random shapes; at least one is needed", n_samples);
  constexpr double rounding = 1e-9;
  if (model.variances.sum() < (1 - rounding) * model.total_variance && model.variances.size() < n - 1)
    throw_input_error("the curves of a shape model need all its modes; this one was limited to {}",
                      model.variances.size());
  ModelCurves curves;
  curves.compactness = compactness_of(model.variances, static_cast<std::size_t>(n - 1));
  add_generalisation(model, curves);
  add_specificity(model, n_samples, seed, curves);
  return curves;
}

ModelCurves model_curves(const PointSets& aligned, const Eigen::VectorXd& weights, int n_samples, std::uint64_t seed) {
  return model_curves(fit_shape_model(aligned, weights), n_samples, seed);
}

}  // namespace shellmatch
