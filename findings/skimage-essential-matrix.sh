#!/bin/sh
# scikit-image 0.19.3 (Debian 12): the essential matrix that EssentialMatrixTransform.estimate() finds from exact correspondences is none. The eight-
# point algorithm reckons in moved and scaled points; estimate() makes the two singular values equal while still there and undoes the scaling
# afterwards, which makes them unequal again (an essential matrix asks for it in the cameras' own coordinates). So the constraint is lost, and what
# was right before it is not any more: exact points leave residuals of up to 130 pixels, and the rotation of the cameras that comes from the matrix is
# off by degrees. The direction of the translation is right, as the null vectors are. FundamentalMatrixTransform, with the same points and the same
# steps but rank 2 as its only constraint, which no scaling disturbs, gives the essential matrix exactly. It does not show where moving and scaling
# leave the points as they are. The test of scikit-image has its figures from COLMAP, when that had the same fault (COLMAP's issue 861 of 2020,
# repaired there). estimate() returns True, and nothing is said.
set -eu
skimage=0.19.3-8
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-skimage=$skimage" "python3-skimage-lib=$skimage+b1" python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2 python3-packaging \
  python3-decorator libblas3 liblapack3 libgfortran5 libquadmath0 liblbfgsb0
for package in *.deb; do dpkg -x "$package" root; done
cat > essential.py <<'P'
import sys
import numpy as np
import skimage
from skimage.measure import ransac
from skimage.transform import EssentialMatrixTransform, FundamentalMatrixTransform

FOCAL = 1000  # pixels, only to print residuals in pixels


def about(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    m = np.eye(3)
    m[i, i] = m[j, j] = c
    m[i, j], m[j, i] = -s, s
    return m


def poses(e):
    """The two rotations and the direction (up to sign) of the translation of an essential matrix."""
    u, _, v = np.linalg.svd(e)
    u, v = u * np.sign(np.linalg.det(u)), v * np.sign(np.linalg.det(v))
    w = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    return (u @ w @ v, u @ w.T @ v), u[:, 2]


def angle(cosine):
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


def errors(e, rotation, direction):
    """What the better of the two rotations, and the direction, are off, in degrees."""
    rotations, t = poses(e)
    return min(angle((np.trace(r.T @ rotation) - 1) / 2) for r in rotations), angle(abs(t @ direction))


print("scikit-image", skimage.__version__)
as_described = True
scenes = (("camera turned by 2, 10, 1 degrees", (-3, 3, -2, 2, 5, 9), (2, 10, 1), (-1, 0.1, 0.2)),
          ("camera turned by 20, 20, 0 degrees", (-6, 6, -1, 1, 4, 12), (20, 20, 0), (-3, 3, 2)),
          ("the same, points at the left", (-6, 0, -1, 1, 4, 8), (20, 20, 0), (-3, 3, 2)))
for name, box, turn, move in scenes:
    rng = np.random.RandomState(3)
    low, high = np.array(box[::2], float), np.array(box[1::2], float)
    first = low + (high - low) * rng.uniform(size=(60, 3))
    rotation = about("x", turn[0]) @ about("y", turn[1]) @ about("z", turn[2])
    second = first @ rotation.T + move
    assert first[:, 2].min() > 1 and second[:, 2].min() > 1  # in front of both cameras
    a, b = first[:, :2] / first[:, 2:], second[:, :2] / second[:, 2:]
    direction = np.array(move) / np.linalg.norm(move)
    true = EssentialMatrixTransform(rotation, direction)
    essential, fundamental = EssentialMatrixTransform(), FundamentalMatrixTransform()
    assert essential.estimate(a, b) and fundamental.estimate(a, b)
    print(f"60 exact points, {name}")
    figures = {}
    for label, t in (("true matrix", true), ("EssentialMatrixTransform", essential), ("FundamentalMatrixTransform", fundamental)):
        s = np.linalg.svd(t.params)[1]
        residual = FOCAL * t.residuals(a, b).max()
        rot, direct = errors(t.params, rotation, direction)
        figures[label] = (s[1] / s[0], residual, rot, direct)
        print(f"  {label:27s} singular values 1 : {s[1] / s[0]:.3f} : {s[2] / s[0]:.3f}, largest residual {residual:5.2f} pixels, rotation {rot:.2f} "
              f"degrees off, direction {direct:.2f}")
    # the same constraint, put on the right side of the scaling: nothing is left to be done to exact points
    u, s, v = np.linalg.svd(fundamental.params)
    after = EssentialMatrixTransform(matrix=u @ np.diag([(s[0] + s[1]) / 2] * 2 + [0]) @ v)
    residual = FOCAL * after.residuals(a, b).max()
    print(f"  singular values made equal after the scaling is undone: largest residual {residual:.2f} pixels")
    ratio, wrong, rot, direct = figures["EssentialMatrixTransform"]
    as_described &= residual < 1e-6 and ratio < 0.99 and wrong > 2 and rot > 0.3 and direct < 1e-3
    for label in ("true matrix", "FundamentalMatrixTransform"):
        ratio, right, rot, direct = figures[label]
        as_described &= abs(ratio - 1) < 1e-6 and right < 1e-6 and rot < 1e-3 and direct < 1e-3
inliers = {t.__name__: int(ransac((a, b), t, min_samples=8, residual_threshold=1 / FOCAL, max_trials=100, random_state=1)[1].sum())
           for t in (EssentialMatrixTransform, FundamentalMatrixTransform)}
print("ransac() with a threshold of 1 pixel, inliers of the 60 exact points:", inliers)
as_described &= wrong > 20 and inliers["FundamentalMatrixTransform"] == 60 and inliers["EssentialMatrixTransform"] < 60
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore essential.py
