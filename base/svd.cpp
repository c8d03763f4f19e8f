#include "base/svd.h"

#include "base/error.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace shellmatch {

template <class Matrix>
Svd<Matrix> jacobi_svd(const Matrix& a) {
  SHELLMATCH_CHECK(a.rows() == a.cols(), "the singular value decomposition is that of square matrices");
  // Square matrices need no QR decomposition beforehand, whose code takes long to compile.
  const Eigen::JacobiSVD<Matrix, Eigen::NoQRPreconditioner> of_a(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {of_a.matrixU(), of_a.matrixV(), of_a.singularValues()};
}

Eigen::MatrixXd nearest_orthogonal(const Eigen::MatrixXd& a) {
  SHELLMATCH_CHECK(a.rows() == a.cols(), "the nearest orthogonal matrix is that of square matrices");
  constexpr int most_steps = 12;
  constexpr double worst_condition = 1e6;
  Eigen::MatrixXd x = a;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::MatrixXd inverse = x.inverse().transpose();
    const double norm = x.norm(), inverse_norm = inverse.norm();
    if (step == 0 && !(norm * inverse_norm < worst_condition)) break;
    const double scale = std::sqrt(inverse_norm / norm);
    const Eigen::MatrixXd next = 0.5 * (scale * x + inverse / scale);
    const double change = (next - x).norm() / next.norm();
    x = next;
    if (change < 1e-8) return x;  // convergence is quadratic
  }
  const Svd<Eigen::MatrixXd> svd = jacobi_svd(a);
  return svd.u * svd.v.transpose();
}

template Svd<Mat<3>> jacobi_svd(const Mat<3>&);
template Svd<Eigen::MatrixXd> jacobi_svd(const Eigen::MatrixXd&);

}  // namespace shellmatch
