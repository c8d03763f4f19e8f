#include "geometry/curvature/least_squares.h"

#include <Eigen/QR>

namespace shellmatch {

double solve_least_squares(const Eigen::MatrixXd& m, Eigen::VectorXd& b) {
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(m);
  b = decomposition.solve(b).eval();
  const Eigen::VectorXd scales = decomposition.matrixQTZ().diagonal().cwiseAbs();
  return scales.maxCoeff() / scales.minCoeff();
}

}  // namespace shellmatch
