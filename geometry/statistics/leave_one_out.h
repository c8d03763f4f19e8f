#pragma once
/// \file
/// How well a shape is approximated by the principal modes of all others, from the principal modes of all.

#include <Eigen/Core>

namespace shellmatch {

/// Let y_i be n shapes less their mean, S = sum_i y_i y_i^T with eigenvalues lambda_k, and z the scores of one of them,
/// y. About their own mean the others have
///     S' = S - rho y y^T,  rho = n / (n - 1),
/// and y lies rho y from that mean. In the basis of the modes S' is diag(lambda) - rho z z^T, whose eigenvalues
/// mu_k solve
///     1 = rho sum_j z_j^2 / (lambda_j - mu)        (G. H. Golub, SIAM Rev. 15, 1973),
/// and the square of the component of rho y along the k-th eigenvector is 1 / sum_j (z_j / (lambda_j - mu_k))^2. Thus
/// leaving out each of the shapes takes n^3 operations in all, while a new decomposition for each would take n^4.
///
/// Where the others vary in fewer directions than all, an eigenvalue mu_k is 0: at most least_variance_share
/// (products.h) of the greatest of S. It belongs to no mode of the others, and the component along its eigenvector
/// remains for every number of modes.
///
/// \param values K eigenvalues of S, descending, > 0 \param scores K of one shape \param n number of shapes, > 1
/// \return K + 1 entries: entry M is the squared distance of the shape from its best approximation by M modes of the
/// others, or by all of them where they have fewer
Eigen::VectorXd left_out_distances(const Eigen::VectorXd& values, const Eigen::VectorXd& scores, Eigen::Index n);

}  // namespace shellmatch
