#include "grid/fits/classification.h"

#include "base/symmetric_eigen.h"
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

template Mat<2> extended_shape_operator<2>(const Mat<2>&, const Vec<2>&);
template Mat<3> extended_shape_operator<3>(const Mat<3>&, const Vec<3>&);
template Mat<2> classified_power<2>(const Mat<2>&, const Classifier&, double);
template Mat<3> classified_power<3>(const Mat<3>&, const Classifier&, double);

}  // namespace shellmatch
