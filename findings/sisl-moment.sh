#!/bin/sh
# SISL 4.6.0 (Debian 12): s1243() gives area, centre and 'rotational momentum' of the area between a plane curve and a point. Area and centre are
# right. The moment, the integral of the squared distance to the point, has for the triangle from the point to an edge the factor |a x b|, twice its
# area; s1245() divides by it. So the moment has no unit: of a square about its middle it is 2/3 for every size, where it should grow with the
# fourth power, and of an edge cut in two the two halves give more than the whole. About a corner of the figure, where two triangles
# are flat and should count nothing, it is infinite. For curves the sum is divided by 4 at each bisection, which fits neither. A rectangle of
# 2 x 1 about its middle, whose triangles all have |a x b| = 1, comes out right, and so might a first test. The status is 0 in all cases.
set -eu
version=4.6.0-2+b1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libsisl-dev=$version"
dpkg -x libsisl-dev_*.deb root
cat > moment.c <<'C'
#include <math.h>
#include <sisl.h>
#include <stdio.h>
static int sound = 1; /* area and centre right, status 0, in all cases */
/* The moment by s1243() about `about`; prints it beside the exact one. */
static double moment(const char* what, SISLCurve* curve, double x, double y, double area, double cx, double cy, double exact) {
  double about[2], centre[2], a, m;
  int status;
  about[0] = x;
  about[1] = y;
  s1243(curve, about, 2, 1e-6, centre, &a, &m, &status);
  printf("%-46s area %8.4f, moment %9.4f, should be %9.4f\n", what, a, m, exact);
  if (status || fabs(a - area) > 1e-4 * area || fabs(centre[0] - cx) > 1e-4 || fabs(centre[1] - cy) > 1e-4) sound = 0;
  return m;
}
/* Rectangle of w x h with a corner in the origin, its lower side cut in two if asked for, as a curve of order 2. */
static SISLCurve* rectangle(double w, double h, int cut) {
  double corners[12], knots[8];
  int n = 0, i;
#define ADD(x, y) corners[2 * n] = (x), corners[2 * n + 1] = (y), ++n
  ADD(0, 0);
  if (cut) ADD(w / 2, 0);
  ADD(w, 0);
  ADD(w, h);
  ADD(0, h);
  ADD(0, 0);
  for (i = 0; i < n; ++i) knots[i + 1] = i;
  knots[0] = 0;
  knots[n + 1] = n - 1;
  return newCurve(n, 2, knots, corners, 1, 2, 1);
}
static SISLCurve* circle(double radius) {
  double start[2], centre[2] = {0, 0}, axis[3] = {0, 0, 1};
  SISLCurve* curve = 0;
  int status;
  start[0] = radius;
  start[1] = 0;
  s1303(start, 1e-9, 6.283185307179586, centre, axis, 2, &curve, &status);
  return curve;
}
int main(void) {
  const double pi = 3.141592653589793;
  double small = moment("square, side 1/2, about its middle:", rectangle(.5, .5, 0), .25, .25, .25, .25, .25, pow(.5, 4) / 6);
  double one = moment("square, side 1, about its middle:", rectangle(1, 1, 0), .5, .5, 1, .5, .5, 1. / 6);
  double ten = moment("square, side 10, about its middle:", rectangle(10, 10, 0), 5, 5, 100, 5, 5, 1e4 / 6);
  double cut = moment("the same, a side given as two halves:", rectangle(10, 10, 1), 5, 5, 100, 5, 5, 1e4 / 6);
  double lucky = moment("rectangle, 2 x 1, about its middle:", rectangle(2, 1, 0), 1, .5, 2, 1, .5, 10. / 12);
  double off = moment("the same about (1.5, 0.5):", rectangle(2, 1, 0), 1.5, .5, 2, 1, .5, 10. / 12 + 2 * .25);
  double corner = moment("the same about its corner:", rectangle(2, 1, 0), 0, 0, 2, 1, .5, 2 * 5. / 3);
  double c1 = moment("circle, radius 1, about its centre:", circle(1), 0, 0, pi, 0, 0, pi / 2);
  double c10 = moment("circle, radius 10, about its centre:", circle(10), 0, 0, 100 * pi, 0, 0, 1e4 * pi / 2);
  int as_described = fabs(small - 2. / 3) < 1e-9 && fabs(one - 2. / 3) < 1e-9 && fabs(ten - 2. / 3) < 1e-9 && cut > ten + .05;
  as_described = as_described && fabs(lucky - 10. / 12) < 1e-9 && fabs(off - 4. / 3) > .1 && isinf(corner) && c1 > 5 && c10 < 1000;
  printf("area and centre %s; the moment is %s\n", sound ? "right" : "wrong", as_described ? "not that of the figure" : "otherwise than described");
  return !(sound && as_described);
}
C
cc -w -O0 -I root/usr/include moment.c -o moment "$(find root -name libsisl.a)" -lm
echo "SISL $version"
./moment
