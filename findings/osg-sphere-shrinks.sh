#!/bin/sh
# OpenSceneGraph 3.6.5 (Debian 12): BoundingSphere::expandBy(box), 'expands the sphere to encompass the given box', loses part of the sphere, and
# may make it smaller. A ball of radius 1 expanded by a small box within it, 0.55 to one side, has radius 0.81 and is moved away from the box; a
# fifth of its width is no longer inside. The sphere is rebuilt from a box, made of the given one and, for each corner, of the point of the sphere
# that is opposite to it, but of no other points of the sphere. If the box is wide, or reaches far out on one side, that is enough; if it lies
# within the sphere, where nothing need change at all, it is not: two of three boxes of random size and place within the ball push part of it out,
# by up to 0.6, and so do a few that stick out a little. Expanding by the eight corners one by one, by the sphere of the box, or with
# expandRadiusBy(box) is right, as is expandBy(box) on an unset sphere. Nothing is said.
set -eu
version=3.6.5+dfsg1-8+b2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libopenscenegraph-dev=$version" 2> /dev/null
dpkg -x libopenscenegraph-dev*.deb root
cat > sphere.cpp <<'C'
#include <osg/BoundingBox>
#include <osg/BoundingSphere>
#include <osg/Version>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
typedef osg::BoundingSphered Sphere;
typedef osg::BoundingBoxd Box;
typedef osg::Vec3d Vec;
static bool same(double a, double b) { return std::abs(a - b) < 1e-9 * (1 + std::abs(b)); }
// By how much one sphere sticks out of another, and the farthest corner of a box.
static double out(const Sphere& inner, const Sphere& outer) { return (inner.center() - outer.center()).length() + inner.radius() - outer.radius(); }
static double out(const Box& box, const Sphere& outer) {
  double d = 0;
  for (int c = 0; c < 8; ++c) d = std::max(d, (box.corner(c) - outer.center()).length());
  return d - outer.radius();
}
int main() {
  std::printf("OpenSceneGraph %d.%d.%d\n", OPENSCENEGRAPH_MAJOR_VERSION, OPENSCENEGRAPH_MINOR_VERSION, OPENSCENEGRAPH_PATCH_VERSION);
  bool as_described = true;
  const double t = .05;
  std::printf("ball of radius 1 in the origin, and a box of side 0.1 at x, y = z = 0:\n");
  for (double x : {0., .1, .3, .55, .8, .94, 1.05, 1.2, 3.}) {
    const Sphere ball(Vec(0, 0, 0), 1);
    const Box box(x - t, -t, -t, x + t, t, t);
    Sphere got = ball, corners = ball, by_sphere = ball, radius = ball;
    got.expandBy(box);
    for (int c = 0; c < 8; ++c) corners.expandBy(box.corner(c));
    by_sphere.expandBy(Sphere(box));
    radius.expandRadiusBy(box);
    // The cause: the box of the given one and of the points opposite to its corners.
    Box rebuilt = box;
    for (int c = 0; c < 8; ++c) rebuilt.expandBy(-box.corner(c) / box.corner(c).length());
    std::printf("  x = %.2f: centre %.4f, radius %.4f; ball sticks out by %.4f, box by %.4f; by corners: centre %.4f, radius %.4f, ball sticks out by %.1g\n", x, got.center().x(), got.radius(),
                std::max(0., out(ball, got)), std::max(0., out(box, got)), corners.center().x(), corners.radius(), std::max(0., out(ball, corners)));
    as_described = as_described && same(got.radius(), rebuilt.radius()) && same((got.center() - rebuilt.center()).length(), 0);
    for (const Sphere& right : {corners, by_sphere, radius}) as_described = as_described && out(ball, right) < 1e-9 && out(box, right) < 1e-9 && (x > .9 || (same(right.radius(), 1) && same(right.center().length(), 0)));
    as_described = as_described && out(box, got) < 1e-9;
    if (x >= .1 && x < .9) as_described = as_described && got.radius() < 1 && out(ball, got) > .1;
    if (x == 0 || x == 3) as_described = as_described && out(ball, got) < 1e-9;
    if (x == .55) as_described = as_described && got.radius() < .82 && got.center().x() < -.19;
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2, 2), half(.02, .6);
  int count[3] = {0, 0, 0}, lost[3] = {0, 0, 0}, smaller[3] = {0, 0, 0};
  double worst[3] = {0, 0, 0};
  for (int k = 0; k < 400000; ++k) {
    const Sphere ball(Vec(0, 0, 0), 1);
    const Vec c(place(random), place(random), place(random)), h(half(random), half(random), half(random));
    const Box box(c - h, c + h);
    double nearest = 0;
    for (int i = 0; i < 3; ++i) nearest += std::pow(std::max(0., std::abs(c[i]) - h[i]), 2);
    const int kind = out(box, ball) <= 0 ? 0 : nearest < 1 ? 1 : 2;
    Sphere got = ball;
    got.expandBy(box);
    ++count[kind];
    smaller[kind] += got.radius() < 1 - 1e-9;
    lost[kind] += out(ball, got) > 1e-3;
    worst[kind] = std::max(worst[kind], out(ball, got));
    as_described = as_described && out(box, got) < 1e-9;
  }
  as_described = as_described && lost[0] > .6 * count[0] && lost[0] < .75 * count[0] && smaller[0] > 0 && worst[0] > .5 && lost[1] > 0 && lost[1] < .02 * count[1] && lost[2] == 0;
  const char* names[] = {"within the ball", "partly within", "outside"};
  for (int kind = 0; kind < 3; ++kind)
    std::printf("%6d boxes %-15s: %5.1f%% made the ball smaller; %5.1f%% pushed part of it out, at most by %.3f\n", count[kind], names[kind], 100. * smaller[kind] / count[kind],
                100. * lost[kind] / count[kind], worst[kind]);
  return as_described ? 0 : 1;
}
C
g++ -O1 -w -I"$(dirname "$(dirname "$(find root -name BoundingSphere)")")" sphere.cpp -o sphere
./sphere
