#pragma once
/// \file
/// Exact nearest neighbours among vectors of many components.

#include <Eigen/Core>

#include "base/types.h"

#include <span>
#include <vector>

namespace shellmatch {

/// One vector in each column.
using Features = Eigen::MatrixXf;

/// The target nearest to every query, up to the rounding of single precision; of several whose computed distances are
/// equal the first. By matrix products in blocks, which
/// beat search trees from about ten components on. Each call runs on one thread.
/// \pre both have the same number of rows; there is a target
std::vector<Index> nearest_features(const Features& targets, const Features& queries);

}  // namespace shellmatch
