#include "base/decompositions.h"

#include "base/error.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shellmatch {

template <class Matrix>
Svd<Matrix> jacobi_svd(const Matrix& a) {
  SHELLMATCH_CHECK(a.rows() == a.cols(), "the singular value decomposition is that of square matrices");
  // Square matrices need no QR decomposition beforehand, whose code takes long to compile.
  const Eigen::JacobiSVD<Matrix, Eigen::NoQRPreconditioner> of_a(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {of_a.matrixU(), of_a.matrixV(), of_a.singularValues()};
}

Eigen::MatrixXd nearest_orthogonal(const Eigen::MatrixXd& a) {
  SHELLMATCH_CHECK(a.rows() == a.cols(), "the nearest orthogonal matrix is that of square matrices");
  constexpr int most_steps = 12;
  constexpr double worst_condition = 1e6;
  Eigen::MatrixXd x = a;
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::MatrixXd inverse = x.inverse().transpose();
    const double norm = x.norm(), inverse_norm = inverse.norm();
    if (step == 0 && !(norm * inverse_norm < worst_condition)) break;
    const double scale = std::sqrt(inverse_norm / norm);
    const Eigen::MatrixXd next = 0.5 * (scale * x + inverse / scale);
    const double change = (next - x).norm() / next.norm();
    x = next;
    if (change < 1e-8) return x;  // convergence is quadratic
  }
  const Svd<Eigen::MatrixXd> svd = jacobi_svd(a);
  return svd.u * svd.v.transpose();
}

template Svd<Mat<3>> jacobi_svd(const Mat<3>&);
template Svd<Eigen::MatrixXd> jacobi_svd(const Eigen::MatrixXd&);

namespace {

// A symmetric matrix of two rows is tridiagonal as it is. Eigen's general reduction to that form, which
// compute() would call, takes six seconds to compile. The matrix is scaled as compute() does.
void solve(const Mat<2>& a, Eigen::SelfAdjointEigenSolver<Mat<2>>& solver, Vec<2>& values) {
  const double largest = a.cwiseAbs().maxCoeff(), scale = largest == 0 ? 1 : largest;
  solver.computeFromTridiagonal(a.diagonal() / scale, Eigen::Matrix<double, 1, 1>(a(1, 0) / scale));
  values = scale * solver.eigenvalues();
}

void solve(const Mat<3>& a, Eigen::SelfAdjointEigenSolver<Mat<3>>& solver, Vec<3>& values) {
  solver.compute(a);
  values = solver.eigenvalues();
}

// Eigenvalues on the diagonal of `a`, eigenvectors as rows of `vectors`: cyclic Jacobi rotations (G. H. Golub and
// C. F. Van Loan, 'Matrix Computations', 4th edition, algorithm 8.5.3), which suit matrices of at most nine rows.
class JacobiEigen {
 public:
  JacobiEigen(int n, const double* matrix) : n_(n), a_(matrix, matrix + n * n), vectors_(n * n, 0.0) {
    for (int i = 0; i < n; ++i) vectors_[i * n + i] = 1;
    double square = 0;
    for (const double entry : a_) square += entry * entry;
    negligible_ = std::numeric_limits<double>::epsilon() * std::sqrt(square) / n;
    constexpr int max_sweeps = 30;  // convergence is quadratic: five to eight are needed
    for (int sweep = 0; sweep < max_sweeps && rotate_all(); ++sweep) {
    }
  }
  double value(int i) const { return a_[i * n_ + i]; }
  double vector(int i, int k) const { return vectors_[i * n_ + k]; }

 private:
  // False once all entries beside the diagonal are negligible.
  bool rotate_all() {
    bool rotated = false;
    for (int p = 0; p < n_; ++p)
      for (int q = p + 1; q < n_; ++q) {
        if (!(std::abs(a_[p * n_ + q]) > negligible_)) continue;
        Eigen::JacobiRotation<double> rotation;
        rotation.makeJacobi(value(p), a_[p * n_ + q], value(q));
        rotate(p, q, rotation.c(), rotation.s());
        rotated = true;
      }
    return rotated;
  }

  // A becomes J^T A J, and V^T becomes J^T V^T, with J = (c s; -s c) in the plane of p and q.
  void rotate(int p, int q, double c, double s) {
    for (int k = 0; k < n_; ++k) {
      turn(a_[k * n_ + p], a_[k * n_ + q], c, s);
      turn(vectors_[p * n_ + k], vectors_[q * n_ + k], c, s);
    }
    for (int k = 0; k < n_; ++k) turn(a_[p * n_ + k], a_[q * n_ + k], c, s);
    a_[p * n_ + q] = a_[q * n_ + p] = 0;
  }
  static void turn(double& x, double& y, double c, double s) {
    const double first = c * x - s * y;
    y = s * x + c * y;
    x = first;
  }

  int n_;
  double negligible_ = 0;
  std::vector<double> a_, vectors_;
};

}  // namespace

template <int Dim>
Eigenpairs<Dim> eigenpairs(const Mat<Dim>& a) {
  Eigen::SelfAdjointEigenSolver<Mat<Dim>> solver;
  Eigenpairs<Dim> pairs;
  solve(a, solver, pairs.values);
  SHELLMATCH_CHECK(solver.info() == Eigen::Success, "a symmetric matrix has no eigenvalues; is a distance not finite?");
  pairs.vectors = solver.eigenvectors();
  return pairs;
}

void remove_negative_eigenvalues(int n, double* matrix) {
  const JacobiEigen eigen(n, matrix);
  std::fill(matrix, matrix + n * n, 0.0);
  for (int m = 0; m < n; ++m) {
    if (!(eigen.value(m) > 0)) continue;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) matrix[i * n + j] += eigen.value(m) * eigen.vector(m, i) * eigen.vector(m, j);
  }
}

double largest_eigenvalue(int n, const double* matrix) {
  if (!std::all_of(matrix, matrix + n * n, [](double entry) { return std::isfinite(entry); }))
    return std::numeric_limits<double>::quiet_NaN();
  const JacobiEigen eigen(n, matrix);
  double largest = eigen.value(0);
  for (int m = 1; m < n; ++m) largest = std::max(largest, eigen.value(m));
  return largest;
}

SHELLMATCH_2D_3D(eigenpairs);

}  // namespace shellmatch
