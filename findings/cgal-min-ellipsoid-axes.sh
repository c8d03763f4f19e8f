#!/bin/sh
# CGAL 5.5.1 (Debian 12; the code is the same in 6.0.1 of Debian 13): the axes of the smallest ellipsoid about points in space
# (Approximate_min_ellipsoid_d) do not belong to their lengths. axes_lengths_begin() has them from the longest to the shortest, but
# axis_direction_cartesian_begin(i) from the shortest to the longest, though 'the length of axis i is given by the i-th entry': compute_axes_3()
# takes the eigenvalues in their order and the eigenvectors in the reverse one. So the longest axis gets the direction of the shortest; a cigar of
# 5, 2, 1 comes out lying across itself, and of points on its surface four in five are outside of the ellipsoid set up from centre, lengths and
# directions. The middle axis is right; so are is_valid(), the centre and the defining matrix, by which each direction can be given its length.
# In the plane compute_axes_2() turns both, so that they fit, but the shorter comes first, while the header says 'sorted descending'; whoever takes
# the first as the longest is wrong there too. It does not show for balls, nor if only lengths are read. With Eigen it is the same. Nothing is said.
set -eu
version=5.5.1-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libcgal-dev=$version" libeigen3-dev=3.4.0-4 libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1 libgmp10=2:6.2.1+dfsg1-1.1 \
  libmpfr-dev=4.2.0-1 libmpfr6=4.2.0-1
