#include "geometry/statistics/shape_model.h"

#include "base/error.h"
#include "base/stop.h"
#include "geometry/statistics/products.h"
#include "geometry/statistics/random.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// A change of size of less than this share is rounding, and entries that differ by less count as equal: in symmetric
// shapes, the greatest entries of a mode come in pairs of opposite signs.
constexpr double sign_share = 0.01;

// How much larger a mode makes the mean, of what it moves.
double growth(const Eigen::VectorXd& mean, const Eigen::Ref<const Eigen::VectorXd>& mode,
              const Eigen::VectorXd& weights) {
  const Eigen::Index dim = mean.size() / weights.size();
  const Eigen::Map<const Eigen::MatrixXd> points(mean.data(), dim, weights.size()),
      moved(mode.data(), dim, weights.size());
  const Eigen::MatrixXd centred = points.colwise() - points * weights;
  const double norm =
      std::sqrt(centred.colwise().squaredNorm().dot(weights) * moved.colwise().squaredNorm().dot(weights));
  return norm > 0 ? centred.cwiseProduct(moved).colwise().sum().dot(weights) / norm : 0;
}

bool is_negative(const Eigen::VectorXd& mean, const Eigen::Ref<const Eigen::VectorXd>& mode,
                 const Eigen::VectorXd& weights) {
  const double larger = growth(mean, mode, weights);
  if (std::abs(larger) > sign_share) return larger < 0;
  const double greatest = mode.cwiseAbs().maxCoeff();
  const auto first = std::ranges::find_if(mode, [&](double x) { return std::abs(x) >= (1 - sign_share) * greatest; });
  return first != mode.end() && *first < 0;
}

}  // namespace

Eigen::MatrixXd ShapeModel::transform(const Eigen::MatrixXd& shapes) const {
  if (shapes.rows() != mean.size())
    throw_input_error("shapes of {} coordinates; the model has {}", shapes.rows(), mean.size());
  return inner_products({shapes, &mean}, {modes}, weights);
}

Eigen::MatrixXd ShapeModel::inverse_transform(const Eigen::MatrixXd& from) const {
  if (from.cols() > modes.cols()) throw_input_error("scores of {} modes; the model has {}", from.cols(), modes.cols());
  Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(modes.cols(), from.rows());
  coefficients.topRows(from.cols()) = from.transpose();
  Eigen::MatrixXd shapes = combinations({modes}, coefficients);
  shapes.colwise() += mean;
  return shapes;
}

Eigen::MatrixXd ShapeModel::sample_scores(int n, std::uint64_t seed) const { return normal_scores(variances, n, seed); }

Eigen::MatrixXd normal_scores(const Eigen::VectorXd& variances, int n, std::uint64_t seed) {
  if (n < 0) throw_input_error("{} random shapes; the number is not negative", n);
  Random random(seed);
  Eigen::MatrixXd drawn(n, variances.size());
  StopCheck stop_check;
  for (Eigen::Index i = 0; i < n; ++i, stop_check())
    for (Eigen::Index k = 0; k < variances.size(); ++k) drawn(i, k) = std::sqrt(variances[k]) * random.normal();
  return drawn;
}

ShapeModel fit_shape_model(const PointSets& aligned, const Eigen::VectorXd& weights, int max_modes) {
  check_point_sets(aligned, weights);
  const Eigen::Index n = aligned.n_sets();
  if (n < 2) throw_input_error("a shape model needs at least two shapes; there is one");
  if (max_modes < 0) throw_input_error("a shape model of {} modes; 0 stands for all of them", max_modes);
  const double degrees = static_cast<double>(n - 1), rounding = rounding_of(aligned);

  ShapeModel model;
  model.dimension = aligned.dimension;
  model.weights = weights;
  model.mean = mean_of(aligned);
  const Shapes centred{aligned.coordinates, &model.mean};
  const Eigen::MatrixXd gram = gram_matrix(centred, weights);
  GramEigen eigen = gram_eigen(gram, static_cast<double>(n) * rounding * rounding);
  model.total_variance = eigen.values.size() > 0 ? gram.trace() / degrees : 0;
  const Eigen::Index n_modes = std::min({eigen.values.size(), n - 1, max_modes > 0 ? Eigen::Index{max_modes} : n - 1});

  // The modes of small variances are combinations of shapes in which much cancels. They are orthonormal to rounding,
  // and scores are projections, only after a second pass.
  eigen.vectors.conservativeResize(Eigen::NoChange, n_modes);
  for (Eigen::Index k = 0; k < n_modes; ++k) eigen.vectors.col(k) /= std::sqrt(eigen.values[k]);
  model.modes = combinations(centred, eigen.vectors);
  combine_in_place(model.modes, orthonormalising_combinations(gram_matrix({model.modes}, weights)));
  model.scores = inner_products(centred, {model.modes}, weights);
  for (Eigen::Index k = 0; k < n_modes; ++k)
    if (is_negative(model.mean, model.modes.col(k), weights)) {
      model.modes.col(k) *= -1;
      model.scores.col(k) *= -1;
    }
  model.variances = model.scores.colwise().squaredNorm().transpose() / degrees;
  return model;
}

}  // namespace shellmatch
