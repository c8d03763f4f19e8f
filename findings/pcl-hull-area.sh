#!/bin/sh
# PCL 1.13.0 (Debian 12; the same lines are in 1.15.0 of Debian 13): the area that ConvexHull gives for a flat cloud (setComputeAreaVolume(true),
# getTotalArea()) is not that of the hull, but of its shadow on a coordinate plane, so that it depends on how the cloud lies in space. A cloud that
# is flat is recognised by its covariance and handed to performReconstruction2D(), which drops z (or, for a plane within 10 degrees of x = const or
# y = const, another coordinate) and takes qhull's area as it comes, without division by the cosine. A roof of 2 x 1 has 2 lying, 1.41 at 45
# degrees, 1 at 60, 0.35 at 80, and 2 again upright. The points returned are the right ones, in space, and the polygon they make has the right
# area; once the cloud is thick enough to count as solid, 0.1 here, the area is right too (both sides together). Areas of planes found in a scan, as
# of roofs, are the usual case. The documentation has 'the total area of the convex hull', and nothing is said; qhull's statistics, which 1.13 prints
# to stderr, have the same number. Level ground and upright walls along an axis do not show it.
set -eu
version=1.13.0+dfsg-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libpcl-dev=$version" "libpcl-common1.13=$version" "libpcl-kdtree1.13=$version" "libpcl-octree1.13=$version" \
  "libpcl-search1.13=$version" libqhull-dev=2020.2-5 libqhull-r8.0=2020.2-5 libeigen3-dev=3.4.0-4 libboost1.74-dev=1.74.0+ds1-21 \
  libflann-dev=1.9.2+dfsg-1+deb12u1 liblz4-1=1.9.4-1 libgomp1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$folder/root/usr/lib/x86_64-linux-gnu
cat > area.cpp <<'C'
#include <pcl/pcl_config.h>
#include <pcl/point_types.h>
#include <pcl/surface/impl/convex_hull.hpp>
#include <cmath>
#include <cstdio>
static bool as_described = true;
struct Result { int dimension; double area, polygon; };
// Hull of a grid of points on a plate of 2 x 1, turned up about x by `tilt` and then about z by `turn` degrees.
static Result hull(double tilt, double turn, double thickness) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  const double a = tilt * M_PI / 180, b = turn * M_PI / 180;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 10; ++j)
      for (int k = 0; k <= (thickness > 0 ? 1 : 0); ++k) {
        const double u = 0.1 * i, v = 0.1 * j, w = thickness * k;
        const double x = u, y = v * std::cos(a) - w * std::sin(a), z = v * std::sin(a) + w * std::cos(a);
        cloud->push_back(pcl::PointXYZ(x * std::cos(b) - y * std::sin(b), x * std::sin(b) + y * std::cos(b), z));
      }
  pcl::ConvexHull<pcl::PointXYZ> maker;
  maker.setComputeAreaVolume(true);
  maker.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZ> points;
  maker.reconstruct(points);
  Eigen::Vector3f twice(0, 0, 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += points[i].getVector3fMap().cross(points[(i + 1) % points.size()].getVector3fMap());
  return {maker.getDimension(), maker.getTotalArea(), twice.norm() / 2};
}
int main() {
  std::printf("PCL %s, plate of 2 x 1\n", PCL_VERSION_PRETTY);
  for (double tilt : {0., 30., 45., 60., 80., 90.}) {
    const Result r = hull(tilt, 0, 0);
    const double shadow = tilt < 85 ? 2 * std::cos(tilt * M_PI / 180) : 2;
    std::printf("tilt %2.0f degrees: dimension %d, area %.4f, should be 2; of the polygon returned %.4f\n", tilt, r.dimension, r.area, r.polygon);
    as_described = as_described && r.dimension == 2 && std::abs(r.area - shadow) < 1e-3 && std::abs(r.polygon - 2) < 1e-3;
  }
  const Result leaning = hull(85, 40, 0);
  std::printf("wall leaning by 5 degrees, seen from the south-west: area %.4f, should be 2; of the polygon %.4f\n", leaning.area, leaning.polygon);
  as_described = as_described && std::abs(leaning.area - 2 * std::cos(85 * M_PI / 180)) < 1e-3 && std::abs(leaning.polygon - 2) < 1e-3;
  for (double tilt : {0., 60.}) {
    const Result thick = hull(tilt, 0, 0.1);
    std::printf("0.1 thick, tilt %2.0f degrees: dimension %d, area %.4f, should be 4.6\n", tilt, thick.dimension, thick.area);
    as_described = as_described && thick.dimension == 3 && std::abs(thick.area - 4.6) < 1e-3;
  }
  return !as_described;
}
C
c++ -std=c++17 -O1 -w -I root/usr/include/pcl-1.13 -I root/usr/include/eigen3 -I root/usr/include area.cpp -o area -L "$lib" -lpcl_common \
  -lpcl_kdtree -lpcl_octree -lpcl_search -l:libqhull_r.so.8.0 -l:liblz4.so.1 -Wl,-rpath-link,"$lib" -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./area 2> qhull.txt || { echo "not as described"; exit 1; }
