#pragma once
/// \file
/// Factor of a metric that couples nodes: the adapter of SuiteSparse's CHOLMOD.

#include "solvers/metric/metric_factor.h"

#include <Eigen/SparseCore>

#include <memory>

namespace shellmatch {

/// F = L^T P for a sparse M with P M P^T = L L^T, where P is a fill-reducing permutation: F^T F = M. The same
/// scalar matrix applies to every component. The factorisation is supernodal and uses the BLAS for dense
/// blocks. Its result does not depend on the number of threads, but the rounding depends on the BLAS.
class SparseFactor final : public MetricFactor {
 public:
  /// \param matrix symmetric, both triangles stored
  /// \param n_components unknown n_components * i + k is component k of row i
  /// \throws InputError where the matrix is not positive definite; EnvironmentError where there is not enough
  /// memory
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
