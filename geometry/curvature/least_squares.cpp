#include "geometry/curvature/least_squares.h"

#include <Eigen/SVD>

namespace shellmatch {

double solve_least_squares(const Eigen::MatrixXd& m, Eigen::VectorXd& b) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(m, Eigen::ComputeThinU | Eigen::ComputeThinV);
  b = svd.solve(b).eval();
  return svd.singularValues().maxCoeff() / svd.singularValues().minCoeff();
}

}  // namespace shellmatch
