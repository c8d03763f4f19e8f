#!/bin/sh
# DART 6.12.1 (Debian 12): the convex hull of few contact points is not always one, and with it the support polygon of a robot. Up to three points
# computeConvexHull() returns as they come, 'already a convex hull', in either direction, while isInsideSupportPolygon() takes them to be
# counter-clockwise: a triangle given clockwise has nothing inside, so that it is for the order of three contacts to say whether a robot stands.
# Of four points it returns all four even if one lies within the triangle of the others (its test for 'three or fewer unique points' leaves the
# lowest out of the count): the polygon is dented, its centroid another, and a point in the dent, well supported, is outside. The same with a
# fifth in the direction of the fourth from the lowest, as one of the two is thrown out before. With five in general position Graham's scan is
# made and all is right. Besides, a point on the line of an edge parallel to y is inside however far beyond its end, as x alone is compared with the
# ends. Skeleton::getSupportPolygon() and getSupportCentroid() use these functions. Nothing is said.
set -eu
version=6.12.1+dfsg4-12+b2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libdart6.12=$version" "libdart-dev=$version" "libdart-external-odelcpsolver6.12=$version" \
  "libdart-external-convhull-3d-dev=$version" libeigen3-dev=3.4.0-4 libfcl0.7=0.7.0-3+b1 libccd2=2.1-2+b1 liboctomap1.9=1.9.7+dfsg-3+b1 \
  libassimp5=5.2.5~ds0-1+b1 libassimp-dev=5.2.5~ds0-1+b1 libboost-filesystem1.74.0 libdraco7 libminizip1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libdart.so.6.12')")
cat > support.cpp <<'C'
#include <dart/config.hpp>
#include <dart/math/Geometry.hpp>
#include <cmath>
#include <cstdio>
#include <initializer_list>
using namespace dart::math;
using Point = Eigen::Vector2d;
static SupportPolygon polygon(std::initializer_list<Point> points) {
  SupportPolygon p;
  for (const Point& x : points) p.push_back(x);
  return p;
}
static void show(const char* what, const SupportPolygon& hull) {
  std::printf("%-46s", what);
  for (const Point& x : hull) std::printf(" (%g, %g)", x[0], x[1]);
}
int main() {
  std::printf("DART %s\n", DART_VERSION);
  bool as_described = true;
  // A triangle with corners (0, 0), (2, 0), (0, 2), both ways round, and a point well within it.
  const Point within(0.5, 0.5), firm(0.9, 0.9);
  for (int clockwise = 0; clockwise < 2; ++clockwise) {
    const Point a(2, 0), b(0, 2);
    const SupportPolygon hull = computeConvexHull(polygon({Point(0, 0), clockwise ? b : a, clockwise ? a : b}));
    const bool inside = isInsideSupportPolygon(within, hull);
    show(clockwise ? "three points, clockwise:" : "three points, counter-clockwise:", hull);
    std::printf(": (0.5, 0.5) is %s\n", inside ? "inside" : "outside");
    as_described = as_described && inside == !clockwise;
  }
  // The same triangle and further points within it.
  const struct {
    const char* what;
    SupportPolygon points;
    bool right;
  } cases[] = {{"a fourth within:", polygon({Point(0, 0), Point(2, 0), Point(0.5, 0.5), Point(0, 2)}), false},
               {"two within, in a line with (0, 0):", polygon({Point(0, 0), Point(2, 0), Point(0.5, 0.5), Point(0.6, 0.6), Point(0, 2)}), false},
               {"two within, in two directions:", polygon({Point(0, 0), Point(2, 0), Point(0.5, 0.5), Point(0.6, 0.5), Point(0, 2)}), true}};
  for (const auto& c : cases) {
    const SupportPolygon hull = computeConvexHull(c.points);
    const Point centroid = computeCentroidOfHull(hull);
    const bool inside = isInsideSupportPolygon(firm, hull);
    show(c.what, hull);
    std::printf(": centroid (%.4f, %.4f), (0.9, 0.9) is %s\n", centroid[0], centroid[1], inside ? "inside" : "outside");
    const bool right = hull.size() == 3 && inside && (centroid - Point(2, 2) / 3).norm() < 1e-9;
    const bool wrong = hull.size() == 4 && !inside && (centroid - Point(2, 2) / 3).norm() > 0.15;
    as_described = as_described && (c.right ? right : wrong);
  }
  // A square, its hull right, and points on the lines of its edges, 3 beyond the corner.
  const SupportPolygon square = computeConvexHull(polygon({Point(0, 0), Point(2, 0), Point(2, 2), Point(0, 2), Point(1, 1)}));
  const bool above = isInsideSupportPolygon(Point(2, 5), square), beside = isInsideSupportPolygon(Point(5, 2), square);
  show("square:", square);
  std::printf(": (2, 5) is %s, (5, 2) is %s\n", above ? "inside" : "outside", beside ? "inside" : "outside");
  return !(as_described && square.size() == 4 && above && !beside);
}
C
c++ -std=c++17 -O0 -w -I root/usr/include -I root/usr/include/eigen3 support.cpp -o support -L "$lib" -ldart -Wl,-rpath-link,"$lib" \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./support
