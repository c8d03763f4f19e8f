#!/bin/sh
# Coin 4.0.0 (Debian 12): SbViewVolume::zNarrow(near, far) puts the far plane too far, so that what is to be a slice of the view sticks out of it.
# Both figures are relative, 1 the near plane and 0 the far one, as the documentation has it; the near plane comes out right. But what
# SbDPViewVolume::zNarrow() sets as the depth, nearToFar, is the distance of the new far plane from the eye, and not from the new near plane:
# the volume is too deep by the distance of its near plane. zNarrow(1, 0), which changes nothing, makes 1 .. 10 to 1 .. 11, and the far half of a
# quarter, zNarrow(0.5, 0.25), ends at 13.25 instead of 7.75: behind the far plane of the view it is a part of. narrow(box) goes the same way
# (left, bottom, right and top are right). Planes, tests of points and boxes, matrices and screen depths all agree with the wrong depth; with a
# near plane that is close to the eye and left where it is, the difference is small. It is found nowhere else, and nothing is said.
set -eu
version=4.0.0+ds-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libcoin-dev=$version" "libcoin80c=$version" libexpat1 libglx0 libopengl0 libglvnd0 libx11-6 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0 \
  2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libCoin.so')")
cat > narrow.cpp <<'C'
#include <Inventor/C/basic.h>
#include <Inventor/SbBox3f.h>
#include <Inventor/SbPlane.h>
#include <Inventor/SbViewVolume.h>
#include <cmath>
#include <cstdio>
#include <initializer_list>
static bool same(double a, double b) { return std::abs(a - b) < 1e-4 * (1 + std::abs(b)); }
// Where along the line of sight, from the eye at the origin towards -z, points are within.
static void extent(const SbViewVolume& v, double& first, double& last) {
  first = last = -1;
  for (int i = 1; i < 2000; ++i) {
    const float z = (i + .5f) / 100;
    if (!v.intersect(SbVec3f(0, 0, -z))) continue;
    if (first < 0) first = i / 100.;
    last = (i + 1) / 100.;
  }
}
int main() {
  std::printf("Coin %s\n", COIN_VERSION);
  bool as_described = true;
  for (int parallel = 0; parallel < 2; ++parallel)
    for (double n : {1., 4.}) {
      const double f = n + 9;
      SbViewVolume view;
      if (parallel) view.ortho(-1, 1, -1, 1, n, f);
      else view.perspective(M_PI / 2, 1, n, f);
      std::printf("%s view from %g to %g\n", parallel ? "parallel" : "perspective", n, f);
      const double parts[4][2] = {{1, 0}, {.5, .25}, {1, .5}, {.9, .8}};
      for (auto& part : parts) {
        const SbViewVolume slice = view.zNarrow(part[0], part[1]);
        const SbViewVolume boxed = view.narrow(SbBox3f(.25f, .25f, part[1], .75f, .75f, part[0]));
        const double near_right = n + (1 - part[0]) * (f - n), far_right = n + (1 - part[1]) * (f - n);
        SbPlane planes[6];
        slice.getViewVolumePlanes(planes);
        double first, last, first_view, last_view;
        extent(slice, first, last);
        extent(view, first_view, last_view);
        SbVec3f screen;
        slice.projectToScreen(SbVec3f(0, 0, -far_right), screen);
        std::printf("  zNarrow(%g, %g): near %g, depth %g, far plane at %g, points within from %g to %g; right: %g to %g; depth on the screen there %.4f\n", part[0],
                    part[1], slice.getNearDist(), slice.getDepth(), -planes[5].getDistanceFromOrigin(), first, last, near_right, far_right, screen[2]);
        // Wrong: deeper by the distance of the near plane. Right: the near plane, and the view itself.
        as_described = as_described && same(slice.getDepth(), far_right) && same(-planes[5].getDistanceFromOrigin(), near_right + far_right) &&
                       std::abs(last - near_right - far_right) < .02 && same(boxed.getDepth(), far_right) && screen[2] < .995;
        as_described = as_described && same(slice.getNearDist(), near_right) && std::abs(first - near_right) < .02 && same(boxed.getNearDist(), near_right) &&
                       same(boxed.getWidth(), slice.getWidth() / 2) && std::abs(first_view - n) < .02 && std::abs(last_view - f) < .02;
      }
    }
  return as_described ? 0 : 1;
}
C
g++ -O1 -w -Iroot/usr/include narrow.cpp -o narrow -L"$lib" -Wl,-rpath-link,"$lib" -lCoin
LD_LIBRARY_PATH=$lib ./narrow
