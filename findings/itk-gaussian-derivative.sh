#!/bin/sh
# ITK 5.2.1 (Debian 12; the code is the same in 5.4.3 of Debian 13): GaussianDerivativeSpatialFunction is no derivative of a Gaussian in the plane or
# in space. Where the exponent is to be the sum of (x_i - m_i)^2 / (2 s_i^2) over the coordinates, the loop of Evaluate() has m_Direction for its own
# index, and so adds the term of one coordinate N times: along that coordinate the bell is narrower by the root of N, along the others it never
# falls off. So 100 sigma beside the centre it is what it is at the centre's height, and what EvaluateVector() gives is no gradient of anything (its
# mixed derivatives, equal in any gradient to the one of the Gaussian, are 0). It does not show where all coordinates are equally many sigmas from the
# centre, nor in one dimension, as which ITK itself uses it. Not normalized, as by default, there is also a factor 2 s^2 too much, in one dimension
# too (-2 x for -x / s^2). The header promises a 'standard derivative of Gaussian curve in N-d', and nothing is said.
set -eu
version=5.2.1-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libinsighttoolkit5-dev=$version" "libinsighttoolkit5.2=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libITKCommon-5.2.so.1')")
cat > bell.cpp <<'C'
#include <itkGaussianDerivativeSpatialFunction.h>
#include <itkGaussianSpatialFunction.h>
#include <itkVersion.h>
#include <cmath>
#include <cstdio>
template <unsigned N> struct Bells {
  using Point = itk::Point<double, N>;
  using Value = itk::GaussianSpatialFunction<double, N, Point>;
  using Slope = itk::GaussianDerivativeSpatialFunction<double, N, Point>;
  typename Value::Pointer value = Value::New();
  typename Slope::Pointer slope = Slope::New();
  double mean[3] = {5, -3, 2}, sigma[3] = {1, 2, 1.5};
  Bells(bool normalized) {
    typename Value::ArrayType m, s;
    for (unsigned i = 0; i < N; ++i) m[i] = mean[i], s[i] = sigma[i];
    value->SetMean(m), value->SetSigma(s), value->SetNormalized(normalized);
    slope->SetMean(m), slope->SetSigma(s), slope->SetNormalized(normalized);
  }
  // Place given in units of sigma from the centre.
  Point at(const double* z) const {
    Point p;
    for (unsigned i = 0; i < N; ++i) p[i] = mean[i] + sigma[i] * z[i];
    return p;
  }
  double given(const Point& p, unsigned i) const { return slope->EvaluateVector(p)[i]; }
  double right(const Point& p, unsigned i) const { // from differences of ITK's Gaussian
    const double h = 1e-4;
    Point a = p, b = p;
    a[i] -= h, b[i] += h;
    return (value->Evaluate(b) - value->Evaluate(a)) / (2 * h);
  }
};
bool close(double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b) + 1e-12; }
template <unsigned N> bool look(const double* z, bool normalized) {
  const Bells<N> bells(normalized);
  const auto p = bells.at(z);
  double square = 0;
  for (unsigned i = 0; i < N; ++i) square += z[i] * z[i];
  std::printf("%uD, %snormalized, at", N, normalized ? "" : "not ");
  for (unsigned i = 0; i < N; ++i) std::printf(" %g", z[i]);
  std::printf(" sigma from the centre: given");
  bool as_described = true;
  for (unsigned i = 0; i < N; ++i) std::printf(" %.6g", bells.given(p, i));
  std::printf(", right");
  for (unsigned i = 0; i < N; ++i) {
    const double given = bells.given(p, i), right = bells.right(p, i), s = bells.sigma[i];
    std::printf(" %.6g", right);
    // The right one has exp(-square / 2), the given one exp(-N z_i^2 / 2).
    const double extra = normalized ? 1 : 2 * s * s, exponent = std::exp((square - N * z[i] * z[i]) / 2);
    if (square < 30) as_described &= std::abs(given - right * extra * exponent) < 1e-6 * std::abs(given) + 1e-9;
  }
  std::printf("\n");
  return as_described;
}
int main() {
  std::printf("ITK %s\n", itk::Version::GetITKVersion());
  const double line[] = {0.7}, diagonal[] = {1, 1, 1}, beside[] = {1, 3, 0}, far[] = {1, 100, 0}, axis[] = {1, 0, 0};
  bool as_described = look<1>(line, true) && look<2>(diagonal, true) && look<2>(axis, true) && look<2>(beside, true) && look<2>(far, true);
  as_described &= look<3>(axis, true) && look<3>(beside, true) && look<2>(beside, false) && look<1>(line, false);
  const Bells<1> one(true);
  as_described &= close(one.given(one.at(line), 0), one.right(one.at(line), 0));
  const Bells<2> two(true);
  as_described &= close(two.given(two.at(far), 0), two.given(two.at(axis), 0)) && std::abs(two.right(two.at(far), 0)) < 1e-100;
  // Mixed derivatives of what is to be a gradient, by differences.
  const auto p = two.at(diagonal);
  const double h = 1e-4;
  auto up = p, down = p, left = p, to_right = p;
  up[1] += h, down[1] -= h, left[0] -= h, to_right[0] += h;
  const double xy = (two.given(up, 0) - two.given(down, 0)) / (2 * h), yx = (two.given(to_right, 1) - two.given(left, 1)) / (2 * h);
  const double right = (two.right(up, 0) - two.right(down, 0)) / (2 * h);
  std::printf("mixed derivatives at 1 1 sigma: given %.6g and %.6g, right %.6g\n", xy, yx, right);
  as_described &= std::abs(xy) < 1e-9 && std::abs(yx) < 1e-9 && right > 0.01;
  return !as_described;
}
C
c++ -std=c++17 -O0 -w -I root/usr/include/ITK-5.2 bell.cpp -o bell -L "$lib" -lITKCommon-5.2 -litksys-5.2 -litkvnl-5.2 -litkvnl_algo-5.2 \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./bell
