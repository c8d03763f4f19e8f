#!/bin/sh
# DIPY 1.6.0 (Debian 12): circumradius(a, b, c) of dipy.core.geometry depends on how the triangle lies in space and which vertex is named first.
# Turned about, an equilateral triangle of circumradius 1 has anything from 0.41 to 0.87; one and the same right triangle has 0.71 or 1.80,
# according to the order. The centre w, seen from c, is to be found from x.w = |x|^2/2, y.w = |y|^2/2 and z.w = 0, with the rows x = a - c,
# y = b - c and z = x cross y. The function solves with the transpose of that matrix, so that the two squared lengths are taken for coordinates in
# space, and then halves the length of w, which is the radius already. It scales with the unit, as a radius should, and moving the triangle does not
# change it, so that neither gives it away. DIPY's own test has a wrong figure: sqrt(0.5) for the right triangle with legs of 2, whose radius is
# half the hypotenuse, sqrt(2). Nothing is said.
set -eu
dipy=1.6.0-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-dipy=$dipy" "python3-dipy-lib=$dipy+b1" python3-nibabel=5.0.0-2 python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2 \
  python3-packaging python3-decorator libblas3 liblapack3 libgfortran5 libquadmath0 liblbfgsb0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > triangle.py <<'P'
import sys
import numpy as np
import dipy
from dipy.core.geometry import circumradius

print("DIPY", dipy.__version__)
as_described = True


def right(a, b, c):
    """The product of the sides over four times the area."""
    u, v, w = (np.linalg.norm(x) for x in (b - c, c - a, a - b))
    return u * v * w / (2 * np.linalg.norm(np.cross(a - c, b - c)))


def transposed(a, b, c, fixed):
    x, y = a - c, b - c
    m = np.vstack((x, y, np.cross(x, y)))
    w = np.linalg.solve(m if fixed else m.T, [x @ x / 2, y @ y / 2, 0])
    return np.linalg.norm(w) / (1 if fixed else 2)


def turns(count):
    rng = np.random.RandomState(1)
    for _ in range(count):
        q, r = np.linalg.qr(rng.normal(size=(3, 3)))
        q = q * np.sign(np.diag(r))
        yield q * np.sign(np.linalg.det(q))


h = 0.75 ** 0.5
triangles = (("equilateral, radius 1", [[1, 0, 0], [-0.5, h, 0], [-0.5, -h, 0]]), ("right-angled, legs of 2", [[0, 2, 0], [2, 0, 0], [0, 0, 0]]),
             ("sides 5, 5, 6", [[0, 4, 0], [3, 0, 0], [-3, 0, 0]]))
worst = 0
for name, points in triangles:
    p = np.array(points, float)
    r = right(*p)
    got = [circumradius(*(p @ q.T)) for q in turns(2000)]
    order = [circumradius(*p[list(i)]) for i in ((0, 1, 2), (1, 2, 0), (2, 0, 1))]
    scaled = circumradius(*(p * 10)) / 10
    moved = circumradius(*(p + [7, 8, 9]))
    causes = [abs(transposed(*(p @ q.T), True) - r) + abs(transposed(*(p @ q.T), False) - circumradius(*(p @ q.T))) for q in turns(50)]
    print(f"{name:24s} right {r:.3f}; as it stands, by first vertex: {order[0]:.3f} {order[1]:.3f} {order[2]:.3f}; turned about: {min(got):.3f} to "
          f"{max(got):.3f}; moved {moved:.3f}; times 10, over 10: {scaled:.3f}; with the matrix not transposed and nothing halved: {transposed(*p, True):.3f}")
    as_described &= max(causes) < 1e-8 and abs(scaled - order[0]) < 1e-9 and abs(moved - order[0]) < 1e-9
    as_described &= max(got) / min(got) > 1.5 and max(order) - min(order) > 0.1
    worst = max(worst, max(abs(np.array(got) / r - 1)))
    if name.startswith("equilateral"):
        as_described &= 0.40 < min(got) < 0.42 and 0.85 < max(got) < 0.88
    if name.startswith("right"):
        as_described &= abs(order[0] - 0.5 ** 0.5) < 1e-9 and abs(max(order) - 1.8028) < 1e-3
print(f"largest relative error {worst:.2f}")
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore triangle.py
