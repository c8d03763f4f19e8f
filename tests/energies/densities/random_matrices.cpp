#include "tests/energies/densities/random_matrices.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace shellmatch::test {

template <int Dim>
Mat<Dim> random_rotation(std::mt19937& random) {
  if constexpr (Dim == 1) {
    return Mat<1>::Ones();
  } else {
    Mat<Dim> q = Eigen::HouseholderQR<Mat<Dim>>(random_matrix<Dim>(random)).householderQ();
    if (q.determinant() < 0) q.col(0) = -q.col(0);
    return q;
  }
}

template <int Dim>
Mat<Dim> random_symmetric(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  const Mat<Dim> q = random_rotation<Dim>(random);
  Vec<Dim> l;
  for (int i = 0; i < Dim; ++i) l[i] = uniform(random);
  return q * l.asDiagonal() * q.transpose();
}

template <int Dim>
Mat<Dim> random_orientation_preserving(std::mt19937& random, double low, double high) {
  return random_rotation<Dim>(random) * random_symmetric<Dim>(random, low, high);
}

template <int Dim>
Mat<Dim> power(const Mat<Dim>& s, double exponent) {
  const Eigen::SelfAdjointEigenSolver<Mat<Dim>> e(s);
  const Vec<Dim> l = e.eigenvalues().array().pow(exponent);
  return e.eigenvectors() * l.asDiagonal() * e.eigenvectors().transpose();
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                    \
  template Mat<Dim> random_rotation<Dim>(std::mt19937&);                               \
  template Mat<Dim> random_symmetric<Dim>(std::mt19937&, double, double);              \
  template Mat<Dim> random_orientation_preserving<Dim>(std::mt19937&, double, double); \
  template Mat<Dim> power<Dim>(const Mat<Dim>&, double);
SHELLMATCH_INSTANTIATE(1)
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch::test
