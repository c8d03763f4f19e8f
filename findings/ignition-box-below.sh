#!/bin/sh
# Ignition (Gazebo) Math 6.10.0 (Debian 12): what a box has below a plane, volume_below() and center_of_volume_below(), which is meant for the
# buoyancy of floating bodies, is wrong. The centre is the mean of the corners of the part cut off, not its centre of volume: of a cube half in the
# water it stays exactly amidships however it heels, up to 40 degrees, so that there is no righting arm; the header says 'Center of volume below the
# plane', for 'where buoyancy should be applied'. To the volume, the cut itself belongs only if its corners lie on the plane to the last bit:
# TrianglesInPlane() takes the points with Side() == NO_SIDE, that is distance == 0 with no tolerance, and they come from Intersection(), with
# rounding. Otherwise the pyramid from the box's centre to the cut is left out: a cube of 1 that is 0.05 deep in the water displaces 0.2, four times
# too much, while 0.1 deep it is right; a box of 2 x 3 x 4 is wrong at 12 of 19 depths. It does not show for planes through the centre, at depths
# where the rounding happens to be 0, as at quarters of the height, nor in the centre of upright boxes. Sphere has both right. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq python3-ignition-math=6.10.0+ds3-7+b4 libignition-math6-6=6.10.0+ds3-7+b4 python3-numpy=1:1.24.2-1+deb12u1 libblas3 liblapack3 \
  libgfortran5 libquadmath0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > below.py <<'P'
import itertools
import sys
import numpy as np
from ignition.math import Boxd, Planed, Sphered, Vector3d

print("Ignition Math 6.10.0")


def library(body, normal, offset):
    plane = Planed(Vector3d(*map(float, normal)), float(offset))
    c = body.center_of_volume_below(plane)
    return body.volume_below(plane), np.array([c.x(), c.y(), c.z()])


def heeled(slope, offset):
    """Volume and centre of the unit cube below z = offset - slope x where the water does not reach a deck or a bottom: columns of that height."""
    volume = offset + 0.5
    return volume, np.array([-slope / 12, 0, (offset ** 2 + slope ** 2 / 12 - 0.25) / 2]) / [volume, 1, volume]


def counted(size, normal, offset, cells=60):
    """The same from small cells, for any plane."""
    steps = (np.arange(cells) + 0.5) / cells - 0.5
    p = np.array(list(itertools.product(steps, steps, steps))) * size
    p = p[p @ np.array(normal) < offset]
    return len(p) / cells ** 3 * np.prod(size), p.mean(0)


def without_cut(size, d):
    """The upright box with its five wet faces as pyramids from the centre, and none for the cut."""
    area, h = size[0] * size[1], size[2]
    return area * h / 6 + 2 * area * (d + h / 2) / 3


as_described = True
for size in ((1, 1, 1), (2, 3, 4)):
    right, wrong = [], []
    for i in range(-9, 10):
        d = i / 10 * size[2] / 2
        volume, centre = library(Boxd(*map(float, size)), (0, 0, 1), d)
        true = size[0] * size[1] * (d + size[2] / 2)
        as_described &= abs(volume - true) < 1e-9 or abs(volume - without_cut(size, d)) < 1e-9
        as_described &= np.abs(centre - [0, 0, (d - size[2] / 2) / 2]).max() < 1e-9
        (right if abs(volume - true) < 1e-9 else wrong).append((d + size[2] / 2, volume, true))
    print("box", size, "upright, depth: volume (true)  ", ", ".join(f"{a:.2f}: {b:.2f} ({c:.2f})" for a, b, c in wrong))
    print("   right at depths", ", ".join(f"{x[0]:.2f}" for x in right))
    as_described &= len(wrong) == 12 and len(right) == 7
    as_described &= abs(wrong[0][1] / wrong[0][2] - 4) < 1e-6
print("unit cube half in the water, heel in degrees: volume, centre x and z (true)")
for heel in (0, 5, 10, 20, 30, 40):
    a = np.radians(heel)
    normal = np.array([np.sin(a), 0, np.cos(a)])
    volume, centre = library(Boxd(1.0, 1.0, 1.0), normal, 0)
    true_volume, true_centre = heeled(np.tan(a), 0)
    count, mean = counted((1, 1, 1), normal, 1e-9)
    print(f"   {heel:2d}: {volume:.3f}, {centre[0]:.4f} {centre[2]:.4f} ({true_volume:.3f}, {true_centre[0]:.4f} {true_centre[2]:.4f}; "
          f"counted {count:.3f}, {mean[0]:.3f} {mean[2]:.3f})")
    as_described &= np.abs(centre - [0, 0, -0.25]).max() < 1e-9 and np.abs(mean - true_centre).max() < 0.01
    as_described &= heel == 0 or true_centre[0] < -0.014
ball = Sphered(1.0)
for d in (-0.9, -0.35, 0.1, 0.7):
    volume, centre = library(ball, (0, 0, 1), d)
    h = 1 + d
    true, z = np.pi * h * h * (3 - h) / 3, -3 * (2 - h) ** 2 / (4 * (3 - h))
    print(f"sphere of radius 1, depth {h:.2f}: volume {volume:.4f} ({true:.4f}), centre {centre[2]:.4f} ({z:.4f})")
    as_described &= abs(volume - true) < 1e-9 and abs(centre[2] - z) < 1e-9
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore below.py
