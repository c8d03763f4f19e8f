#pragma once
/// \file
/// Eigen's decompositions that CGAL's fit of jets calls, compiled apart from CGAL: either takes seconds.

#include <Eigen/SVD>

extern template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;
