#include "energies/densities/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

#include <limits>

namespace shellmatch {

void remove_negative_eigenvalues(int n, double* matrix) {
  Eigen::Map<Eigen::MatrixXd> m(matrix, n, n);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m);
  m = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

double largest_eigenvalue(int n, const double* matrix) {
  const Eigen::Map<const Eigen::MatrixXd> m(matrix, n, n);
  if (!m.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace shellmatch
