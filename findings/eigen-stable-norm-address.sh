#!/bin/sh
# Eigen 3.4.0 (Debian 12): stableNorm(), and with it stableNormalize(), of two Vector3d with equal coordinates differ in the last bits if one
# of them lies 8 bytes off a multiple of 16, as every other vector of a std::vector<Vector3d> does: the sum is split at the first aligned
# entry. norm() has the same bits everywhere. No vector code need be asked for: -O2 on x86-64 does it.
set -eu
version=3.4.0-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libeigen3-dev=$version"
dpkg -x ./*.deb root
cat > address.cpp <<'C'
#include <Eigen/Core>
#include <cstdio>
#include <random>
#include <vector>
int main() {
  std::mt19937 bits(1);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Eigen::Vector3d> v(2);  // the second lies 24 bytes after the first
  int stable = 0, plain = 0;
  for (int i = 0; i < 1000; ++i) {
    v[0] = v[1] = Eigen::Vector3d(number(bits), number(bits), number(bits));
    if (v[0].stableNorm() != v[1].stableNorm() && stable++ == 0)
      std::printf("equal vectors, stableNorm %.17g and %.17g\n", v[0].stableNorm(), v[1].stableNorm());
    plain += v[0].norm() != v[1].norm();
  }
  std::printf("of 1000 pairs of equal vectors stableNorm differs for %d, norm for %d\n", stable, plain);
  return !(stable > 0 && plain == 0);
}
C
c++ -std=c++17 -O2 -I root/usr/include/eigen3 address.cpp -o address
./address
