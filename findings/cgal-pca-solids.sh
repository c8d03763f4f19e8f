#!/bin/sh
# CGAL 5.5.1 (Debian 12), compiled without CGAL_EIGEN3_ENABLED, as it is unless CMake's CGAL_Eigen3_support is linked: the lines and planes that
# linear_least_squares_fitting_3() fits to solid bodies (Dimension_tag<3>) are wrong. There are two functions that sum up the moments, and the one
# for use without Eigen (assemble_covariance_matrix_3 in PCA_util.h) moves those of a box by a quarter of its sides in place of a half, and weighs
# tetrahedra with their signed volume, though the centroid has the absolute one. So the line through one box turns as the box is moved, and is
# right if a corner lies in the origin; with two corners of a tetrahedron exchanged, the 'best' line is the worst, across the body. The quality
# returned is higher for the wrong lines of the box than for the right one. All there is is a warning of the compiler that Diagonalize_traits
# 'can lead to precision issues'; but its eigenvectors are right. Points, triangles and spheres are fitted well.
set -eu
version=5.5.1-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libcgal-dev=$version" libeigen3-dev=3.4.0-4 libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1 libgmp10=2:6.2.1+dfsg1-1.1 \
  libmpfr-dev=4.2.0-1 libmpfr6=4.2.0-1
for package in *.deb; do dpkg -x "$package" root; done
lib=$folder/root/usr/lib/x86_64-linux-gnu
cat > fit.cpp <<'C'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/linear_least_squares_fitting_3.h>
#include <CGAL/version.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
using K = CGAL::Simple_cartesian<double>;
using P = K::Point_3;
// Degrees between the fitted line and the direction that is right.
template <class Body>
double off(const char* what, const Body& body, double x, double y, double z) {
  const std::array<Body, 1> bodies{body};
  K::Line_3 line;
  const double quality = CGAL::linear_least_squares_fitting_3(bodies.begin(), bodies.end(), line, CGAL::Dimension_tag<3>());
  const auto d = line.to_vector();
  const double cosine = std::abs(d.x() * x + d.y() * y + d.z() * z) / std::sqrt(d.squared_length() * (x * x + y * y + z * z));
  const double angle = std::acos(std::min(1.0, cosine)) * 180 / CGAL_PI;
  std::printf("  %-44s line (%6.3f %6.3f %6.3f), %5.1f degrees off, quality %.3f\n", what, d.x(), d.y(), d.z(), angle, quality);
  return angle;
}
int main() {
#ifdef CGAL_EIGEN3_ENABLED
  const bool eigen = true;
#else
  const bool eigen = false;
#endif
  std::printf("CGAL %s, %s Eigen\n", TEXT(CGAL_VERSION), eigen ? "with" : "without");
  const double corner = off("box of 3 x 2 x 1, a corner in the origin:", K::Iso_cuboid_3(P(0, 0, 0), P(3, 2, 1)), 1, 0, 0);
  const double centre = off("the same about the origin:", K::Iso_cuboid_3(P(-1.5, -1, -0.5), P(1.5, 1, 0.5)), 1, 0, 0);
  const double moved = off("the same, its corner at (0,0,10):", K::Iso_cuboid_3(P(0, 0, 10), P(3, 2, 11)), 1, 0, 0);
  // Long in x; of equal width in y and z about the x axis, so that the line is the x axis.
  const P a(6, 0, 0), b(0, 1, 0), c(0, -0.5, std::sqrt(0.75)), d(0, -0.5, -std::sqrt(0.75));
  const double positive = off("long tetrahedron, of positive volume:", K::Tetrahedron_3(a, b, d, c), 1, 0, 0);
  const double negative = off("the same, two corners exchanged:", K::Tetrahedron_3(a, b, c, d), 1, 0, 0);
  if (K::Tetrahedron_3(a, b, d, c).volume() < 0 || corner > 1 || positive > 1) return 1;
  return eigen ? centre > 1 || moved > 1 || negative > 1 : centre < 20 || moved < 20 || negative < 80;
}
C
for eigen in "" "-DCGAL_EIGEN3_ENABLED -I root/usr/include/eigen3"; do
  c++ -std=c++17 -O0 -w $eigen -I root/usr/include -I "$folder/root/usr/include/x86_64-linux-gnu" fit.cpp -o fit -L "$lib" -lmpfr -lgmp
  LD_LIBRARY_PATH=$lib ./fit
done
