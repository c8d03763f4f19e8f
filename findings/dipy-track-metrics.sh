#!/bin/sh
# DIPY 1.6.0 (Debian 12): two of the figures that dipy.tracking.metrics has for the shape of a fibre's track are not what they are called.
# frenet_serret() says that the torsion is -B'.N, but takes the product of N with B itself (its comment shows the line of Matlab that it follows,
# the prime missing there as well); as the two are at right angles, every curve has torsion 0, helices of either hand like the circle, while
# tangent, normal, binormal and curvature are right. winding(), 'the cumulative signed angle between each line segment and the previous one' in
# the best plane, never forms segments: it adds up the unsigned angles between neighbouring points as seen from their centroid. So a straight track
# has 180 degrees, a quarter of a circle 210 and a half 245, and a track that turns left and then right as much as one that goes on turning. It
# does not show for closed circles, where both are 360. The tests ask of winding() only that it be a number, and nothing of the torsion. Nothing
# is said.
set -eu
dipy=1.6.0-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-dipy=$dipy" "python3-dipy-lib=$dipy+b1" python3-nibabel=5.0.0-2 python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2 \
  python3-packaging python3-decorator libblas3 liblapack3 libgfortran5 libquadmath0 liblbfgsb0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > track.py <<'P'
import sys
import numpy as np
import dipy
from dipy.tracking.metrics import frenet_serret, winding

print("DIPY", dipy.__version__)
as_described = True
s = np.linspace(0, 1, 1001)
mid = slice(100, -100)


def torsion(T, N, B, step):
    return -np.sum(np.gradient(B, step, axis=0) * N, axis=1)


def rotation(axis, angle):
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


turn = rotation(np.array([1, 2, 2]) / 3, 0.7)
for name, pitch in (("circle of radius 3", 0), ("right-handed helix, radius 3, rise 4 a radian", 4), ("left-handed helix", -4)):
    angle = 9 * s
    curve = np.c_[3 * np.cos(angle), 3 * np.sin(angle), pitch * angle] @ turn.T
    T, N, B, k, t = frenet_serret(curve)
    step = np.linalg.norm(np.diff(curve, axis=0), axis=1).mean()
    speed2 = 9 + pitch ** 2
    mine = torsion(T, N, B, step)[mid]
    print(f"{name:46s} curvature {k[mid].mean():.3f} (right {3 / speed2:.3f}), torsion {abs(t[mid]).max():.3f}, -B'.N of the same frame "
          f"{mine.mean():6.3f} (right {pitch / speed2:6.3f})")
    as_described &= abs(k[mid] - 3 / speed2).max() < 1e-3 and abs(mine - pitch / speed2).max() < 1e-3 and abs(t).max() < 1e-9


def turning(curve):
    """Signed angles between successive segments of a plane curve, summed, in degrees."""
    d = np.diff(curve[:, :2], axis=0)
    return np.degrees(np.arctan2(d[:-1, 0] * d[1:, 1] - d[:-1, 1] * d[1:, 0], (d[:-1] * d[1:]).sum(axis=1)).sum())


def arc(degrees):
    a = np.radians(degrees) * s
    return 5 * np.c_[np.cos(a), np.sin(a), 0 * a]


line = np.c_[10 * s, 3 * s, 0 * s]
quarter = arc(90)
serpentine = np.r_[quarter, 2 * quarter[-1] - quarter[-2::-1]]  # the same quarter, turned by 180 degrees about its end
for name, curve, wrong in (("straight line", line, 180), ("quarter of a circle", arc(90), 210), ("half of a circle", arc(180), 245),
                           ("three quarters", arc(270), 290), ("S of two quarters", serpentine, None), ("circle", arc(360), 360)):
    got, right = winding(curve @ turn.T + [7, 8, 9]), abs(turning(curve))
    print(f"{name:46s} winding {got:5.1f} degrees, right {right:5.1f}")
    if wrong is not None:
        as_described &= abs(got - wrong) < 1
    as_described &= (abs(got - right) < 1) == (name == "circle")
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore track.py
