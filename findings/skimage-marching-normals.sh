#!/bin/sh
# scikit-image 0.19.3 (Debian 12; 0.25.2 of Debian 13 has the same lines): the normals that marching_cubes() returns are not at right angles to the
# surface it returns, once the voxels are not cubes. With `spacing` the vertices are multiplied by it at the end (_marching_cubes_lewiner()), and the
# normals, unit vectors along the gradient per voxel, are left as they are; to be normal they would have to be divided by it. For slices of
# 5 mm with pixels of 0.5 mm the normals of a ball of 20 mm are up to 60 degrees off the radius, on average 37, all leaning to the axis of the
# slices: shading, offsets along the normals, and fits and registrations fed with them go wrong, while vertices, faces and area are right and
# the normals do have length 1. Divided by the spacing they are right to some degrees. With cubic voxels, of whatever size, it does not show.
# The documentation has 'the normal direction at each vertex, as calculated from the data', and that vertices are in the spacing's unit. Nothing is said.
set -eu
skimage=0.19.3-8
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-skimage=$skimage" "python3-skimage-lib=$skimage+b1" python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2 python3-packaging \
  python3-decorator libblas3 liblapack3 libgfortran5 libquadmath0 liblbfgsb0
for package in *.deb; do dpkg -x "$package" root; done
cat > ball.py <<'P'
import sys
import numpy as np
import skimage
from skimage.measure import marching_cubes, mesh_surface_area

RADIUS = 20.0
print("scikit-image", skimage.__version__)


def surface(spacing):
    """Vertices about the middle, faces and normals of the surface of a ball, from its signed distance (greater than 0 inside)."""
    n = 2 * np.ceil((RADIUS + 3 * spacing) / spacing).astype(int) + 1
    x = np.meshgrid(*[(np.arange(m) - (m - 1) / 2) * s for m, s in zip(n, spacing)], indexing="ij")
    vertices, faces, normals, _ = marching_cubes(RADIUS - np.sqrt(sum(a * a for a in x)), 0, spacing=tuple(spacing))
    return vertices - (n - 1) / 2 * spacing, faces, normals


def degrees(a, b):
    c = np.sum(a * b, axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
    return np.degrees(np.arccos(np.clip(c, -1, 1)))


as_described = True
for spacing in ([1, 1, 1], [0.5, 0.5, 0.5], [2, 1, 1], [5, 0.5, 0.5]):
    spacing = np.array(spacing, float)
    vertices, faces, normals = surface(spacing)
    radius = np.linalg.norm(vertices, axis=1)
    area = mesh_surface_area(vertices, faces) / (4 * np.pi * RADIUS ** 2)
    off, divided = degrees(normals, vertices), degrees(normals / spacing, vertices)
    # Points moved by 2 along their normals should all lie 2 farther out.
    moved = np.linalg.norm(vertices + 2 * normals, axis=1) - radius
    print("spacing %g %g %g: %d vertices at %.2f .. %.2f from the middle, area %.3f of the ball's; normals %.1f degrees off on average, up to %.1f;"
          " divided by the spacing up to %.1f; 2 along them is %.2f .. 2 out"
          % (*spacing, len(vertices), radius.min(), radius.max(), area, off.mean(), off.max(), divided.max(), moved.min()))
    as_described &= np.abs(radius - RADIUS).max() < 0.3 and abs(area - 1) < 0.02 and np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-5
    as_described &= divided.max() < 8
    ratio = spacing.max() / spacing.min()
    # The greatest angle between g and g divided by two spacings of ratio r is atan((r - 1) / (2 sqrt(r))).
    as_described &= off.max() < 3 if ratio == 1 else abs(off.max() - np.degrees(np.arctan((ratio - 1) / 2 / np.sqrt(ratio)))) < 8
    as_described &= ratio < 5 or off.max() > 50
sys.exit(not as_described)
P
modules=$(dirname "$(find root -path '*dist-packages/skimage/__init__.py' | head -n 1)")
LD_LIBRARY_PATH=$(find "$folder/root/usr/lib" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':') OPENBLAS_NUM_THREADS=1 \
  PYTHONPATH=$(dirname "$folder/$modules") /usr/bin/python3 -W ignore ball.py
