#include "grid/fits/classification.h"

#include "base/decompositions.h"
#include "base/error.h"
#include "grid/fits/matrix_root.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

double Classifier::operator()(double curvature) const {
  const double k = cap > 0 ? std::clamp(curvature, -cap, cap) : curvature;
  return kind == Classification::absolute ? std::max(std::abs(k), tau) : k + shift;
}

template <int Dim>
Mat<Dim> extended_shape_operator(const Mat<Dim>& hessian, const Vec<Dim>& normal) {
  const Mat<Dim> nn = normal * normal.transpose();
  const Mat<Dim> p = Mat<Dim>::Identity() - nn;
  return p * hessian * p + nn;
}

namespace {

double power(const Classifier& classifier, double curvature, double exponent) {
  const double c = classifier(curvature);
  SHELLMATCH_CHECK(c > 0, "a classified curvature is not positive");
  return exponent == 0.5 ? std::sqrt(c) : exponent == -0.5 ? 1 / std::sqrt(c) : std::pow(c, exponent);
}

/// Unit vectors perpendicular to a unit vector and to each other (T. Duff et al.: Building an orthonormal basis,
/// revisited. Journal of Computer Graphics Techniques 6, 2017).
Eigen::Matrix<double, 2, 1> tangents(const Vec<2>& n) { return {-n[1], n[0]}; }
Eigen::Matrix<double, 3, 2> tangents(const Vec<3>& n) {
  const double sign = std::copysign(1.0, n[2]), a = -1 / (sign + n[2]), b = n[0] * n[1] * a;
  Eigen::Matrix<double, 3, 2> t;
  t << 1 + sign * n[0] * n[0] * a, b, sign * b, sign + n[1] * n[1] * a, -sign * n[0], -n[1];
  return t;
}

}  // namespace

template <int Dim>
Mat<Dim> classified_power(const Mat<Dim>& extended_shape, const Vec<Dim>& normal, const Classifier& classifier,
                          double exponent) {
  const auto t = tangents(normal);
  const Mat<Dim - 1> tangential = t.transpose() * extended_shape * t;
  Mat<Dim - 1> result;
  if constexpr (Dim == 2) {
    result(0, 0) = power(classifier, tangential(0, 0), exponent);
  } else {
    // The function of a matrix of two rows is linear in it: the values at the eigenvalues mean +- half.
    const double mean = 0.5 * tangential.trace();
    const double half = std::hypot(0.5 * (tangential(0, 0) - tangential(1, 1)), tangential(0, 1));
    const double low = power(classifier, mean - half, exponent), high = power(classifier, mean + half, exponent);
    const double slope = half > 0 ? 0.5 * (high - low) / half : 0;
    result = slope * tangential;
    result.diagonal().array() += 0.5 * (low + high) - slope * mean;
  }
  return t * result * t.transpose() + power(classifier, 1, exponent) * (normal * normal.transpose());
}

template <int Dim>
Mat<Dim> classified_power(const Mat<Dim>& extended_shape, const Classifier& classifier, double exponent) {
  const bool by_formula = classifier.root == RootMethod::franca && std::abs(exponent) == 0.5;
  const Eigenpairs<Dim> eigen = eigenpairs<Dim>(extended_shape);
  Vec<Dim> values;
  for (int i = 0; i < Dim; ++i) {
    const double c = classifier(eigen.values[i]);
    SHELLMATCH_CHECK(c > 0, "a classified curvature is not positive");
    values[i] = by_formula ? c : std::pow(c, exponent);
  }
  const Mat<Dim> result = eigen.vectors * values.asDiagonal() * eigen.vectors.transpose();
  if (!by_formula) return result;
  return exponent > 0 ? franca_root<Dim>(result) : franca_inverse_root<Dim>(result);
}

SHELLMATCH_2D_3D(extended_shape_operator);
template Mat<2> classified_power<2>(const Mat<2>&, const Vec<2>&, const Classifier&, double);
template Mat<3> classified_power<3>(const Mat<3>&, const Vec<3>&, const Classifier&, double);
template Mat<2> classified_power<2>(const Mat<2>&, const Classifier&, double);
template Mat<3> classified_power<3>(const Mat<3>&, const Classifier&, double);

}  // namespace shellmatch
