#!/bin/sh
# Wild Magic 5.17 (Debian 12): MergeEllipsoids(), 'construct a bounding ellipsoid for the two input ellipsoids', gives one that holds neither, as
# does MergeEllipses() in the plane. It averages the axes, projects both ellipsoids onto each of them, and takes the halves of the intervals, which
# are the half sides of the box about both, for the half axes of the ellipsoid; but the ellipsoid in a box leaves out its corners, where the two
# may lie. Of two balls of radius 1, 6 apart, it makes 4, 1, 1, which has 0.66 where the balls are 1 thick. Of 200 pairs in random position none is
# enclosed, and 44 % of their surfaces lie outside, so that a hierarchy of bounds built with it loses hits. Half axes longer by the root of 3 (of 2
# in the plane) would always do. It is right where one ellipsoid lies within the other and has its axes, and looks right in each projection onto an
# axis. MergeSpheres(), ContEllipsoid() of points and the projections themselves are right. Nothing is said.
set -eu
version=5.17+cleaned1-6
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libwildmagic-dev=$version" "libwildmagic5=$version" "libwildmagic-common=$version" 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libWm5Mathematics.so')")
cat > merge.cpp <<'C'
#include <Wm5Mathematics.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>
using namespace Wm5;
// Points of the surface, and the share of them outside of another ellipsoid.
static std::vector<Vector3d> surface(const Ellipsoid3d& e) {
  std::vector<Vector3d> p;
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const double z = (i + .5) / 20 - 1, r = std::sqrt(1 - z * z), a = 2 * M_PI * (j + .5) / 40;
      p.push_back(e.Center + e.Extent[0] * r * std::cos(a) * e.Axis[0] + e.Extent[1] * r * std::sin(a) * e.Axis[1] + e.Extent[2] * z * e.Axis[2]);
    }
  return p;
}
static double outside(const Ellipsoid3d& bound, const Ellipsoid3d& e) {
  int n = 0;
  const std::vector<Vector3d> points = surface(e);
  for (const Vector3d& p : points) n += bound.Evaluate(p) > 1e-9;
  return double(n) / points.size();
}
static Ellipsoid3d ellipsoid(const Vector3d& c, const Matrix3d& r, double x, double y, double z) {
  return Ellipsoid3d(c, r.GetColumn(0), r.GetColumn(1), r.GetColumn(2), x, y, z);
}
int main() {
  std::printf("Wild Magic 5.17\n");
  const Matrix3d one = Matrix3d::IDENTITY;
  const Ellipsoid3d a = ellipsoid({-3, 0, 0}, one, 1, 1, 1), b = ellipsoid({3, 0, 0}, one, 1, 1, 1), both = MergeEllipsoids(a, b);
  std::printf("two balls of radius 1 at x = -3 and 3: half axes %g %g %g; %.0f and %.0f %% of their surfaces outside; at (3, 0, 1) %g (inside is below 0)\n",
              both.Extent[0], both.Extent[1], both.Extent[2], 100 * outside(both, a), 100 * outside(both, b), both.Evaluate({3, 0, 1}));
  bool as_described = both.Extent[0] == 4 && both.Extent[1] == 1 && both.Extent[2] == 1 && std::abs(both.Evaluate({3, 0, 1}) - .5625) < 1e-12 &&
                      outside(both, a) > .25 && outside(both, b) > .25;
  const Ellipse2d flat = MergeEllipses(Ellipse2d({-3, 0}, {1, 0}, {0, 1}, 1, 1), Ellipse2d({3, 0}, {1, 0}, {0, 1}, 1, 1));
  std::printf("two circles likewise: half axes %g %g; at (3, 1) %g\n", flat.Extent[0], flat.Extent[1], flat.Evaluate({3, 1}));
  as_described = as_described && flat.Extent[0] == 4 && flat.Extent[1] == 1 && std::abs(flat.Evaluate({3, 1}) - .5625) < 1e-12;
  const Sphere3d ball = MergeSpheres(Sphere3d({-3, 0, 0}, 1), Sphere3d({3, 0, 0}, 1));
  std::printf("MergeSpheres: radius %g\n", ball.Radius);
  const Ellipsoid3d within = MergeEllipsoids(ellipsoid({0, 0, 0}, one, 5, 4, 3), ellipsoid({.5, 0, 0}, one, 1, 1, 1));
  std::printf("5 4 3 and a ball within: half axes %g %g %g\n", within.Extent[0], within.Extent[1], within.Extent[2]);
  as_described = as_described && std::abs(ball.Radius - 4) < 1e-12 && within.Extent[0] == 5 && within.Extent[1] == 4 && within.Extent[2] == 3;
  std::mt19937 random(1);
  auto uniform = [&] { return random() / 4294967296.0; };
  int enclosed = 0, of_points = 0, widened = 0;
  double share = 0;
  for (int k = 0; k < 200; ++k) {
    Ellipsoid3d e[2];
    for (Ellipsoid3d& x : e) {
      Vector3d axis(uniform() - .5, uniform() - .5, uniform() - .5);
      axis.Normalize();
      x = ellipsoid({4 * uniform(), 4 * uniform(), 4 * uniform()}, Matrix3d(axis, 6 * uniform()), .5 + uniform(), .5 + uniform(), .5 + uniform());
    }
    Ellipsoid3d m = MergeEllipsoids(e[0], e[1]);
    const double out = (outside(m, e[0]) + outside(m, e[1])) / 2;
    enclosed += out == 0, share += out / 200;
    for (double& x : m.Extent) x *= std::sqrt(3);
    widened += outside(m, e[0]) + outside(m, e[1]) == 0;
    std::vector<Vector3d> points = surface(e[0]), more = surface(e[1]);
    points.insert(points.end(), more.begin(), more.end());
    m = ContEllipsoid(int(points.size()), &points[0]);
    of_points += outside(m, e[0]) + outside(m, e[1]) == 0;
  }
  std::printf("200 random pairs: %d enclosed, %.0f %% of the surfaces outside; with half axes longer by the root of 3 %d enclosed; ContEllipsoid of points %d\n",
              enclosed, 100 * share, widened, of_points);
  return as_described && enclosed == 0 && share > .15 && widened == 200 && of_points == 200 ? 0 : 1;
}
C
g++ -O1 -w -Iroot/usr/include/libwildmagic merge.cpp -o merge -L"$lib" -lWm5Mathematics -lWm5Core
LD_LIBRARY_PATH=$lib ./merge
