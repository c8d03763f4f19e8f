#!/bin/sh
# MRPT 2.5.8 (Debian 12; 2.14.7 of Debian 13 has the same lines): covariances of poses with an angle are wrong once they spread over more than pi.
# covariancesAndMean() and covariancesAndMeanWeighted() take an array elem_do_wrap2pi that says which components are angles. For element (i, j) of
# the covariance they look at the flag of i alone and then wrap both deviations to [-pi, pi]: with (x, y, phi), the usual order, x and y, which are
# lengths, are wrapped along with phi. In a motion that turns by 0.1 in 10 m the covariance of x and phi is 0.014 in place of 0.367. Only such
# pairs are touched: the variances and the covariance of x and y are right, so that the ellipses one draws look well.
# transform_gaussian_unscented() goes by it: through the identity, with alpha 1, a covariance of 0.6 comes back as 0.16, one of -0.3 as 0.02. If
# the angle is the first component all is right, and so it is if x and y stay within pi, so that centimetres give another result than metres; with
# the default alpha, 0.001, the points lie too close together to show it. The flags are documented as 'if it's needed to do a wrap to [-pi,pi] to
# each dimension'. Nothing is said.
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
cat > poses.cpp <<'C'
#include <Eigen/Dense>
#include <mrpt/config.h>
#include <mrpt/version.h>
#include <mrpt/math/CMatrixFixed.h>
#include <mrpt/math/CVectorFixed.h>
#include <mrpt/math/data_utils.h>
#include <mrpt/math/ops_matrices.h>
#include <mrpt/math/ops_vectors.h>
#include <mrpt/math/transform_gaussian.h>
#include <cmath>
#include <cstdio>
#include <vector>
using namespace mrpt::math;
using Vector = CVectorFixedDouble<3>;
using Matrix = CMatrixDouble33;
static void identity(const Vector& x, const int&, Vector& y) { y = x; }
static void show(const char* what, const Matrix& c) {
  std::printf("%-46s variances %8.4f %8.4f %8.4f, covariances 01 %8.4f, 02 %8.4f, 12 %8.4f\n", what, c(0, 0), c(1, 1), c(2, 2), c(0, 1), c(0, 2),
              c(1, 2));
}
static double off(const Matrix& a, const Matrix& b) {
  double most = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::fmax(most, std::abs(a(i, j) - b(i, j)));
  return most;
}
/* 21 poses (x, y, phi) along a motion that turns evenly; the covariance with and without the flag for phi, which stays within [-0.1, 0.1]. */
static void motion(double length, bool angle_first, Matrix& flagged, Matrix& plain) {
  std::vector<Vector> poses;
  for (int i = -10; i <= 10; ++i) {
    Vector pose;
    pose[angle_first ? 2 : 0] = length * i / 10;
    pose[1] = 0.1 * length * i / 10;
    pose[angle_first ? 0 : 2] = 0.1 * i / 10;
    poses.push_back(pose);
  }
  const bool last[3] = {false, false, true}, first[3] = {true, false, false};
  Vector mean;
  covariancesAndMean(poses, flagged, mean, angle_first ? first : last);
  covariancesAndMean(poses, plain, mean);
}
int main() {
  std::printf("MRPT %x.%x.%x\n", MRPT_VERSION >> 8, MRPT_VERSION >> 4 & 15, MRPT_VERSION & 15);
  Matrix flagged, plain;
  bool as_described = true;
  motion(3, false, flagged, plain);
  show("x within 3, y, phi, flag for phi:", flagged);
  as_described = as_described && off(flagged, plain) < 1e-12;
  motion(10, false, flagged, plain);
  show("x within 10, y, phi, flag for phi:", flagged);
  show("the same without the flag:", plain);
  const double exact = 10 * 0.1 * 77 / 210; // mean of (i/10)^2 for i = -10..10 is 770/2100
  as_described = as_described && std::abs(plain(0, 2) - exact) < 1e-12 && std::abs(flagged(0, 2) - 0.0136115) < 1e-6;
  for (int i = 0; i < 3; ++i) as_described = as_described && std::abs(flagged(i, i) - plain(i, i)) < 1e-12;
  as_described = as_described && std::abs(flagged(0, 1) - plain(0, 1)) < 1e-12;
  motion(10, true, flagged, plain);
  show("phi, y, x within 10, flag for phi:", flagged);
  as_described = as_described && off(flagged, plain) < 1e-12 && std::abs(flagged(0, 2) - exact) < 1e-12;
  // A Gaussian of a pose through the identity: the unscented transformation is to give it back.
  Vector mean, out;
  mean[0] = 5;
  mean[1] = 6;
  mean[2] = 1;
  Matrix given, c;
  given.setIdentity();
  given(0, 0) = 25;
  given(1, 1) = 16;
  given(2, 2) = 0.04;
  given(0, 1) = given(1, 0) = 2;
  given(0, 2) = given(2, 0) = 0.6;
  given(1, 2) = given(2, 1) = -0.3;
  show("given:", given);
  const bool flags[3] = {false, false, true};
  for (int run = 0; run < 3; ++run) {
    transform_gaussian_unscented<Vector, Matrix, int, Vector, Vector, Matrix>(mean, given, identity, 0, out, c, run == 1 ? nullptr : flags,
                                                                             run == 2 ? 1e-3 : 1.0);
    show(run == 0 ? "unscented, alpha 1, flag for phi:" : run == 1 ? "unscented, alpha 1, no flag:" : "unscented, default alpha, flag for phi:", c);
    const double wrong = std::fmax(std::abs(c(0, 2) - given(0, 2)), std::abs(c(1, 2) - given(1, 2)));
    as_described = as_described && (run == 0 ? std::abs(c(0, 2) - 0.1647) < 1e-3 && std::abs(c(1, 2) - 0.0172) < 1e-3 : wrong < 1e-6);
    as_described = as_described && std::abs(c(0, 0) - 25) < 1e-6 && std::abs(c(0, 1) - 2) < 1e-6;
  }
  return !as_described;
}
C
for folder_of in root/usr/include/mrpt/*/include; do set -- "$@" -I "$folder_of"; done
while [ "$1" != -I ]; do shift; done
c++ -std=c++17 -O1 -w "$@" -I root/usr/include -I root/usr/include/eigen3 poses.cpp -o poses -L "$lib" -lmrpt-math -lmrpt-random -lmrpt-core \
  -Wl,-rpath-link,"$lib" -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./poses
