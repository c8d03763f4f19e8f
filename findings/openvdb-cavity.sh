#!/bin/sh
# OpenVDB 10.0.1 (Debian 12): a level set made from the mesh of a hollow body is full. createLevelSetFromPolygons() finds what is outside by
# filling from outside and takes all else for the body, whichever way the faces look: a cube of side 4 with a cavity of side 2, whose faces look
# inward as they should, has its middle 'inside' and volume 64 instead of 56, and the surface of the cavity is gone. Nothing is said.
set -eu
version=10.0.1-2
numpy=1:1.24.2-1+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-openvdb=$version" "libopenvdb10.0=$version" "libopenvdb-ax10.0=$version" "python3-numpy=$numpy" libblas3 liblapack3 \
  libgfortran5 libquadmath0 libboost-numpy1.74.0 libboost-python1.74.0 libboost-iostreams1.74.0 libimath-3-1-29 liblog4cplus-2.0.5 libtbb12 \
  libblosc1 libllvm14 libz3-4 libedit2 libbsd0 libmd0 libffi8 libxml2 libicu72 liblz4-1 libsnappy1v5 libzstd1
for package in *.deb; do dpkg -x "$package" root; done
cat > cavity.py <<'P'
import sys
import numpy as np
import pyopenvdb as vdb

cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float32)
outward = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]], np.uint32)


def volume(points, quads):
    points = points.astype(float)
    return sum(np.dot(points[a], np.cross(points[b], points[c]) + np.cross(points[c], points[d])) / 6 for a, b, c, d in quads)


def look(name, points, quads):
    grid = vdb.FloatGrid.createLevelSetFromPolygons(points, quads=quads, transform=vdb.createLinearTransform(0.1), halfWidth=3)
    surface, faces = grid.convertToQuads()
    middle, level_set = grid.getConstAccessor().getValue((0, 0, 0)), abs(volume(surface, faces))
    print(f"{name}: mesh {volume(points, quads):.2f}, level set {level_set:.2f}; {'inside' if middle < 0 else 'outside'} in the middle")
    return level_set, middle < 0


full = look("cube of side 4    ", 2 * cube, outward)
hollow = look("with a cavity of 2", np.vstack([2 * cube, cube]), np.vstack([outward, outward[:, ::-1] + 8]))
cavity = look("cube of side 2    ", cube, outward)
expected = (64, True), (64, True), (8, True)
sys.exit(0 if all(abs(a[0] - b[0]) < 0.1 and a[1] == b[1] for a, b in zip((full, hollow, cavity), expected)) else 1)
P
lib=$folder/root/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$lib:$lib/blas:$lib/lapack:$folder/root/lib/x86_64-linux-gnu PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 cavity.py