for package in *.deb; do dpkg -x "$package" root; done
lib=$folder/root/usr/lib/x86_64-linux-gnu
cat > ellipsoid.cpp <<'C'
#include <CGAL/Approximate_min_ellipsoid_d.h>
#include <CGAL/Approximate_min_ellipsoid_d_traits_2.h>
#include <CGAL/Approximate_min_ellipsoid_d_traits_3.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>
#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
using K = CGAL::Simple_cartesian<double>;
using Ellipsoid = CGAL::Approximate_min_ellipsoid_d<CGAL::Approximate_min_ellipsoid_d_traits_3<K, CGAL::MP_Float>>;
using Ellipse = CGAL::Approximate_min_ellipsoid_d<CGAL::Approximate_min_ellipsoid_d_traits_2<K, CGAL::MP_Float>>;
using Vector = std::array<double, 3>;
static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
int main() {
  bool as_described = true;
  // Points on an ellipsoid of 5, 2, 1 that is turned and moved.
  const double p = 0.6, q = 0.4;
  const Vector frame[3] = {{std::cos(p) * std::cos(q), std::sin(p) * std::cos(q), std::sin(q)},
                           {-std::sin(p), std::cos(p), 0},
                           {-std::cos(p) * std::sin(q), -std::sin(p) * std::sin(q), std::cos(q)}};
  const double radii[3] = {5, 2, 1};
  const Vector at = {10, -3, 4};
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  std::vector<K::Point_3> points;
  for (int i = 0; i < 200; ++i) {
    Vector u = {normal(generator), normal(generator), normal(generator)}, x = at;
    const double norm = std::sqrt(dot(u, u));
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) x[j] += radii[k] * u[k] / norm * frame[k][j];
    points.emplace_back(x[0], x[1], x[2]);
  }
  Ellipsoid e(0.001, points.begin(), points.end());
  const auto c = e.center_cartesian_begin();
  const Vector centre = {c[0], c[1], c[2]};
  std::printf("ellipsoid of 5, 2, 1 about (10, -3, 4): centre (%.3f, %.3f, %.3f), valid %d\n", centre[0], centre[1], centre[2], e.is_valid(false));
  as_described = as_described && e.is_valid(false);
  double length[3];
  Vector axis[3];
  for (int i = 0; i < 3; ++i) {
    length[i] = e.axes_lengths_begin()[i];
    const auto d = e.axis_direction_cartesian_begin(i);
    axis[i] = {d[0], d[1], d[2]};
    // How far it is along that direction from the centre to the points' own ellipsoid, and to CGAL's by its matrix.
    double inverse = 0, x = 0;
    for (int k = 0; k < 3; ++k) inverse += std::pow(dot(axis[i], frame[k]) / radii[k], 2);
    // At centre + t axis the matrix gives square t^2 + constant; all its coefficients come times 4 (1 + epsilon), as the header says.
    double square = 0, constant = e.defining_scalar() - 4 * (1 + e.achieved_epsilon());
    for (int a = 0; a < 3; ++a) {
      constant += e.defining_vector(a) * centre[a];
      for (int b = 0; b < 3; ++b) {
        square += e.defining_matrix(a, b) * axis[i][a] * axis[i][b];
        constant += e.defining_matrix(a, b) * centre[a] * centre[b];
      }
    }
    x = std::sqrt(-constant / square);
    std::printf("  axis %d: length %.3f, direction (%.3f, %.3f, %.3f); along it the surface is %.3f away, by the matrix %.3f\n", i, length[i],
                axis[i][0], axis[i][1], axis[i][2], 1 / std::sqrt(inverse), x);
    as_described = as_described && std::abs(length[i] / radii[i] - 1) < 0.01 && std::abs(1 / std::sqrt(inverse) / radii[2 - i] - 1) < 0.01 &&
                   std::abs(x / radii[2 - i] - 1) < 0.01;
  }
  int outside = 0, out_of_box = 0, outside_reversed = 0;
  for (const auto& point : points) {
    const Vector x = {point.x() - centre[0], point.y() - centre[1], point.z() - centre[2]};
    double level = 0, reversed = 0, most = 0;
    for (int i = 0; i < 3; ++i) {
      level += std::pow(dot(x, axis[i]) / length[i], 2);
      reversed += std::pow(dot(x, axis[i]) / length[2 - i], 2);
      most = std::fmax(most, std::abs(dot(x, axis[i])) / length[i]);
    }
    outside += level > 1.01;
    outside_reversed += reversed > 1.01;
    out_of_box += most > 1.01;
  }
  std::printf("  of %zu points are outside of the ellipsoid of these axes %d, of its box %d; with the lengths reversed %d\n", points.size(), outside,
              out_of_box, outside_reversed);
  as_described = as_described && outside > 100 && out_of_box > 80 && outside_reversed == 0;
  // In the plane.
  std::vector<K::Point_2> ring;
  for (int i = 0; i < 60; ++i) {
    const double t = i * CGAL_PI / 30, x = 3 * std::cos(t), y = std::sin(t);
    ring.emplace_back(x * std::cos(0.5) - y * std::sin(0.5), x * std::sin(0.5) + y * std::cos(0.5));
  }
  Ellipse f(0.001, ring.begin(), ring.end());
  double span[2], angle[2];
  for (int i = 0; i < 2; ++i) {
    span[i] = f.axes_lengths_begin()[i];
    const auto d = f.axis_direction_cartesian_begin(i);
    angle[i] = std::remainder(std::atan2(d[1], d[0]), CGAL_PI);
  }
  std::printf("ellipse of 3, 1 turned by 0.5: axis 0 has %.3f at %.3f, axis 1 has %.3f at %.3f\n", span[0], angle[0], span[1], angle[1]);
  as_described = as_described && std::abs(span[0] - 1) < 0.01 && std::abs(span[1] - 3) < 0.03 &&
                 std::abs(std::remainder(angle[1] - 0.5, CGAL_PI)) < 0.01 && std::abs(std::remainder(angle[0] - 0.5 - CGAL_PI / 2, CGAL_PI)) < 0.01;
  return !as_described;
}
C
status=0
echo "CGAL $version"
for eigen in "" "-DCGAL_EIGEN3_ENABLED -I root/usr/include/eigen3"; do
  if [ -n "$eigen" ]; then echo 'with Eigen:'; else echo 'without Eigen:'; fi
  # shellcheck disable=SC2086
  c++ -std=c++17 -O1 -w $eigen -I root/usr/include -I "$folder/root/usr/include/x86_64-linux-gnu" ellipsoid.cpp -o ellipsoid -L "$lib" -lmpfr -lgmp
  LD_LIBRARY_PATH=$lib ./ellipsoid || status=1
done
exit $status
