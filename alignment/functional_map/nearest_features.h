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

/// The columns in an order in which those near each other follow one another, by their first rows.
std::vector<Index> compact_order(const Features& features);

/// The target nearest to every query, up to the rounding of single precision; of several whose computed
/// distances are equal the first. Clusters of targets that the triangle inequality excludes are left out. Each
/// call runs on one thread.
/// \param order of the targets, which takes time and changes no result: the compact_order() of vectors that lie
///   as the targets do; empty: theirs
/// \pre both have the same number of rows; there is a target
std::vector<Index> nearest_features(const Features& targets, const Features& queries,
                                    std::span<const Index> order = {});

}  // namespace shellmatch
