#include "alignment/spectrum/laplacian.h"

#include "base/error.h"

#include <Eigen/SparseCholesky>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>

namespace shellmatch {

namespace {

/// x -> D (S + shift M)^-1 D x with M = D D diagonal. An eigenvector u = D phi of value 1 / (lambda + shift) belongs
/// to S phi = lambda M phi, so that the generalised problem becomes a standard one.
class InverseOperator {
 public:
  using Scalar = double;

  InverseOperator(const SurfaceLaplacian& laplacian, double shift) : root_(laplacian.mass.cwiseSqrt()) {
    if (!laplacian.stiffness.coeffs().allFinite() || !root_.allFinite())
      throw_input_error(
          "the Laplacian of the surface is not finite; a facet without area needs a mollification above 0");
    Eigen::SparseMatrix<double> matrix = laplacian.stiffness;
    matrix.diagonal() += shift * laplacian.mass;
    factor_.compute(matrix);
    if (factor_.info() != Eigen::Success) throw_input_error("the Laplacian of the surface cannot be factorised");
  }
  Eigen::Index rows() const { return root_.size(); }
  Eigen::Index cols() const { return root_.size(); }
  void perform_op(const double* x, double* y) const {
    const Eigen::Map<const Eigen::VectorXd> in(x, rows());
    Eigen::Map<Eigen::VectorXd>(y, rows()) = root_.cwiseProduct(factor_.solve(root_.cwiseProduct(in)));
  }
  const Eigen::VectorXd& root() const { return root_; }

 private:
  Eigen::VectorXd root_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace

LaplacianEigenpairs least_eigenpairs(const SurfaceLaplacian& laplacian, int n) {
  const auto n_vertices = static_cast<int>(laplacian.mass.size());
  SHELLMATCH_CHECK(0 < n && n < n_vertices, "fewer eigenpairs than vertices are asked for");
  // A shift of about a tenth of the first positive eigenvalue of compact shapes keeps the matrix well conditioned.
  const double shift = 1 / laplacian.mass.sum();
  InverseOperator inverse(laplacian, shift);
  Spectra::SymEigsSolver<InverseOperator> solver(inverse, n, std::min(n_vertices, std::max(2 * n, n + 20)));
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 300, 1e-9, Spectra::SortRule::LargestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw_input_error("the eigenfunctions of the surface's Laplacian did not converge");
  LaplacianEigenpairs pairs;
  pairs.values = (solver.eigenvalues().cwiseInverse().array() - shift).max(0);
  pairs.functions = inverse.root().cwiseInverse().asDiagonal() * solver.eigenvectors();
  if (pairs.functions.col(0).sum() < 0) pairs.functions.col(0) *= -1;
  return pairs;
}

}  // namespace shellmatch
