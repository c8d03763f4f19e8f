#!/bin/sh
# dlib 19.24 (Debian 12): pyramid_down<2>, the halving of an image, and its map of points do not belong together. Pixel (c, r) of the small image is a
# Gaussian mean about pixel (2c+2, 2r+2) of the large one, but point_up() gives (2c+2.5, 2r+1.5): half a pixel too far right and half a pixel too
# far up. Per level it doubles, so that what is found at the fourth level comes back 7.5 pixels off in x and -7.5 in y; mirroring an image at
# its diagonal mirrors the small one, but not the points. Cause: the offset (1.25, 0.75) in pyramid_down_2_1::point_down() and point_up(), where the
# loop of operator() calls for (1, 1). point_down(point_up(p)) == p holds all the same, and the rectangles go by the same map. pyramid_down<3> is
# off by a quarter of a pixel, alike in x and y: (1, 1) for (5/6, 5/6); pyramid_down<6> by about 0.2. dlib's description says that a point P of the
# image shows up at point_down(P) in the small one; nothing is said of limits.
set -eu
version=19.24+dfsg-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libdlib-dev=$version"
dpkg -x ./*.deb root
cat > pyramid.cpp <<'C'
#include <dlib/array2d.h>
#include <dlib/image_transforms.h>
#include <dlib/revision.h>
#include <cmath>
#include <cstdio>
using namespace dlib;
using Point = vector<double, 2>;
float grey(float v) { return v; }
float grey(unsigned char v) { return v; }
float grey(const rgb_pixel& v) { return v.green; }
void put(float& p, double v) { p = v; }
void put(unsigned char& p, double v) { p = std::lround(v); }
void put(rgb_pixel& p, double v) { p.red = p.green = p.blue = std::lround(v); }
// A round spot at `at`, and where it is found: the mean place, weighted with the brightness.
template <class Image> void spot(Image& image, Point at, double width) {
  for (long r = 0; r < image.nr(); ++r)
    for (long c = 0; c < image.nc(); ++c)
      put(image[r][c], 240 * std::exp(-(std::pow(c - at.x(), 2) + std::pow(r - at.y(), 2)) / (2 * width * width)));
}
template <class Image> Point place(const Image& image) {
  double sum = 0, x = 0, y = 0;
  for (long r = 0; r < image.nr(); ++r)
    for (long c = 0; c < image.nc(); ++c) {
      const double v = grey(image[r][c]);
      sum += v, x += v * c, y += v * r;
    }
  return Point(x / sum, y / sum);
}
// Error of the place of the spot that is found after `levels` halvings (or the like) and taken back by point_up().
template <int N, class Pixel> Point off_by(const char* what, int levels) {
  const Point at(230, 230); // on the diagonal
  array2d<Pixel> image(480, 480), small;
  spot(image, at, 24);
  pyramid_down<N> pyramid;
  for (int i = 0; i < levels; ++i) {
    pyramid(image, small);
    image.swap(small);
  }
  const Point found = place(image), back = pyramid.point_up(found, levels), again = pyramid.point_down(back, levels);
  std::printf("pyramid_down<%d>, %s, level %d: found at (%.3f, %.3f), back at (%.3f, %.3f), error (%.3f, %.3f)\n", N, what, levels, found.x(),
              found.y(), back.x(), back.y(), back.x() - at.x(), back.y() - at.y());
  return (again - found).length() < 1e-9 ? back - at : Point(1e9, 1e9);
}
bool near(const Point& p, double x, double y, double within) { return std::abs(p.x() - x) < within && std::abs(p.y() - y) < within; }
int main() {
  std::printf("dlib %d.%d; a spot at (230, 230) in an image of 480 x 480\n", DLIB_MAJOR_VERSION, DLIB_MINOR_VERSION);
  bool as_described = near(off_by<2, float>("float", 0), 0, 0, 0.01);
  for (int level = 1; level <= 4; ++level) {
    const double off = (std::pow(2, level) - 1) / 2;
    as_described &= near(off_by<2, float>("float", level), off, -off, 0.02);
  }
  as_described &= near(off_by<2, unsigned char>("byte", 1), 0.5, -0.5, 0.05) && near(off_by<2, rgb_pixel>("colour", 1), 0.5, -0.5, 0.05);
  as_described &= near(off_by<3, float>("float", 1), 0.25, 0.25, 0.02);
  const Point six = off_by<6, float>("float", 1);
  as_described &= six.x() > 0.1 && six.x() < 0.3 && std::abs(six.x() - six.y()) < 0.01;
  // One bright pixel shows what the middle of each small pixel is.
  array2d<float> image(40, 40), small;
  assign_all_pixels(image, 0);
  image[22][22] = 256;
  pyramid_down<2> pyramid;
  pyramid(image, small);
  const Point up = pyramid.point_up(Point(10, 10));
  std::printf("only pixel (22, 22) is bright: small image, row 10 from column 8: %g %g %g %g %g; column 10 from row 8: %g %g %g %g %g\n",
              small[10][8], small[10][9], small[10][10], small[10][11], small[10][12], small[8][10], small[9][10], small[10][10], small[11][10],
              small[12][10]);
  std::printf("its brightest pixel is (10, 10), for point_up() at (%g, %g); by 2p + (2, 2) at (22, 22)\n", up.x(), up.y());
  as_described &= small[10][10] > small[10][9] && small[10][9] == small[10][11] && small[9][10] == small[11][10] && small[10][9] == small[9][10];
  as_described &= up == Point(22.5, 21.5);
  // With the offset (1, 1) the points are right.
  Point right(230, 230);
  array2d<float> large(480, 480);
  spot(large, right, 24);
  for (int i = 0; i < 4; ++i) {
    pyramid(large, small);
    large.swap(small);
  }
  Point p = place(large);
  for (int i = 0; i < 4; ++i) p = p * 2 + Point(2, 2);
  std::printf("level 4, by 2p + (2, 2) four times: (%.3f, %.3f)\n", p.x(), p.y());
  as_described &= near(p, 230, 230, 0.02);
  return !as_described;
}
C
c++ -std=c++14 -O1 -w -I root/usr/include pyramid.cpp -o pyramid root/usr/lib/x86_64-linux-gnu/libdlib.a -lpthread
./pyramid
