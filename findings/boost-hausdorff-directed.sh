#!/bin/sh
# Boost.Geometry of Boost 1.74 (Debian 12; 1.81 gives the same): discrete_hausdorff_distance(a, b), 'discrete Hausdorff distance between two
# geometries', is the directed one. It takes the farthest that a vertex of a lies from the vertices of b and leaves out those of b
# (range_range in discrete_hausdorff_distance.hpp), so that it depends on the order of the two and is 0 for geometries that are not the same: a
# track whose points all occur in one that runs 9 off to the side has distance 0 from it. A tolerance tested this way lets through whatever the
# second has more. GEOS, and with it PostGIS and Shapely, give the greater of both directions under that name. Lines of similar course that do not
# leave each other anywhere do not show it, and the documentation does not mention the order. The maintainer's issue 1171 of 2023 is open.
set -eu
version=1.74.0+ds1-21
geos=3.11.1-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libboost1.74-dev=$version" "libgeos-dev=$geos" "libgeos-c1v5=$geos" "libgeos3.11.1=$geos"
for package in *.deb; do dpkg -x "$package" root; done
lib=$folder/root/usr/lib/x86_64-linux-gnu
cat > directed.cpp <<'C'
#include <boost/geometry.hpp>
#include <boost/version.hpp>
#include <geos_c.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Line = bg::model::linestring<Point>;
using Cloud = bg::model::multi_point<Point>;
// Farthest that a point of a lies from the points of b.
template <class A>
double directed(const A& a, const A& b) {
  double most = 0;
  for (const auto& p : a) {
    double least = INFINITY;
    for (const auto& q : b) least = std::min(least, std::hypot(p.x() - q.x(), p.y() - q.y()));
    most = std::max(most, least);
  }
  return most;
}
template <class A>
bool compare(const char* name, const A& a, const A& b) {
  const double ab = bg::discrete_hausdorff_distance(a, b), ba = bg::discrete_hausdorff_distance(b, a), right = std::max(directed(a, b), directed(b, a));
  std::printf("%-12s of a and b %.3f, of b and a %.3f; Hausdorff distance %.3f\n", name, ab, ba, right);
  return ab == 0 && std::abs(ba - right) < 1e-12 && right == 9;
}
int main() {
  std::printf("Boost %s, GEOS %s\n", BOOST_LIB_VERSION, GEOSversion());
  const char *track = "LINESTRING(0 0,1 0,2 0,3 0,4 0)", *detour = "LINESTRING(0 0,1 0,2 0,2 9,3 0,4 0)";
  Line a, b;
  bg::read_wkt(track, a);
  bg::read_wkt(detour, b);
  bool as_described = compare("two lines:", a, b);
  as_described &= compare("two clouds:", Cloud(a.begin(), a.end()), Cloud(b.begin(), b.end()));
  initGEOS(nullptr, nullptr);
  double distance;
  GEOSHausdorffDistance(GEOSGeomFromWKT(track), GEOSGeomFromWKT(detour), &distance);
  std::printf("GEOS of a and b: %.3f\n", distance);
  return !(as_described && distance == 9);
}
C
c++ -std=c++17 -w -DBOOST_ALLOW_DEPRECATED_HEADERS -I root/usr/include directed.cpp -o directed -L "$lib" -lgeos_c -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./directed
