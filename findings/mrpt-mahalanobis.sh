#!/bin/sh
# MRPT 2.5.8 (Debian 12; 2.14.7 of Debian 13 has the same lines): mahalanobisDistance2(X, MU, COV) is not the Mahalanobis distance. With d = X - MU
# it solves COV z = d and returns z.z, the square of COV^-1 d, where d.z was due. So it has the unit of 1/length^2: a point that lies 5 standard
# deviations off has 2500 where one is 0.1, and 0.25 where it is 10, in place of 25 both times, and in centimetres it is another number than in
# metres. A gate at 99 %, from the same library's chi2inv(), lets 4 % through of what belongs to a Gaussian of 0.1, and takes in all within 30
# deviations of one of 10. mahalanobisDistance(X, MU, COV) is its root. The comment in data_utils.h has the formula d^T Sigma^-1 d, but says 'the
# covariance inverse' of the argument; with the inverse given it is the square of COV d, no better. With the difference d as one argument,
# mahalanobisDistance2(d, COV) and mahalanobisDistance2AndLogPDF(d, COV, ..) are right. It does not show for unit covariance.
# Nothing is said. For matrices of fixed size the function does not compile; for those of dynamic size, as here, it does.
set -eu
version=1:2.5.8+ds-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for name in math core random containers rtti serialization system typemeta; do set -- "$@" "libmrpt-$name-dev=$version"; done
for name in math core random containers rtti serialization system; do set -- "$@" "libmrpt-${name}2.5=$version"; done
apt-get download -qq "$@" "libmrpt-common-dev=$version" libeigen3-dev=3.4.0-4 libfyaml0=0.7.12-2 libjsoncpp25=1.9.5-4 libcxsparse3=1:5.12.0+dfsg-2 \
  libsuitesparseconfig5=1:5.12.0+dfsg-2 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libmrpt-math.so.2.5')")
cat > gate.cpp <<'C'
#include <Eigen/Dense>
#include <mrpt/config.h>
#include <mrpt/version.h>
#include <mrpt/math/CMatrixDynamic.h>
#include <mrpt/math/CVectorDynamic.h>
#include <mrpt/math/data_utils.h>
#include <mrpt/math/distributions.h>
#include <mrpt/math/ops_matrices.h>
#include <mrpt/math/ops_vectors.h>
#include <cmath>
#include <cstdio>
#include <random>
using namespace mrpt::math;
static bool near(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(b)); }
static CVectorDouble vec(double x, double y) {
  CVectorDouble v(2);
  v[0] = x;
  v[1] = y;
  return v;
}
static CMatrixDouble matrix(double xx, double xy, double yy) {
  CMatrixDouble m(2, 2);
  m(0, 0) = xx;
  m(0, 1) = m(1, 0) = xy;
  m(1, 1) = yy;
  return m;
}
int main() {
  std::printf("MRPT %x.%x.%x\n", MRPT_VERSION >> 8, MRPT_VERSION >> 4 & 15, MRPT_VERSION & 15);
  bool as_described = true;
  const double gate = chi2inv(0.99, 2);
  for (double s : {0.1, 0.5, 1., 2., 10.}) {
    const CMatrixDouble cov = matrix(s * s, 0, s * s);
    const CVectorDouble mean = vec(7, -2), point = vec(7 + 3 * s, -2 + 4 * s), d = vec(3 * s, 4 * s);
    const double three = mahalanobisDistance2(point, mean, cov), two = mahalanobisDistance2(d, cov), root = mahalanobisDistance(point, mean, cov);
    const double inverse = mahalanobisDistance2(point, mean, matrix(1 / (s * s), 0, 1 / (s * s)));
    double both, log_pdf;
    mahalanobisDistance2AndLogPDF(d, cov, both, log_pdf);
    std::mt19937 generator(1);
    std::normal_distribution<double> normal(0, s);
    int passed = 0, belong = 0, n = 20000;
    for (int i = 0; i < n; ++i) {
      const double x = normal(generator), y = normal(generator);
      passed += mahalanobisDistance2(vec(x, y), vec(0, 0), cov) < gate;
      belong += mahalanobisDistance2(vec(x, y), cov) < gate;
    }
    std::printf("5 deviations off, one being %4g: (X, MU, COV) %8g, its root %4g, (d, COV) %g, AndLogPDF %g; with the inverse given %g;"
                " gate at 99 %%: %4.1f and %4.1f %% pass\n", s, three, root, two, both, inverse, 100. * passed / n, 100. * belong / n);
    as_described = as_described && near(three, 25 / (s * s)) && near(root, 5 / s) && near(inverse, 25 * std::pow(s, 6));
    as_described = as_described && near(two, 25) && near(both, 25);
    as_described = as_described && std::abs(belong - .99 * n) < .005 * n;
    if (s == 0.1) as_described = as_described && passed < .06 * n;
    if (s == 10) as_described = as_described && passed == n;
  }
  // Correlated, by hand: the inverse of (4 1; 1 1) is (1 -1; -1 4) / 3, and for d = (1, 2) it is (1 - 4 + 16) / 3.
  const CMatrixDouble cov = matrix(4, 1, 1);
  const double three = mahalanobisDistance2(vec(1, 2), vec(0, 0), cov), two = mahalanobisDistance2(vec(1, 2), cov);
  std::printf("covariance 4 1 1: (X, MU, COV) %.4f, (d, COV) %.4f, by hand %.4f\n", three, two, 13 / 3.);
  return !(as_described && near(two, 13 / 3.) && near(three, 50 / 9.));
}
C
for folder_of in root/usr/include/mrpt/*/include; do set -- "$@" -I "$folder_of"; done
while [ "$1" != -I ]; do shift; done
c++ -std=c++17 -O1 -w "$@" -I root/usr/include -I root/usr/include/eigen3 gate.cpp -o gate -L "$lib" -lmrpt-math -lmrpt-core -Wl,-rpath-link,"$lib" \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./gate
