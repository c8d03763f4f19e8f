#pragma once
/// \file
/// The factor of a metric that couples nodes, by SuiteSparse's CHOLMOD.

#include "solvers/metric/metric_factor.h"

#include <Eigen/SparseCore>

#include <memory>

namespace shellmatch {

/// F = L^T P for a sparse M with P M P^T = L L^T, P a fill-reducing permutation: F^T F = M. The same scalar matrix
/// serves every component. The factorisation is supernodal and leaves its dense blocks to the machine's BLAS: it does
/// not depend on our number of threads, but another BLAS may round otherwise.
class SparseFactor final : public MetricFactor {
 public:
  /// \param matrix symmetric, both triangles stored
  /// \param n_components unknown n_components * i + k is component k of row i
  /// \throws InputError where the matrix is not positive definite; EnvironmentError where memory runs out
  SparseFactor(Eigen::SparseMatrix<double> matrix, int n_components);
  ~SparseFactor() override;

  std::size_t size() const override;
  void apply(std::span<const double> x, std::span<double> y) const override;
  void solve(std::span<const double> y, std::span<double> x) const override;
  void solve_transposed(std::span<const double> g, std::span<double> z) const override;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace shellmatch
