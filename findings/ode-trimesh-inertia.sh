#!/bin/sh
# ODE 0.16.2 (Debian 12): dMassSetTrimesh() counts the distance of the mesh from the origin twice. Its integrals over the triangles give the
# inertia about the origin; the centre of mass is then set through dMassTranslate(), which takes what it gets for an inertia about the centre and
# adds m |c|^2 once more. Moved back by -c, as a body needs it, it keeps that surplus: a box of 1 x 2 x 3 given as a mesh that stands on the origin
# instead of about it is 3 to 4 times as hard to tip, and one 10 away 121 times as hard to turn. Mass and centre are right, nothing is said, and
# a mesh about its own centre, as one tries first, is right in all. dMassSetBox() moved to the same place is the measure here.
set -eu
version=2:0.16.2-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libode8=$version" "libode-dev=$version" libccd2=2.1-2+b1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libode.so.8')")
cat > box.c <<'C'
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>
/* A box of 1 x 2 x 3 with its centre at `shift`, as a mesh and as a box; inertia about its own centre. Returns how many times too large the mesh's is. */
static double compare(const double shift[3]) {
  static const dTriIndex faces[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  float corners[24];
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) corners[3 * i + k] = (float)(shift[k] + (i >> k & 1 ? .5 : -.5) * (k + 1));
  dTriMeshDataID data = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildSingle(data, corners, 3 * sizeof(float), 8, faces, 36, 3 * sizeof(dTriIndex));
  dMass mesh, box;
  dMassSetTrimesh(&mesh, 1, dCreateTriMesh(0, data, 0, 0, 0));
  dMassSetBox(&box, 1, 1, 2, 3);
  dMassTranslate(&box, shift[0], shift[1], shift[2]);
  printf("centre (%g %g %g): mesh: mass %g, centre (%g %g %g); ", shift[0], shift[1], shift[2], mesh.mass, mesh.c[0], mesh.c[1], mesh.c[2]);
  const double off = fabs(mesh.mass - box.mass) + fabs(mesh.c[0] - box.c[0]) + fabs(mesh.c[1] - box.c[1]) + fabs(mesh.c[2] - box.c[2]);
  dMassTranslate(&mesh, -mesh.c[0], -mesh.c[1], -mesh.c[2]);
  dMassTranslate(&box, -box.c[0], -box.c[1], -box.c[2]);
  printf("inertia about the centre: mesh %.2f %.2f %.2f, box %.2f %.2f %.2f\n", mesh.I[0], mesh.I[5], mesh.I[10], box.I[0], box.I[5], box.I[10]);
  return off < 1e-4 ? mesh.I[5] / box.I[5] : -1;
}
int main(void) {
  dInitODE();
  printf("ODE, configuration %s\n", dGetConfiguration());
  const double about[3] = {0, 0, 0}, standing[3] = {0, 0, 1.5}, corner[3] = {.5, 1, 1.5}, far_off[3] = {10, 0, 0};
  const double r[4] = {compare(about), compare(standing), compare(corner), compare(far_off)};
  printf("too large by a factor of %.2f, %.2f, %.2f, %.2f about y\n", r[0], r[1], r[2], r[3]);
  return !(fabs(r[0] - 1) < 1e-4 && fabs(r[1] - 3.7) < 1e-3 && fabs(r[2] - 4) < 1e-3 && fabs(r[3] - 121) < .1);
}
C
cc -w -DdIDEDOUBLE -I root/usr/include box.c -o box -L "$lib" -lode -lm -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./box
