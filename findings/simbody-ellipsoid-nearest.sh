#!/bin/sh
# Simbody 3.7 (Debian 12): ContactGeometry::Ellipsoid::findNearestPoint() returns points that do not lie on the ellipsoid. It takes the largest real
# root t of a polynomial of degree 6, got by multiplying with (t + a^2)^2 (t + b^2)^2 (t + c^2)^2, and the point (a^2 x/(t + a^2), ..). For a point
# in the symmetry plane across the shortest axis, x = 0, and not too near its rim, the largest root is the factor's own, t = -a^2; what should be
# the coordinate that leaves the plane, 0/0, comes out as 0, and the 'nearest point' lies in the plane, deep within the body. It is so for two
# thirds of all points of that plane within the ellipsoid of 1, 2, 3, for the middle of the long axis, and for the equatorial plane of a flattened
# spheroid. `inside` and a unit normal come with it as usual. The other two planes, points beside the plane and points outside are right.
# Moreover a root counts as real if its imaginary part is below 1e-10, whatever the size: with the ellipsoid of 1, 2, 3 millimetres in metres,
# Simbody's unit, 3 % of the points around it get the centre, where the same in millimetres is right. Nothing is said; by the header it is 'the
# point on the surface of the object which is closest'.
set -eu
version=3.7+dfsg-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libsimbody3.7=$version" "libsimbody-dev=$version" libblas3 liblapack3 libgfortran5 libquadmath0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libSimTKmath.so.3.7')")
cat > nearest.cpp <<'C'
#include <SimTKmath.h>
#include <cmath>
#include <cstdio>
#include <random>
using namespace SimTK;
/* The distance of q from the ellipsoid, by trying. */
static double tried(const Vec3& r, const Vec3& q) {
  double least = 1e9, u0 = 0, v0 = 0;
  for (int level = 0; level < 6; ++level) {
    const double step = 0.05 / std::pow(8, level), n = level ? 16 : 126;
    const double u1 = u0, v1 = v0;
    for (int i = level ? -16 : -32; i <= (level ? 16 : 32); ++i)
      for (int j = -n; j <= n; ++j) {
        const double u = u1 + step * i, v = v1 + step * j;
        const double d = (Vec3(r[0] * cos(u) * cos(v), r[1] * cos(u) * sin(v), r[2] * sin(u)) - q).norm();
        if (d < least) least = d, u0 = u, v0 = v;
      }
  }
  return least;
}
static double level(const Vec3& r, const Vec3& p) { return p[0] * p[0] / (r[0] * r[0]) + p[1] * p[1] / (r[1] * r[1]) + p[2] * p[2] / (r[2] * r[2]); }
int main() {
  bool as_described = true, inside;
  UnitVec3 normal;
  const struct {
    const char* what;
    Vec3 radii, point;
    bool right;
  } cases[] = {{"in the plane across the shortest axis", Vec3(1, 2, 3), Vec3(0, 0.5, 0.5), false},
               {"0.001 beside that plane", Vec3(1, 2, 3), Vec3(0.001, 0.5, 0.5), true},
               {"in the plane, near the rim", Vec3(1, 2, 3), Vec3(0, 1.8, 0.5), true},
               {"in the plane across the middle axis", Vec3(1, 2, 3), Vec3(0.3, 0, 0.5), true},
               {"on the long axis", Vec3(1, 2, 3), Vec3(0, 0, 1), false},
               {"in the equator's plane of a flattened spheroid", Vec3(2, 2, 1), Vec3(0.5, 0.3, 0), false}};
  for (const auto& c : cases) {
    const Vec3 p = ContactGeometry::Ellipsoid(c.radii).findNearestPoint(c.point, inside, normal);
    const double f = level(c.radii, p), d = (p - c.point).norm(), least = tried(c.radii, c.point);
    std::printf("radii %g %g %g, (%g, %g, %g), %s: (%.4f, %.4f, %.4f), level %.4f, should be 1; distance %.4f, least %.4f\n", c.radii[0], c.radii[1],
                c.radii[2], c.point[0], c.point[1], c.point[2], c.what, p[0], p[1], p[2], f, d, least);
    const bool right = std::abs(f - 1) < 1e-6 && std::abs(d - least) < 1e-3, wrong = f < 0.9 && std::abs(d - least) > 0.3;
    as_described = as_described && inside && (c.right ? right : wrong);
  }
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> some(-1, 1);
  const Vec3 radii(1, 2, 3);
  int n = 0, off = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 q(0, 2 * some(generator), 3 * some(generator));
    if (level(radii, q) >= 1) continue;
    ++n;
    off += level(radii, ContactGeometry::Ellipsoid(radii).findNearestPoint(q, inside, normal)) < 0.999;
  }
  std::printf("points in the plane, within: %.0f %% of %d have a 'nearest point' inside the ellipsoid\n", 100. * off / n, n);
  as_described = as_described && off > 0.5 * n;
  // All about, with the same points in two units.
  for (double unit : {1., 0.001}) {
    int wrong = 0, centre = 0, refused = 0, m = 2000;
    double farthest = 0;
    std::mt19937 again(2);
    for (int i = 0; i < m; ++i) {
      const Vec3 q = Vec3(4 * some(again), 4 * some(again), 4 * some(again));
      try {
        const Vec3 p = ContactGeometry::Ellipsoid(unit * radii).findNearestPoint(unit * q, inside, normal);
        const double f = level(unit * radii, p);
        wrong += !(std::abs(f - 1) < 0.01);
        centre += p.norm() < 1e-6 * unit;
        farthest = std::fmax(farthest, p.norm());
      } catch (const std::exception&) {
        ++refused;
      }
    }
    std::printf("radii %g %g %g, %d points all about: %d off the surface, %d of these the centre; the farthest is %g from it; %d refused\n", unit,
                2 * unit, 3 * unit, m, wrong, centre, farthest, refused);
    as_described = as_described && (unit == 1 ? wrong == 0 && refused == 0 : wrong > 0.01 * m && centre > 0);
  }
  return !as_described;
}
C
c++ -std=c++17 -O1 -w -I root/usr/include/simbody nearest.cpp -o nearest -L "$lib" -lSimTKmath -lSimTKcommon -Wl,-rpath-link,"$lib" \
  -Wl,--allow-shlib-undefined
echo "Simbody $version"
LD_LIBRARY_PATH=$lib:$lib/lapack:$lib/blas ./nearest
