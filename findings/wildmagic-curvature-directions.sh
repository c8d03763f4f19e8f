#!/bin/sh
# Wild Magic 5.17 (Debian 12): on implicit surfaces, such as quadrics, the principal directions belong to the other curvature. Of
# ImplicitSurface::ComputePrincipalCurvatureInfo(), whose header has 'the principal curvatures and the corresponding principal directions', the
# curvatures are right; the directions come from M + curv0 I, with M = -dN, whose null vector is the direction of curv0, and this goes to dir1,
# while dir0 is the vector square to it. So dir0 is where the surface is bent by curv1, at every point of every surface: on a bowl that is twice as
# steep along y the lesser curvature has the direction y, and lines of curvature run the wrong way. ParametricSurface, for the same surface as a
# patch, puts each to its own. As both vectors are principal ones and square to each other, nothing looks wrong, and on balls there is no
# difference. Where curv0 is 0, as on cylinders and cones, M + curv0 I has no single null vector: noise, or 0/0. Nothing is said.
set -eu
version=5.17+cleaned1-6
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libwildmagic-dev=$version" "libwildmagic5=$version" "libwildmagic-common=$version" 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libWm5Mathematics.so')")
cat > curvature.cpp <<'C'
#include <Wm5Mathematics.h>
#include <cmath>
#include <cstdio>
using namespace Wm5;
// The patch z = a x^2 + b y^2, with the normal of the implicit a x^2 + b y^2 - z, which points down.
struct Patch : ParametricSurfaced {
  double a, b;
  Patch(double a, double b) : ParametricSurfaced(-9, 9, -9, 9, true), a(a), b(b) {}
  Vector3d P(double v, double u) const { return {u, v, a * u * u + b * v * v}; }
  Vector3d PU(double v, double) const { return {0, 1, 2 * b * v}; }
  Vector3d PV(double, double u) const { return {1, 0, 2 * a * u}; }
  Vector3d PUU(double, double) const { return {0, 0, 2 * b}; }
  Vector3d PUV(double, double) const { return {0, 0, 0}; }
  Vector3d PVV(double, double) const { return {0, 0, 2 * a}; }
};
// The curvature of the section of F = 0 through the normal and a direction.
static double section(const ImplicitSurfaced& f, const Vector3d& p, const Vector3d& d) { return f.GetHessian(p).QForm(d, d) / f.GetGradient(p).Length(); }
static bool same(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(b)); }
static bool parallel(const Vector3d& a, const Vector3d& b) { return std::abs(std::abs(a.Dot(b)) - 1) < 1e-9; }
int main() {
  std::printf("Wild Magic 5.17\n");
  bool as_described = true;
  for (double b : {2., -1.}) {
    const double coefficients[10] = {0, 0, 0, -1, 1, 0, 0, b, 0, 0};
    QuadricSurfaced f(coefficients);
    Patch patch(1, b);
    for (double x : {0., .5}) {
      const double y = .4 * x;
      const Vector3d p(x, y, x * x + b * y * y);
      double k[2], q[2];
      Vector3d d[2], e[2];
      f.ComputePrincipalCurvatureInfo(p, k[0], k[1], d[0], d[1]);
      patch.ComputePrincipalCurvatureInfo(y, x, q[0], q[1], e[0], e[1]);
      std::printf("z = x^2 %+g y^2 at (%g, %g): curvatures %.4f %.4f\n", b, x, y, k[0], k[1]);
      for (int i = 0; i < 2; ++i)
        std::printf("  direction %d: (%.3f, %.3f, %.3f), where the section has %.4f; of the patch %.4f, (%.3f, %.3f, %.3f), section %.4f\n", i, d[i][0], d[i][1],
                    d[i][2], section(f, p, d[i]), q[i], e[i][0], e[i][1], e[i][2], section(f, p, e[i]));
      for (int i = 0; i < 2; ++i)
        as_described = as_described && same(section(f, p, d[i]), k[1 - i]) && same(section(f, p, e[i]), q[i]) && same(q[i], k[i]) && parallel(d[i], e[1 - i]);
    }
  }
  // An ellipsoid of half axes 1, 2, 3, all over its surface.
  const double coefficients[10] = {-1, 0, 0, 0, 1, 0, 0, .25, 0, 1 / 9.};
  QuadricSurfaced f(coefficients);
  int points = 0, crossed = 0, right = 0;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const double z = (i + .5) / 10 - 1, r = std::sqrt(1 - z * z), a = 2 * M_PI * (j + .5) / 20;
      const Vector3d p(r * std::cos(a), 2 * r * std::sin(a), 3 * z);
      double k[2];
      Vector3d d[2];
      f.ComputePrincipalCurvatureInfo(p, k[0], k[1], d[0], d[1]);
      ++points;
      crossed += same(section(f, p, d[0]), k[1]) && same(section(f, p, d[1]), k[0]);
      right += same(section(f, p, d[0]), k[0]) && same(section(f, p, d[1]), k[1]);
    }
  std::printf("ellipsoid 1 2 3: of %d points %d have each direction with its own curvature, %d with the other one\n", points, right, crossed);
  return as_described && right == 0 && crossed == points ? 0 : 1;
}
C
g++ -O1 -w -Iroot/usr/include/libwildmagic curvature.cpp -o curvature -L"$lib" -lWm5Mathematics -lWm5Core
LD_LIBRARY_PATH=$lib ./curvature
