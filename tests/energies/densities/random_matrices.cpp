#include "tests/energies/densities/random_matrices.h"

#include "base/decompositions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace shellmatch::test {

template <int Dim>
Mat<Dim> random_rotation(std::mt19937& random) {
  if constexpr (Dim == 1) {
    return Mat<1>::Ones();
  } else if constexpr (Dim == 2) {
    return Eigen::Rotation2Dd(std::uniform_real_distribution<double>(-M_PI, M_PI)(random)).toRotationMatrix();
  } else {
    std::normal_distribution<double> normal;
    Eigen::Quaterniond q;
    for (double& x : q.coeffs()) x = normal(random);
    return q.normalized().toRotationMatrix();
  }
}

template <int Dim>
Mat<Dim> random_symmetric(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  const Mat<Dim> q = random_rotation<Dim>(random);
  Vec<Dim> l;
  for (int i = 0; i < Dim; ++i) l[i] = uniform(random);
  return q * l.asDiagonal() * q.transpose();
}

template <int Dim>
Mat<Dim> random_orientation_preserving(std::mt19937& random, double low, double high) {
  return random_rotation<Dim>(random) * random_symmetric<Dim>(random, low, high);
}

template <int Dim>
Mat<Dim> power(const Mat<Dim>& s, double exponent) {
  if constexpr (Dim == 1) {
    return Mat<1>(std::pow(s(0, 0), exponent));
  } else {
    const Eigenpairs<Dim> e = eigenpairs<Dim>(s);
    const Vec<Dim> l = e.values.array().pow(exponent);
    return e.vectors * l.asDiagonal() * e.vectors.transpose();
  }
}

Eigen::MatrixXd positive_part(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> e(symmetric);
  return e.eigenvectors() * e.eigenvalues().cwiseMax(0.0).asDiagonal() * e.eigenvectors().transpose();
}

double least_eigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                    \
  template Mat<Dim> random_rotation<Dim>(std::mt19937&);                               \
  template Mat<Dim> random_symmetric<Dim>(std::mt19937&, double, double);              \
  template Mat<Dim> random_orientation_preserving<Dim>(std::mt19937&, double, double); \
  template Mat<Dim> power<Dim>(const Mat<Dim>&, double);
SHELLMATCH_INSTANTIATE(1)
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch::test
