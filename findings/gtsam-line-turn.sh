#!/bin/sh
# GTSAM 4.2.0 (Debian 13): two lines in space are equal, for Line3, if they are parallel and have the same numbers a and b, wherever they lie. A Line3
# is a rotation R and (a, b): the direction is R z, and the line passes through R (a, b, 0). One line is thus given by many R, which differ by a turn
# about z with a and b turned back. equals() and localCoordinates() compare the x and y of the rotation between the two and a with a, b with b,
# and leave out the turn about z. So the line through (1, 0, 0) equals that through (0, 1, 0), difference 0, while one line written in two ways
# is not equal to itself. Such R come of the class itself: transformTo() gives them for a camera turned about its axis, so that a camera on its side
# sees what it measures as an error of 1.41 and another line as none, and steps of retract() that end in the first direction leave a turn behind. A
# prior that agrees with its estimate moves it away by 1.41 with an error of 0 at the end. If all R differ by x and y only, as two lines in
# one frame mostly do, it is right. Another slip: OrientedPlane3(a, b, c, d) makes the normal a unit vector and leaves d, so that the plane
# 2 z - 4 = 0 is z = 4 for it. Nothing is said; the headers have 'check if two lines are equal' and 'perpendicular distance'.
set -eu
version=4.2.0+dfsg-1+b4
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
from get download "libgtsam4=$version" "libgtsam-dev=$version" libboost1.83-dev libboost-serialization1.83.0 libboost-filesystem1.83.0 \
  libboost-timer1.83.0 libtbb12 libtbb-dev libtbbmalloc2 libccolamd3 libsuitesparseconfig7 libmetis5 libgomp1 libeigen3-dev libc6 libstdc++6 libgcc-s1
