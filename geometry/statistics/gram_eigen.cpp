#include "geometry/statistics/gram_eigen.h"

#include "base/error.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>

namespace shellmatch {

GramEigen gram_eigen(const Eigen::MatrixXd& gram, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  SHELLMATCH_CHECK(solver.info() == Eigen::Success, "the inner products of shapes have eigenvalues");
  const Eigen::Index n = gram.rows();
  const double limit = n == 0 ? 0 : std::max(least, least_variance_share * solver.eigenvalues()[n - 1]);
  Eigen::Index kept = 0;
  while (kept < n && solver.eigenvalues()[n - 1 - kept] > limit) ++kept;
  return {solver.eigenvalues().reverse().head(kept), solver.eigenvectors().rowwise().reverse().leftCols(kept)};
}

Eigen::MatrixXd orthonormalising_combinations(const Eigen::MatrixXd& gram) {
  const Eigen::LLT<Eigen::MatrixXd> factor(gram);
  SHELLMATCH_CHECK(factor.info() == Eigen::Success, "modes are linearly independent");
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(gram.rows(), gram.cols());
  factor.matrixU().solveInPlace(inverse);
  return inverse;
}

}  // namespace shellmatch
