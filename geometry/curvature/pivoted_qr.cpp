#include "geometry/curvature/jacobi_svd.h"

template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
