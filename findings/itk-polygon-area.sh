#!/bin/sh
# ITK 5.2.1 (Debian 12; the code is the same in 5.4.3 of Debian 13): the area of a closed PolygonSpatialObject depends on where it lies. In
# MeasureAreaInObjectSpace() the edge that closes the polygon is taken from the first point to the last, against the direction of all others, so
# that its cross product comes in with the wrong sign: a square of side 2 has area 4 with its first corner in the origin, 6 at (1,1) and 24 at
# (10,10); a circle of radius 10 about (100,50), in 64 points, has 66 to 127 % of its area, depending on the point it begins with. The volume, area
# times thickness, goes the same way; the perimeter is right. It does not show if the first point is repeated at the end, as some files have it, or
# if the first or the last point is the origin. Polygons are closed by default, points are not repeated for it, and nothing is said.
set -eu
version=5.2.1-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libinsighttoolkit5-dev=$version" "libinsighttoolkit5.2=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libITKCommon-5.2.so.1')")
cat > area.cpp <<'C'
#include <itkPolygonSpatialObject.h>
#include <itkVersion.h>
#include <cmath>
#include <cstdio>
#include <vector>
using Polygon = itk::PolygonSpatialObject<2>;
using Corners = std::vector<Polygon::PointType>;
struct Measures {
  double area, volume, perimeter;
};
Measures measure(const char* what, const Corners& corners, double x, double y, bool repeat, double area, double perimeter) {
  auto polygon = Polygon::New();
  Polygon::PolygonPointListType points;
  for (size_t i = 0; i < corners.size() + repeat; ++i) {
    Polygon::PointType p = corners[i % corners.size()];
    p[0] += x;
    p[1] += y;
    Polygon::PolygonPointType point;
    point.SetPositionInObjectSpace(p);
    points.push_back(point);
  }
  polygon->SetPoints(points);
  polygon->SetThicknessInObjectSpace(3);
  polygon->Update();
  const Measures m{polygon->MeasureAreaInObjectSpace(), polygon->MeasureVolumeInObjectSpace(), polygon->MeasurePerimeterInObjectSpace()};
  std::printf("  %-42s area %8.3f (%.3f), volume at thickness 3 %8.3f, perimeter %.3f (%.3f), closed: %s\n", what, m.area, area, m.volume,
              m.perimeter, perimeter, polygon->GetIsClosed() ? "yes" : "no");
  return m;
}
bool near(double a, double b) { return std::abs(a - b) < 1e-6; }
int main() {
  std::printf("ITK %s, what is right in brackets:\n", itk::Version::GetITKVersion());
  const auto at = [](double x, double y) {
    Polygon::PointType p;
    p[0] = x;
    p[1] = y;
    return p;
  };
  const Corners square{at(0, 0), at(2, 0), at(2, 2), at(0, 2)};
  const Measures a = measure("square, first corner in the origin", square, 0, 0, false, 4, 8);
  const Measures b = measure("square at (1,1)", square, 1, 1, false, 4, 8);
  const Measures c = measure("square at (10,10)", square, 10, 10, false, 4, 8);
  const Measures d = measure("square at (10,10), first corner repeated", square, 10, 10, true, 4, 8);
  bool as_described = near(a.area, 4) && near(b.area, 6) && near(c.area, 24) && near(d.area, 4);
  for (const Measures& m : {a, b, c, d}) as_described &= near(m.volume, 3 * m.area) && near(m.perimeter, 8);
  const double step = itk::Math::twopi / 64, round = 64 * 50 * std::sin(step), around = 64 * 20 * std::sin(step / 2);
  double least = round, most = round;
  for (const int begin : {0, 16, 32, 48}) {
    Corners circle;
    for (int i = 0; i < 64; ++i) circle.push_back(at(10 * std::cos((begin + i) * step), 10 * std::sin((begin + i) * step)));
    char what[64];
    std::snprintf(what, sizeof what, "circle about (100,50), from %.1f degrees", begin * 360 / 64.0);
    const Measures m = measure(what, circle, 100, 50, false, round, around);
    as_described &= near(m.perimeter, around);
    least = std::fmin(least, m.area);
    most = std::fmax(most, m.area);
    as_described &= near(measure("the same, first point repeated", circle, 100, 50, true, round, around).area, round);
  }
  std::printf("  areas of the circle from %.1f %% to %.1f %% of what is right\n", 100 * least / round, 100 * most / round);
  as_described &= least < 0.75 * round && most > 1.25 * round;
  return !as_described;
}
C
c++ -std=c++17 -O0 -w -I root/usr/include/ITK-5.2 area.cpp -o area -L "$lib" -lITKSpatialObjects-5.2 -lITKTransform-5.2 -lITKCommon-5.2 -litksys-5.2 \
  -litkvnl-5.2 -litkvnl_algo-5.2 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./area
