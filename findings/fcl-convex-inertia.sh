#!/bin/sh
# FCL 0.7.0 (Debian 12): the inertia that fcl::Convex gives about its own centre is negative as soon as the body lies off the origin. Boxes,
# spheres, cones and BVHModel have their moments for density 1; Convex alone divides by the volume (convex-inl.h), which is mass 1. The base
# class's computeMomentofInertiaRelatedToCOM() knows only the first and takes off volume x distance^2: a cube of side 2 with its centre at (3,0,0)
# has 0.67, -62.3, -62.3 for three times 5.33, and nothing is said. At the origin no minus gives it away: there the moments are an eighth of those
# of the same cube as Box or BVHModel, so that the moments of bodies made of several kinds of shape cannot be added.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libfcl0.7=0.7.0-3+b1 libfcl-dev=0.7.0-3+b1 libccd2=2.1-2+b1 libccd-dev=2.1-2+b1 libeigen3-dev=3.4.0-4 \
  liboctomap1.9=1.9.7+dfsg-3+b1 liboctomap-dev=1.9.7+dfsg-3+b1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libfcl.so.0.7')")
cat > cube.cpp <<'C'
#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <cmath>
#include <cstdio>
using fcl::Matrix3d, fcl::Vector3d;
void show(const char* name, double volume, const Matrix3d& origin, const Matrix3d& centre) {
  std::printf("  %-8s volume %g; about the origin %.3f %.3f %.3f, about the centre %.3f %.3f %.3f\n", name, volume, origin(0, 0), origin(1, 1), origin(2, 2),
              centre(0, 0), centre(1, 1), centre(2, 2));
}
int main() {
  std::printf("FCL %s\n", FCL_VERSION);
  bool as_described = true;
  for (const double x : {0., 3.}) {
    auto corners = std::make_shared<std::vector<Vector3d>>();
    for (int i = 0; i < 8; ++i) corners->emplace_back(x + (i & 1 ? 1 : -1), i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    auto faces = std::make_shared<std::vector<int>>(std::vector<int>{4, 0, 2, 3, 1, 4, 4, 5, 7, 6, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0, 4, 6, 2, 4, 1, 3, 7, 5});
    std::vector<fcl::Triangle> triangles;
    for (std::size_t f = 0; f < faces->size(); f += 5)
      for (int k : {2, 3}) triangles.emplace_back((*faces)[f + 1], (*faces)[f + k], (*faces)[f + k + 1]);
    const fcl::Convexd convex(corners, 6, faces);
    fcl::BVHModel<fcl::OBBRSSd> mesh;
    mesh.beginModel(), mesh.addSubModel(*corners, triangles), mesh.endModel();
    const fcl::Boxd box(2, 2, 2);
    std::printf("cube of side 2 about (%g 0 0), centre of Convex at x = %g\n", x, convex.computeCOM()[0]);
    const Matrix3d centre = convex.computeMomentofInertiaRelatedToCOM(), same = mesh.computeMomentofInertiaRelatedToCOM();
    show("Convex", convex.computeVolume(), convex.computeMomentofInertia(), centre);
    show("BVHModel", mesh.computeVolume(), mesh.computeMomentofInertia(), same);
    if (x == 0) show("Box", box.computeVolume(), box.computeMomentofInertia(), box.computeMomentofInertiaRelatedToCOM());
    as_described &= std::abs(same(1, 1) - 16. / 3) < 1e-9 && std::abs(centre(0, 0) - 2. / 3) < 1e-9;
    as_described &= std::abs(centre(1, 1) - (x == 0 ? 2. / 3 : 2. / 3 + 9 - 72)) < 1e-9;
  }
  return !as_described;
}
C
c++ -std=c++17 -O1 -w -I root/usr/include -I root/usr/include/eigen3 cube.cpp -o cube -L "$lib" -lfcl -lccd -loctomap -loctomath -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./cube
