#!/bin/sh
# manif 0.0.5 (Debian 13, Lie groups for robotics): interpolate() by INTERP_METHOD::CUBIC runs backwards. The header has 'mc=ma if t=0, mc=mb if t=1';
# it is b at 0 and a at 1, so that a path through several poses jumps back at each of them. interpolate_cubic() forms l from a, with the weight h00
# where Hermite's formula has h01, and r from b, and then r + (l - r), which is l whatever r is: the velocity at the end, tb, is never used, and
# the one at the start, ta, acts where b is. In the middle and without velocities it is right, as are SLERP and CNSMOOTH. decasteljau(), in the same
# folder, that fits a smooth curve to a trajectory, leaves off the rest of it: (n - degree) / ((degree - 1) + 1) segments for (n - degree) /
# (degree - 1) + 1, a parenthesis, though they are taken at steps of degree - 1. With degree 3 the curve of 30 poses ends at the 19th, with degree 2
# half way, and of as many poses as the degree there is no curve at all. Nothing is said. bezier.h has the right count.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Debian 13's packages, whatever release this is; the sources are the machine's own with the name exchanged.
mkdir -p apt/parts apt/lists/partial apt/cache/archives/partial
for source in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
  [ -f "$source" ] && sed 's/bookworm/trixie/g' "$source" > "apt/parts/debian.${source##*.}"
done
from() {
  command=$1
  shift
  "apt-$command" -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$folder/apt/parts" -o "Dir::State::lists=$folder/apt/lists" \
    -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User=root -qq "$@"
}
from get update
from get download libmanif-dev=0.0.5-6 libtl-optional-dev=1.1.0-2 libeigen3-dev=3.4.0-5
for package in *.deb; do dpkg -x "$package" root; done
cat > path.cpp <<'C'
#include <manif/manif.h>
#include <manif/algorithms/decasteljau.h>
#include <manif/algorithms/interpolation.h>
#include <cmath>
#include <cstdio>
using namespace manif;
static bool as_described = true;
static bool is(double a, double b) { return std::abs(a - b) < 1e-9; }
int main() {
  // In the plane, where the group is that of vectors, the curve is known: Hermite's.
  const R2d a(Eigen::Vector2d(0, 0)), b(Eigen::Vector2d(1, 0));
  const R2Tangentd ta(Eigen::Vector2d(1, 0)), tb(Eigen::Vector2d(0, 5)), none(Eigen::Vector2d(0, 0));
  std::puts("from (0,0) with velocity (1,0) to (1,0) with velocity (0,5)");
  for (double t : {0., 0.25, 0.5, 0.75, 1.}) {
    const double t2 = t * t, t3 = t2 * t, h00 = 2 * t3 - 3 * t2 + 1, h01 = 1 - h00, h10 = t3 - 2 * t2 + t, h11 = t3 - t2;
    const auto cubic = interpolate(a, b, t, INTERP_METHOD::CUBIC, ta, tb).coeffs();
    const auto without = interpolate(a, b, t, INTERP_METHOD::CUBIC, ta, none).coeffs();
    const auto slerp = interpolate(a, b, t).coeffs();
    const auto smooth = interpolate(a, b, t, INTERP_METHOD::CNSMOOTH, ta, tb).coeffs();
    std::printf("  t = %.2f: CUBIC (%.3f, %.3f), should be (%.3f, %.3f); SLERP %.3f, CNSMOOTH %.3f\n", t, cubic[0], cubic[1], h01 + h10, 5 * h11,
                slerp[0], smooth[0]);
    as_described = as_described && is(cubic[0], h00 + h10) && is(cubic[1], 0) && cubic == without && is(slerp[0], t);
    if (t == 0 || t == 1) as_described = as_described && is(smooth[0], t) && is(cubic[0], 1 - t);
  }
  const SO3d level = SO3d::Identity(), turned(0, 0, 1.);
  const SE2d here(0, 0, 0), there(4, 2, 1.5);
  for (double t : {0., 0.5, 1.}) {
    const double angle = interpolate(level, turned, t, INTERP_METHOD::CUBIC).log().coeffs()[2];
    const SE2d pose = interpolate(here, there, t, INTERP_METHOD::CUBIC), straight = interpolate(here, there, t);
    std::printf("  t = %.2f: rotation from 0 to 1: %.3f; pose, (0, 0; 0) to (4, 2; 1.5): (%.2f, %.2f; %.2f), SLERP (%.2f, %.2f; %.2f)\n", t, angle,
                pose.x(), pose.y(), pose.angle(), straight.x(), straight.y(), straight.angle());
    const SE2d back = interpolate(here, there, 1 - t);
    as_described = as_described && is(angle, 1 - t) && is(pose.x(), back.x()) && is(pose.y(), back.y()) && is(pose.angle(), back.angle());
  }
  std::puts("a path through x = 0, 1, 2 at t = 0, 1, 2");
  const R1d points[] = {R1d(R1d::DataType(0.)), R1d(R1d::DataType(1.)), R1d(R1d::DataType(2.))};
  const double seen[] = {0.896, 0.104, 1.896, 1.104};
  int next = 0;
  for (int i = 0; i < 2; ++i)
    for (double t : {0.2, 0.8}) {
      const double x = interpolate(points[i], points[i + 1], t, INTERP_METHOD::CUBIC).coeffs()[0];
      std::printf("  t = %.1f: x = %.3f\n", i + t, x);
      as_described = as_described && is(x, seen[next++]);
    }
  std::puts("de Casteljau, poses at x = 0, 1, .. on a line");
  const struct { unsigned degree; int poses; double end; } fits[] = {
      {2, 30, 14}, {3, 30, 18}, {4, 31, 18}, {3, 7, 2}, {3, 3, -1}, {4, 4, -1}, {4, 7, -1}};
  for (const auto& f : fits) {
    std::vector<SE2d> trajectory;
    for (int i = 0; i < f.poses; ++i) trajectory.push_back(SE2d(i, 0, 0));
    const auto curve = decasteljau(trajectory, f.degree, 10);
    const int whole = (f.poses - f.degree) / (f.degree - 1) + 1, last = whole * (f.degree - 1);
    if (curve.empty())
      std::printf("  degree %u, %d poses: no curve; %d segments fit, to x = %d\n", f.degree, f.poses, whole, last);
    else
      std::printf("  degree %u, %d poses: ends at x = %.2f; %d segments fit, to x = %d\n", f.degree, f.poses, curve.back().x(), whole, last);
    as_described = as_described && (f.end < 0 ? curve.empty() : !curve.empty() && is(curve.back().x(), f.end));
  }
  return !as_described;
}
C
c++ -std=c++17 -O1 -w -I root/usr/include -I root/usr/include/eigen3 path.cpp -o path
echo "manif 0.0.5"
./path
