#include "tests/geometry/statistics/families.h"

#include <cmath>
#include <numbers>
#include <random>

namespace shellmatch::testing {

PointSets random_sets(int dimension, Eigen::Index n_points, Eigen::Index n_sets, std::uint64_t seed, double offset) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  PointSets sets{dimension, Eigen::MatrixXd(dimension * n_points, n_sets)};
  for (Eigen::Index i = 0; i < n_sets; ++i)
    for (double& x : sets.coordinates.col(i)) x = offset + normal(random);
  return sets;
}

Eigen::VectorXd random_weights(Eigen::Index n_points, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.1, 2);
  Eigen::VectorXd weights(n_points);
  for (double& w : weights) w = uniform(random);
  return weights / weights.sum();
}

double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights) {
  const Eigen::Index dimension = a.size() / weights.size();
  double sum = 0;
  for (Eigen::Index row = 0; row < a.size(); ++row)
    sum += weights[row / dimension] * (a[row] - b[row]) * (a[row] - b[row]);
  return std::sqrt(sum);
}

Eigen::MatrixXd prescribed_scores(Eigen::Index n, const std::vector<double>& variances) {
  Eigen::MatrixXd scores(n, std::ssize(variances));
  for (Eigen::Index k = 0; k < scores.cols(); ++k) {
    const double amplitude =
        std::sqrt(2 * variances[static_cast<std::size_t>(k)] * static_cast<double>(n - 1) / static_cast<double>(n));
    for (Eigen::Index i = 0; i < n; ++i)
      scores(i, k) =
          amplitude * std::cos(2 * std::numbers::pi * static_cast<double>((k + 1) * i) / static_cast<double>(n));
  }
  return scores;
}

PointSets BoxFamily::shapes(const Eigen::MatrixXd& scores) const {
  PointSets sets{dimension, mean.replicate(1, scores.rows())};
  for (Eigen::Index i = 0; i < scores.rows(); ++i)
    for (Eigen::Index k = 0; k < scores.cols(); ++k) sets.coordinates.col(i) += scores(i, k) * modes.col(k);
  return sets;
}

BoxFamily box_family(int dimension, int n_shells) {
  const int n_corners_of_box = 1 << dimension;
  const Eigen::Index n_points = n_shells * n_corners_of_box;
  BoxFamily family{dimension, Eigen::VectorXd(dimension * n_points), uniform_weights(n_points), {}};
  family.modes = Eigen::MatrixXd::Zero(dimension * n_points, dimension);
  const double half_sides[] = {3, 2, 1};
  for (Eigen::Index p = 0; p < n_points; ++p)
    for (int k = 0; k < dimension; ++k) {
      const double side = (p % n_corners_of_box >> k & 1) != 0 ? 1 : -1;
      const double shell = 1 + 0.1 * static_cast<double>(p / n_corners_of_box);
      family.mean[dimension * p + k] = side * half_sides[k] * shell;
      family.modes(dimension * p + k, k) = side;
    }
  return family;  // each mode has entries 1 or -1 in one coordinate of every point: its norm is 1
}

Sphere sphere(int n_rings, double crowding) {
  const int m = 2 * n_rings;
  std::vector<double> points{0, 0, 1};
  for (int ring = 1; ring < n_rings; ++ring) {
    const double polar = std::numbers::pi * std::pow(static_cast<double>(ring) / n_rings, crowding);
    for (int j = 0; j < m; ++j) {
      const double angle = 2 * std::numbers::pi * j / m;
      points.insert(points.end(),
                    {std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar)});
    }
  }
  points.insert(points.end(), {0, 0, -1});
  const int last = static_cast<int>(points.size()) / 3 - 1;
  Sphere result{Eigen::Map<Eigen::VectorXd>(points.data(), std::ssize(points)), {}};
  for (int j = 0; j < m; ++j) {
    const int next = (j + 1) % m;
    result.triangles.push_back({0, 1 + j, 1 + next});
    for (int ring = 0; ring + 2 < n_rings; ++ring) {
      const int a = 1 + ring * m + j, b = 1 + ring * m + next;
      result.triangles.push_back({a, a + m, b + m});
      result.triangles.push_back({a, b + m, b});
    }
    result.triangles.push_back({last, last - m + next, last - m + j});
  }
  return result;
}

}  // namespace shellmatch::testing
