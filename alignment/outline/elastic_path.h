#pragma once
/// \file
/// The best monotone correspondence of two closed curves, by dynamic programming.

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace shellmatch {

/// Pairs (i, j) of samples of two closed curves with as many samples each, in the order along both.
using ElasticPath = std::vector<std::pair<std::size_t, std::size_t>>;

/// The path of least cost from the pair (first, second) once around both curves, by steps of 1 to 3 samples on each.
/// \param costs of making i and j a pair, n x n; infinite where they must not be one
/// \param stretching weight of the squared logarithm of the ratio of both steps, in the unit of `costs`
/// \param[out] total mean cost of a sample, the stretching included
/// \return empty where infinite costs leave no way
/// Source: T. B. Sebastian, P. N. Klein, B. B. Kimia: On aligning curves. IEEE PAMI 25, 2003
ElasticPath elastic_path(const Eigen::MatrixXd& costs, std::size_t first, std::size_t second, double stretching,
                         double* total = nullptr);

/// As above, through a pair on the path that was found from the given one, where its costs are least: the first pair,
/// which is only supposed, need not be on the result.
ElasticPath closed_elastic_path(const Eigen::MatrixXd& costs, std::size_t first, std::size_t second, double stretching,
                                double* total = nullptr);

}  // namespace shellmatch
