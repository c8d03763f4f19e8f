#!/bin/sh
# OpenCV 4.6.0 (Debian 12): minEnclosingCircle() of points measured in a large unit does not enclose them. Three points that span no more than
# 1e-4, twice their triangle's area, whatever its shape, count as collinear (findCircle3pts in shapedescr.cpp compares a determinant with EPS)
# and get the circle over their longest side. In pixels that never shows; the corners of an equilateral triangle with a side of 9 mm, in metres,
# get a circle from which one sticks out by 0.6 of its radius, and of 9 points on a circle one is still outside by 0.16. Metres, fractions of an
# image and coordinates of undistortPoints() are such units. The header has 'Finds a circle of the minimum area enclosing a 2D point set', and
# nothing tells of the failure. minAreaRect() of the same points does not depend on the unit.
set -eu
version=4.6.0+dfsg-12
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libopencv-core-dev=$version" "libopencv-imgproc-dev=$version" "libopencv-core406=$version" \
  "libopencv-imgproc406=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find "$folder/root" -name 'libopencv_imgproc.so.406' | head -n 1)")
cat > circle.cpp <<'C'
#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>
// How far, in units of the shape's own radius, the farthest of n points on a circle lies outside the circle found.
double outside(int n, double radius) {
  std::vector<cv::Point2f> points;
  for (int k = 0; k < n; ++k) points.emplace_back(radius * std::cos(2 * CV_PI * k / n), radius * std::sin(2 * CV_PI * k / n));
  cv::Point2f centre;
  float found;
  cv::minEnclosingCircle(points, centre, found);
  double most = -1;
  for (const auto& p : points) most = std::max(most, (std::hypot(double(p.x) - centre.x, double(p.y) - centre.y) - found) / radius);
  const cv::Size2f box = cv::minAreaRect(points).size;
  std::printf("%2d points at radius %-6g: circle of radius %.4f of it, a point is outside by %.3f; sides of minAreaRect %.3f, %.3f\n", n, radius,
              found / radius, std::max(0.0, most), std::min(box.width, box.height) / radius, std::max(box.width, box.height) / radius);
  return most;
}
int main() {
  std::printf("OpenCV %s\n", CV_VERSION);
  bool as_described = true;
  for (const int n : {3, 5, 7, 9})
    for (const double radius : {100.0, 1.0, 0.1, 0.005}) as_described &= (outside(n, radius) > 0.1) == (radius < 0.01);
  return !as_described;
}
C
c++ -std=c++17 -w -I root/usr/include/opencv4 circle.cpp -o circle -L "$lib" \
  -l:libopencv_imgproc.so.406 -l:libopencv_core.so.406 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./circle
