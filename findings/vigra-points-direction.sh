#!/bin/sh
# VIGRA 1.11.1 (Debian 12): of its four ways from pairs of points to a warp, one goes the other way, with the same order of arguments and the same
# description ('matrix that maps corresponding points onto each other', for use with the warp of the same name). All four warps look up, for a
# point of the result, the matrix times it in the source. projective-, polynomial- and rbfMatrix2DFromCorrespondingPoints(s, send, d) give
# the matrix from d to s for that, and what lies at s comes to d. affineMatrix2DFromCorrespondingPoints(s, send, d) gives the one from s to d:
# affineWarpImage() then moves the image by the inverse, what lies at s does not come to d but as far off on the other side. The residual of
# the fit is 0 in both directions and nothing is said; for few degrees and pixels it looks like a bad registration. Affine with d first is right.
set -eu
version=1.11.1+dfsg-11
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvigraimpex-dev=$version"
dpkg -x libvigraimpex-dev_*.deb root
cat > points.cpp <<'C'
#include <vigra/affine_registration.hxx>
#include <vigra/config_version.hxx>
#include <vigra/multi_array.hxx>
#include <vigra/polynomial_registration.hxx>
#include <vigra/projective_registration.hxx>
#include <vigra/rbf_registration.hxx>
#include <vigra/splineimageview.hxx>
#include <cmath>
#include <cstdio>
#include <vector>
using namespace vigra;
using Image = MultiArray<2, double>;
using Points = std::vector<TinyVector<double, 2>>;
// How far the middle of the grey values of a warped image is from the place given.
double off(const char* name, const Image& image, double x, double y) {
  double sum = 0, a = 0, b = 0;
  for (int j = 0; j < image.height(); ++j)
    for (int i = 0; i < image.width(); ++i) {
      sum += image(i, j);
      a += i * image(i, j);
      b += j * image(i, j);
    }
  std::printf("  %-29s spot at (%.2f, %.2f), it belongs at (%.2f, %.2f)\n", name, a / sum, b / sum, x, y);
  return std::hypot(a / sum - x, b / sum - y);
}
int main() {
  std::printf("VIGRA %s\n", VIGRA_VERSION);
  // Six points about the middle of the image, and where they come to when turned by 12 degrees about the middle and moved by (3, -2).
  const double c = std::cos(12 * M_PI / 180), s = std::sin(12 * M_PI / 180), xy[6][2] = {{70, 50}, {60, 67}, {40, 67}, {30, 50}, {40, 33}, {62, 30}};
  Points from, to;
  for (const auto& p : xy) {
    const double u = p[0] - 50, v = p[1] - 50;
    from.push_back({p[0], p[1]});
    to.push_back({50 + c * u - s * v + 3, 50 + s * u + c * v - 2});
  }
  // A spot at the first of them.
  Image image(Shape2(101, 101));
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 101; ++i) image(i, j) = std::exp(-(std::pow(i - from[0][0], 2) + std::pow(j - from[0][1], 2)) / 8);
  const SplineImageView<3, double> spline(image);
  const double x = to[0][0], y = to[0][1];
  std::printf("a spot at (%g, %g), warped:\n", from[0][0], from[0][1]);
  Image warped(image.shape());
  projectiveWarpImage(spline, warped, projectiveMatrix2DFromCorrespondingPoints(from.begin(), from.end(), to.begin()));
  const double projective = off("projective:", warped, x, y);
  warped = 0;
  polynomialWarpImage<1>(spline, warped, polynomialMatrix2DFromCorrespondingPoints<1>(from.begin(), from.end(), to.begin()));
  const double polynomial = off("polynomial of degree 1:", warped, x, y);
  warped = 0;
  const ThinPlateSplineFunctor plate;
  rbfWarpImage(spline, warped, to.begin(), to.end(), rbfMatrix2DFromCorrespondingPoints(from.begin(), from.end(), to.begin(), plate), plate);
  const double rbf = off("thin plate:", warped, x, y);
  double affine[3];
  const int counts[3] = {6, 2, 1};
  for (int k = 0; k < 3; ++k) {
    char name[40];
    std::snprintf(name, sizeof name, "affine, %d pair(s) of points:", counts[k]);
    warped = 0;
    affineWarpImage(spline, warped, affineMatrix2DFromCorrespondingPoints(from.begin(), from.begin() + counts[k], to.begin()));
    affine[k] = off(name, warped, x, y);
  }
  warped = 0;
  affineWarpImage(spline, warped, affineMatrix2DFromCorrespondingPoints(to.begin(), to.end(), from.begin()));
  const double swapped = off("affine, points exchanged:", warped, x, y);
  return !(projective < 0.01 && polynomial < 0.01 && rbf < 0.01 && swapped < 0.01 && affine[0] > 5 && affine[1] > 5 && affine[2] > 5);
}
C
c++ -std=c++14 -O1 -w -I root/usr/include points.cpp -o points
./points
