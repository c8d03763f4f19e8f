#include "base/svd.h"

#include "base/error.h"

#include <Eigen/SVD>

namespace shellmatch {

template <class Matrix>
Svd<Matrix> jacobi_svd(const Matrix& a) {
  SHELLMATCH_CHECK(a.rows() == a.cols(), "the singular value decomposition is that of square matrices");
  // Square matrices need no QR decomposition beforehand, whose code takes long to compile.
  const Eigen::JacobiSVD<Matrix, Eigen::NoQRPreconditioner> of_a(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {of_a.matrixU(), of_a.matrixV(), of_a.singularValues()};
}

template Svd<Mat<3>> jacobi_svd(const Mat<3>&);
template Svd<Eigen::MatrixXd> jacobi_svd(const Eigen::MatrixXd&);

}  // namespace shellmatch
