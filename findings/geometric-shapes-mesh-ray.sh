#!/bin/sh
# geometric_shapes 0.7.3 (Debian 12), the shapes of MoveIt: a ray meets a mesh (ConvexMesh::intersectsRay) where the mesh is not. The planes of
# its faces are set up anew from a scaled corner v; for the equation n.x + w = 0 that takes w = -n.v, and the function takes n.v, so that each
# face's plane is mirrored in the origin of the mesh (containsPoint() has the minus). A box of 2 x 1 x 1 that stands on its origin, as parts often
# do, is hit from above at heights 0 and -1 in place of 1 and 0; from its middle no ray leads up and out. The further the mesh lies from its
# origin, the more; whether the hit is within the triangle is then asked of the wrong point, so that oblique rays miss the body or meet one face
# in place of two. Meshes that are their own mirror image in the origin, such as a centred box, ball or cylinder, are right, with any pose,
# scale and padding, and so are the other bodies. Before 2020 the planes were right for scale 1. Nothing is said.
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
cat > ray.cpp <<'C'
#include <geometric_shapes/bodies.h>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>
using Eigen::Vector3d;
using Points = EigenSTL::vector_Vector3d;
static shapes::Mesh box_mesh(const Vector3d& low, const Vector3d& high) {
  static const int t[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  shapes::Mesh m(8, 12);
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) m.vertices[3 * i + k] = (i >> k & 1) ? high[k] : low[k];
  for (int i = 0; i < 36; ++i) m.triangles[i] = t[i];
  return m;
}
static bool near(const Points& a, std::initializer_list<Vector3d> b) {
  bool same = a.size() == b.size();
  for (size_t i = 0; same && i < a.size(); ++i) same = (a[i] - b.begin()[i]).norm() < 1e-6;
  return same;
}
static void show(const char* what, const Points& p) {
  std::printf("%s", what);
  if (p.empty()) std::printf(" nothing");
  for (const Vector3d& x : p) std::printf(" (%g, %g, %g)", x.x(), x.y(), x.z());
}
int main() {
  std::printf("geometric_shapes 0.7.3\n");
  bool as_described = true;
  // A box 2 x 1 x 1 whose foot is at the height z of the mesh's own frame, and a primitive box in the same place.
  const shapes::Box size(2, 1, 1);
  for (double z : {-.5, 0., 1.}) {
    const shapes::Mesh m = box_mesh({-1, -.5, z}, {1, .5, z + 1});
    const bodies::ConvexMesh mesh(&m);
    bodies::Box box(&size);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().z() = z + .5;
    box.setPose(pose);
    Points a, b, up_a, up_b;
    mesh.intersectsRay({.3, .1, 10}, {0, 0, -1}, &a), box.intersectsRay({.3, .1, 10}, {0, 0, -1}, &b);
    mesh.intersectsRay({.3, .1, z + .5}, {0, 0, 1}, &up_a), box.intersectsRay({.3, .1, z + .5}, {0, 0, 1}, &up_b);
    std::printf("foot at %4.1f: ", z), show("from above", a), show("; Box", b), show("; upwards from the middle", up_a), show("; Box", up_b), std::puts("");
    as_described = as_described && near(b, {{.3, .1, z + 1}, {.3, .1, z}}) && near(up_b, {{.3, .1, z + 1}}) && near(a, {{.3, .1, -z}, {.3, .1, -z - 1}}) &&
                   (z < 0 ? near(up_a, {{.3, .1, .5}}) : up_a.empty()) && mesh.containsPoint({.3, .1, z + .5}) &&
                   (z < 0 || !mesh.containsPoint({.3, .1, -z - .5}));
  }
  // Rays from far away through random points of a unit cube: centred on its origin, with a corner there, and a primitive box.
  std::mt19937 random(1);
  auto uniform = [&] { return random() / 4294967296.0; };
  const shapes::Mesh centred = box_mesh({-.5, -.5, -.5}, {.5, .5, .5}), corner = box_mesh({0, 0, 0}, {1, 1, 1});
  const shapes::Box unit(1, 1, 1);
  for (double scale : {1., 1.5}) {
    bodies::ConvexMesh bodies_of_mesh[2] = {bodies::ConvexMesh(&centred), bodies::ConvexMesh(&corner)};
    bodies::Box reference[2] = {bodies::Box(&unit), bodies::Box(&unit)};
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Vector3d(.5, .5, .5);
    reference[1].setPose(pose);
    for (int k = 0; k < 2; ++k) {
      bodies_of_mesh[k].setScale(scale), reference[k].setScale(scale);
      int missed = 0, one = 0, right = 0, box_two = 0;
      for (int i = 0; i < 1000; ++i) {
        const Vector3d through = Vector3d(uniform(), uniform(), uniform()) - Vector3d(.5, .5, .5) * (1 - k);
        const Vector3d d = Vector3d(uniform() - .5, uniform() - .5, uniform() - .5).normalized(), o = through - 10 * d;
        Points a, b;
        missed += !bodies_of_mesh[k].intersectsRay(o, d, &a);
        reference[k].intersectsRay(o, d, &b);
        one += a.size() == 1, box_two += b.size() == 2;
        right += b.size() == 2 && near(a, {b[0], b[1]});
      }
      std::printf("cube %s, scale %g: of 1000 rays through it %d are said to miss it, %d to meet it once, %d have the right two points; Box %d\n",
                  k ? "with a corner in its origin" : "centred on its origin", scale, missed, one, right, box_two);
      as_described = as_described && box_two == 1000 && (k ? missed > 10 && right < 200 : right == 1000);
    }
  }
  return as_described ? 0 : 1;
}
C
g++ -O1 -std=c++17 -Iroot/usr/include -Iroot/usr/include/eigen3 ray.cpp -o ray -L"$lib" -lgeometric_shapes -lrandom_numbers -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./ray