for package in *.deb; do dpkg -x "$package" root; done
cat > lines.cpp <<'C'
#include <gtsam/geometry/Line3.h>
#include <gtsam/geometry/OrientedPlane3.h>
#include <gtsam/geometry/Pose3.h>
#include <gtsam/nonlinear/LevenbergMarquardtOptimizer.h>
#include <gtsam/nonlinear/NonlinearFactorGraph.h>
#include <gtsam/nonlinear/PriorFactor.h>
#include <cmath>
#include <cstdio>
using namespace gtsam;
static const double degree = std::acos(-1.) / 180;
static bool as_described = true;
static void expect(bool holds) { as_described = as_described && holds; }
static bool near(double a, double b) { return std::abs(a - b) < 1e-3; }
static Vector3 direction(const Line3& line) { return line.point(1) - line.point(0); }
// The distance of two parallel lines, or of two others: 0 only if they are one line.
static double apart(const Line3& one, const Line3& other) {
  const Vector3 d = direction(one).normalized(), between = other.point(0) - one.point(0);
  return (between - between.dot(d) * d).norm() + d.cross(direction(other)).norm();
}
static void compare(const char* what, const Line3& one, const Line3& other, bool same, bool found_equal) {
  const Vector4 v = one.localCoordinates(other);
  const double left = apart(one.retract(v), other);
  const Point3 p = one.point(0), q = other.point(0);
  std::printf("%-52s through (%.2f, %.2f, %.2f) and (%.2f, %.2f, %.2f), %.3f apart: equals() %s, difference %.3f, retract() by it is %.3f from the other\n",
              what, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), apart(one, other), one.equals(other, 1e-6) ? "yes" : "no", v.norm(), left);
  expect(same == (apart(one, other) < 1e-6) && found_equal == one.equals(other, 1e-6));
  if (same != found_equal) expect(found_equal ? v.norm() < 1e-6 && left > 1 : v.norm() > 1 && left > 1);
  else expect(left < 1e-6);
}
int main() {
  const Line3 line(Rot3(), 1, 0);
  compare("as they are:", line, line, true, true);
  compare("another beside it:", line, Line3(Rot3(), 1, 2), false, false);
  compare("another, tilted:", line, Line3(Rot3::Rx(0.3), 1, 2), false, false);
  compare("another, its frame turned by 90 degrees about z:", line, Line3(Rot3::Rz(90 * degree), 1, 0), false, true);
  const Line3 again(Rot3::Rz(90 * degree), 0, -1);
  compare("the same, its frame turned by 90 degrees about z:", line, again, true, false);
  // A tilted line, in two frames.
  const Rot3 tilt = Rot3::RzRyRx(0.4, -0.3, 0.2);
  const double t = 120 * degree;
  compare("tilted, the same, turned by 120 degrees:", Line3(tilt, 1, 0), Line3(tilt * Rot3::Rz(t), std::cos(t), -std::sin(t)), true, false);
  compare("tilted, another, turned by 120 degrees:", Line3(tilt, 1, 0), Line3(tilt * Rot3::Rz(t), 1, 0), false, true);
  // Three quarter turns, each by retract(), back to the direction z.
  const Vector4 x(90 * degree, 0, 0, 0), y(0, 90 * degree, 0, 0);
  Line3 round = line.retract(x).retract(y).retract(-x);
  compare("after three quarter turns by retract():", line, round, false, true);
  // A camera at the origin, upright and on its side; what it sees, by transformTo() and by its own measurement.
  const struct {
    double roll, x, y;
    bool right;
  } cameras[] = {{0, 1, 0, true}, {90, 0, -1, false}};
  for (const auto& c : cameras) {
    const Pose3 pose(Rot3::Rz(c.roll * degree), Point3(0, 0, 0));
    const Line3 seen = transformTo(pose, line), measured(Rot3(), c.x, c.y);
    std::printf("camera turned by %g degrees: ", c.roll);
    compare("", seen, measured, true, c.right);
    if (!c.right) std::printf("camera turned by %g degrees: ", c.roll), compare("", seen, line, false, true);
  }
  // A prior that says what the estimate is.
  for (const Line3& prior : {line, again}) {
    NonlinearFactorGraph graph;
    graph.addPrior<Line3>(0, prior, noiseModel::Unit::Create(4));
    Values values;
    values.insert<Line3>(0, line);
    const double before = graph.error(values);
    const Values result = LevenbergMarquardtOptimizer(graph, values).optimize();
    const double moved = apart(line, result.at<Line3>(0)), after = graph.error(result);
    std::printf("estimate and prior %.3f apart: error %.3f before, %.3f after; the estimate has moved by %.3f\n", apart(line, prior), before, after, moved);
    expect(near(apart(line, prior), 0) && near(after, 0) && (prior.a() == 1 ? near(moved, 0) && near(before, 0) : near(moved, 1.4142) && near(before, 1)));
  }
  for (double scale : {1., 2., 0.001}) {
    const OrientedPlane3 plane(0, 0, scale, -2 * scale);
    const Vector4 p = plane.planeCoefficients();
    std::printf("plane %g z + %g = 0: normal (%g, %g, %g), distance %g\n", scale, -2 * scale, p[0], p[1], p[2], plane.distance());
    expect(near(p[2], 1) && near(p[3], -2 * scale) && plane.equals(OrientedPlane3(0, 0, 1, -2)) == (scale == 1));
  }
  return !as_described;
}
C
lib=$(dirname "$(find root -name 'libgtsam.so.4')")
loader=$(find root -name 'ld-linux*' -type f | head -n 1)
c++ -std=c++17 -O0 -w -I root/usr/include -I root/usr/include/eigen3 lines.cpp -o lines "$lib/libgtsam.so.4" "$lib/libboost_serialization.so.1.83.0" \
  "$lib/libtbb.so.12" "$lib/libtbbmalloc.so.2" -Wl,--allow-shlib-undefined -Wl,-rpath-link,"$lib"
echo "GTSAM $version"
"$loader" --library-path "$lib" ./lines
