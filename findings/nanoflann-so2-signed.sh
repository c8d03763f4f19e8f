#!/bin/sh
# nanoflann 1.4.3 (Debian 12), metric SO2 for angles: the 'nearest' angle is the one farthest clockwise. SO2_Adaptor::accum_dist() wraps the
# difference of two angles to [-pi, pi] and returns it with its sign, and a search keeps what is least: the most negative one. Nothing is
# said, as every call returns some index. With metric L1 and the angles' copies beside the seam, or L2 on (cos, sin), the search is right.
set -eu
version=1.4.3+ds-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libnanoflann-dev=$version"
dpkg -x ./*.deb root
cat > angles.cpp <<'C'
#include <cmath>
#include <cstdio>
#include <nanoflann.hpp>
#include <random>
#include <vector>
struct Angles {
  std::vector<double> a;
  size_t kdtree_get_point_count() const { return a.size(); }
  double kdtree_get_pt(size_t i, size_t) const { return a[i]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const { return false; }
};
int main() {
  std::mt19937 bits(1);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  Angles angles;
  for (int i = 0; i < 500; ++i) angles.a.push_back(angle(bits));
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::SO2_Adaptor<double, Angles>, Angles, 1>;
  Tree tree(1, angles);
  const auto distance = [](double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)); };
  int wrong = 0;
  double farthest = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = angle(bits);
    size_t found;
    double d, least = M_PI;
    nanoflann::KNNResultSet<double> nearest(1);
    nearest.init(&found, &d);
    tree.findNeighbors(nearest, &x, nanoflann::SearchParams());
    for (const double a : angles.a) least = std::min(least, distance(a, x));
    wrong += distance(angles.a[found], x) > least;
    farthest = std::max(farthest, distance(angles.a[found], x));
  }
  std::printf("of 1000 searches among 500 angles %d did not find the nearest; farthest answer %.2f away\n", wrong, farthest);
  return !(wrong > 500 && farthest > 3);
}
C
c++ -O1 -std=c++17 -I root/usr/include angles.cpp -o angles
./angles
