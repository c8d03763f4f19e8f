#!/bin/sh
# geometric_shapes 0.7.3 (Debian 12), the shapes of MoveIt: the volume of a mesh (bodies::ConvexMesh::computeVolume) is that of no body. It adds the
# signed volumes of the tetrahedra from the origin to the triangles of the convex hull; but these come from Qhull, which keeps their corners in no
# order, every second one turned, and useDimensions() takes them as they are. A box and an octahedron have the volume 0, a pyramid a half, and
# other bodies a value that changes as they are moved within their mesh. correctVertexOrderFromPlanes(), of which the header says nothing and which
# the library does not call, mends this if called by hand. Besides, the corners are the unscaled ones, so that setScale() and setPadding() change
# nothing, while the header has 'this method includes changes induced by scaling and padding'; box, ball and cylinder do take them. A tetrahedron
# with a corner in its origin is right at scale 1, as three of its four terms are 0. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libgeometric-shapes-dev=0.7.3-7 libgeometric-shapes5d=0.7.3-7 libeigen-stl-containers-dev=0.1.8-4 \
  librandom-numbers-dev=0.3.2-5+b1 librandom-numbers0d=0.3.2-5+b1 libeigen3-dev=3.4.0-4 libconsole-bridge1.0=1.0.1+dfsg2-3+b1 \
  libresource-retriever0d libassimp5 liboctomap1.9 libqhull-r8.0 libroslib0d librospack0d librosconsole-bridge0d librosconsole3d librostime1d \
  liblog4cxx15 libcpp-common0d libaprutil1 libapr1 libdraco7 libminizip1 libtinyxml2-9 libboost1.74-dev libboost-filesystem1.74.0 \
  libboost-regex1.74.0 libboost-program-options1.74.0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libgeometric_shapes.so')")
cat > volume.cpp <<'C'
#include <geometric_shapes/bodies.h>
#include <cmath>
#include <cstdio>
#include <vector>
using Eigen::Vector3d;
static shapes::Mesh mesh(const std::vector<Vector3d>& points, double shift) {  // the body takes the hull of the points; one triangle will do
  shapes::Mesh m(points.size(), 1);
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) m.vertices[3 * i + k] = points[i][k] + shift;
  for (int k = 0; k < 3; ++k) m.triangles[k] = k;
  return m;
}
int main() {
  std::printf("geometric_shapes 0.7.3\n");
  struct Shape {
    const char* name;
    double right;
    std::vector<Vector3d> points;
  };
  std::vector<Shape> all = {{"box 2 x 1 x 1", 2, {}}, {"octahedron", 4 / 3., {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}},
                            {"pyramid", 4, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 3}}}, {"prism of 8 sides", 4 * std::sqrt(2.), {}},
                            {"tetrahedron", 1 / 6., {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (int i = 0; i < 8; ++i) all[0].points.push_back(Vector3d(i & 1 ? 2 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0));
  for (int i = 0; i < 16; ++i) all[3].points.push_back(Vector3d(std::cos(i / 2 * M_PI / 4), std::sin(i / 2 * M_PI / 4), i % 2 * 2));
  bool as_described = true;
  double moved[5][3];
  for (size_t s = 0; s < all.size(); ++s) {
    std::printf("%-16s right %.4f; moved by 0, 0.5, 3:", all[s].name, all[s].right);
    double ordered = 0, doubled = 0;
    for (int k = 0; k < 3; ++k) {
      const shapes::Mesh m = mesh(all[s].points, k == 0 ? 0 : k == 1 ? .5 : 3);
      bodies::ConvexMesh body(&m);
      std::printf(" %.4f", moved[s][k] = body.computeVolume());
      body.correctVertexOrderFromPlanes();
      ordered = body.computeVolume();
      body.setScale(2);
      doubled = body.computeVolume();
      as_described = as_described && std::abs(ordered - all[s].right) < 1e-6 && std::abs(doubled - all[s].right) < 1e-6;
    }
    std::printf("; with the triangles put in order %.4f, then with scale 2 %.4f for %.4f\n", ordered, doubled, 8 * all[s].right);
  }
  for (int k = 0; k < 3; ++k) as_described = as_described && moved[0][k] < 1e-9 && moved[1][k] < 1e-9 && std::abs(moved[2][k] - 2) < 1e-6;
  as_described = as_described && std::abs(moved[3][0] - moved[3][2]) > 1 && std::abs(moved[4][0] - 1 / 6.) < 1e-9 && moved[4][2] > 1;
  // The primitive bodies take the scale.
  const shapes::Box size(2, 1, 1);
  bodies::Box box(&size);
  const double once = box.computeVolume();
  box.setScale(2);
  std::printf("the primitive Box: %g, with scale 2 %g\n", once, box.computeVolume());
  return as_described && once == 2 && box.computeVolume() == 16 ? 0 : 1;
}
C
g++ -O1 -std=c++17 -Iroot/usr/include -Iroot/usr/include/eigen3 volume.cpp -o volume -L"$lib" -lgeometric_shapes -lrandom_numbers -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./volume
