#!/bin/sh
# vedo 2023.4.3 (Debian 12): apply_transform(M), 'a linear or non-linear transformation' by a 4x4 or 3x3 matrix, does not apply a matrix with shear
# or with a mirror. Unless reset=True is given it takes M apart with GetScale(), GetOrientation() and GetPosition() of vtkTransform and gives these
# to the actor, which scales, turns and moves, in this order; what is not of that form is lost. A shear becomes a scaling and a turn with the same
# volume, a mirror along x one along y, and a turn followed by a scaling along x a scaling along x followed by the turn. points(), polydata() and
# all that is computed from them take the wrong matrix. So transform_with_landmarks(least_squares=True), where the axes 'can vary orientation',
# fits the right affine map and does not take the landmarks to their targets, while affine=True, VTK's own affine fit, and reset=True do.
# Rotations, moves, and scalings along the body's own axes are right, and the determinant is always right. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
vtk=9.1.0+really9.1.0+dfsg2-5+deb12u1
apt-get download -qq python3-vedo=2023.4.3-1 "python3-vtk9=$vtk" "libvtk9.1=$vtk" python3-numpy=1:1.24.2-1+deb12u1 python3-deprecated python3-wrapt python3-pygments \
  libblas3 liblapack3 libgfortran5 libquadmath0 libopenmpi3 libx11-6 libxcb1 libxau6 libxdmcp6 libwebp7 libtiff6 libtbb12 libpng16-16 libopengl0 liblz4-1 \
  liblerc4 libjsoncpp25 libjpeg62-turbo libjbig0 libhwloc15 libglx0 libglvnd0 libglew2.2 libgl2ps1.4 libgl1 libfreetype6 libexpat1 libevent-pthreads-2.1-7 \
  libevent-core-2.1-7 libdouble-conversion3 libdeflate0 libbrotli1 libbsd0 libmd0 libudev1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > affine.py <<'P'
import sys
sys.modules["matplotlib"] = None  # only for colours
import numpy as np
import vedo

print("vedo", vedo.__version__)
as_described = True
rng = np.random.RandomState(1)
p = rng.normal(size=(8, 3))
q, r = np.linalg.qr(rng.normal(size=(3, 3)))
q = q * np.sign(np.diag(r))
q = q * np.sign(np.linalg.det(q))
move = np.array([1, 2, 3.0])


def matrix(a):
    m = np.eye(4)
    m[:3, :3] = a
    m[:3, 3] = move
    return m


def linear(points):
    """The linear part of the affine map that takes p to the points, and how far it misses them."""
    x, *_ = np.linalg.lstsq(np.c_[p, np.ones(len(p))], points, rcond=None)
    assert abs(np.c_[p, np.ones(len(p))] @ x - points).max() < 1e-5
    return x[:3].T


c = 0.5 ** 0.5
turn = np.array([[c, -c, 0], [c, c, 0], [0, 0, 1]])
shear = np.array([[1, 0.5, 0], [0, 1, 0], [0, 0, 1]])
mirror = np.diag([-1.0, 1, 1])
cases = (("rotation", q, True), ("2 x rotation", 2 * q, True), ("scaled by 1, 2, 3, then turned", q @ np.diag([1.0, 2, 3]), True),
         ("turned by 45 degrees, then scaled by 3 along x", np.diag([3.0, 1, 1]) @ turn, False), ("shear x + 0.5 y", shear, False), ("mirror -x", mirror, False),
         ("mirrored, then turned", q @ mirror, False))
got = {}
for name, a, right in cases:
    o = vedo.Points(p.copy())
    o.apply_transform(matrix(a))
    got[name] = linear(o.points())
    w = vedo.Points(p.copy())
    w.apply_transform(matrix(a), reset=True)
    off = abs(o.points() - (p @ a.T + move)).max()
    off_reset = abs(w.points() - (p @ a.T + move)).max()
    print(f"{name}: farthest point off by {off:.3f}, with reset=True by {off_reset:.3f}; determinant {np.linalg.det(got[name]):.3f}, right {np.linalg.det(a):.3f}")
    if not right:
        print("   matrix applied", got[name].round(3).tolist(), "right", a.round(3).tolist())
    as_described &= off_reset < 1e-5 and (off < 1e-5 if right else off > 0.3)

columns = got["shear x + 0.5 y"]
columns = columns / np.linalg.norm(columns, axis=0)
as_described &= abs(columns.T @ columns - np.eye(3)).max() < 1e-4

target = p @ shear.T + move
for options in ({"affine": True}, {"least_squares": True}):
    o = vedo.Points(p.copy())
    o.transform_with_landmarks(vedo.Points(p), vedo.Points(target), **options)
    off = abs(o.points() - target).max()
    if "affine" in options:
        print(f"transform_with_landmarks, 8 landmarks and their images by the shear, {options}: farthest off by {off:.3f}")
        as_described &= off < 1e-4
    else:
        fitted = np.array([[o.transform.GetMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
        print(f"the same with {options}: farthest off by {off:.3f}; matrix in .transform {fitted.round(3).tolist()}, applied {linear(o.points()).round(3).tolist()}")
        as_described &= off > 0.3 and abs(fitted - shear).max() < 1e-6
sheared = vedo.Cube(side=2).apply_transform(matrix(shear))
corner = sheared.points()
print(f"a cube of side 2, sheared: bounds along x {corner[:, 0].min() - 1:.3f} .. {corner[:, 0].max() - 1:.3f}, right -1.5 .. 1.5")
as_described &= abs(corner[:, 0].max() - 2.068) < 0.01
as_described &= abs(got["mirror -x"] - np.diag([1, -1, 1])).max() < 1e-4
as_described &= abs(got["turned by 45 degrees, then scaled by 3 along x"] - turn @ np.diag([3, 1, 1])).max() < 1e-4
sys.exit(0 if as_described else 1)
P
LD_LIBRARY_PATH=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':') OPENBLAS_NUM_THREADS=1 \
  PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore affine.py
