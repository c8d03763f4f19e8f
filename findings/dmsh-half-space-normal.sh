#!/bin/sh
# dmsh 0.2.19 (Debian 12), a mesh generator: a domain cut off by HalfSpace(normal, alpha), the points with normal.x >= alpha, gets a broken mesh if
# the normal is not of length 1 and the line does not go through the origin. boundary_step(), which puts points that have left the domain back on the
# line, subtracts normal.x / |normal|^2 from alpha where (alpha - normal.x) / |normal|^2 is meant; dist() takes alpha as it is, as does the list of
# corners. So with (1, 1) and 0.5 points are moved onto x + y = 1, in place of 0.5, and a unit square without a corner, area 0.875, comes as
# triangles of 2.4 in all that lie on each other, with 19 points for 102; a disk without a cap has 9 points for 64, and two thirds of its area. With
# other lengths, mostly those below 1, the points land outside and generate() stops at an assertion, which does not name the half space. The README
# has HalfSpace([1.0, 1.0]), with alpha 0, which is right, as are normals of length 1 with any alpha. Of the mesh that comes back nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq python3-dmsh=0.2.19-1 python3-meshplex=0.17.1-2 python3-npx=0.1.1-1 python3-meshio=7.0.0-3 python3-rich python3-importlib-metadata \
  python3-pygments python3-markdown-it python3-mdurl python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2 python3-decorator libblas3 liblapack3 libgfortran5 \
  libquadmath0 liblbfgsb0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > half.py <<'P'
import sys
import numpy as np
import dmsh
from dmsh import Circle, HalfSpace, Rectangle, generate

print("dmsh 0.2.19")
as_described = True
ones = np.array([1.0, 1.0])
unit = 0.5 ** 0.5


def area(points, cells):
    a, b, c = points[cells].transpose(1, 0, 2)
    return np.abs(np.cross(b - a, c - a)).sum() / 2


points = np.array([[0.0, 1.0, 0.3, 0.9], [0.0, 1.0, 0.1, 0.2]])
print("where boundary_step() puts points for the line x + y = 0.5 (value of x + y), by length of the normal")
for k in (unit, 1.0, 0.5, 2.0):
    half = HalfSpace(ones * k, 0.5 * k)
    y = half.boundary_step(points.copy())
    right = points + np.multiply.outer(ones * k, (0.5 * k - k * points.sum(0)) / (2 * k * k))
    where = 2 * k * k * 0.5 * k / k  # the line that the wrong quotient leads to
    print(f"   {k * 2 ** 0.5:.3f}: {y.sum(0).round(6)}, by (alpha - n.x) / |n|^2: {right.sum(0).round(6)}; dist() of the results {half.dist(y).round(4)}")
    as_described &= np.allclose(y.sum(0), where) and np.allclose(right.sum(0), 0.5) and np.allclose(half.dist(right), 0)
for k in (unit, 1.0, 2.0):
    half = HalfSpace(ones * k, 0.0)
    as_described &= np.allclose(half.boundary_step(points.copy()).sum(0), 0)

figures = {}
cap = 0.25 * (np.arccos(0.2 * unit / 0.5) - 0.2 * unit / 0.5 * np.sin(np.arccos(0.2 * unit / 0.5)))  # disk of radius 0.5, line 0.2 / sqrt(2) from the centre
right = {"square": 0.875, "disk": np.pi / 4 - cap}
for name, body, offset in (("square", lambda: Rectangle(0, 1, 0, 1), 0.5), ("disk", lambda: Circle([0.5, 0.5], 0.5), 0.8)):
    for k in (unit, 1.0):
        mesh, cells = generate(body() & HalfSpace(ones * k, offset * k), 0.1, tol=1e-5, max_steps=300)
        figures[name, k] = area(mesh, cells), len(mesh)
        print(f"{name} with x + y >= {offset}, normal of length {k * 2 ** 0.5:.3f}: {len(mesh)} points, area {area(mesh, cells):.3f}, right {right[name]:.3f}")
for k in (1.0, 2.0):
    mesh, cells = generate(Rectangle(-1, 1, -1, 1) & HalfSpace(ones * k, 0.0), 0.2, tol=1e-5, max_steps=300)
    print(f"square from -1 to 1 with x + y >= 0, normal of length {k * 2 ** 0.5:.3f}: {len(mesh)} points, area {area(mesh, cells):.3f}, right 2")
    as_described &= abs(area(mesh, cells) - 2) < 1e-6

# the same with the quotient put right
HalfSpace.boundary_step = lambda self, x: x + np.multiply.outer(self.normal, (self.alpha - np.dot(self.normal, x)) / np.dot(self.normal, self.normal))
for name, body, offset in (("square", lambda: Rectangle(0, 1, 0, 1), 0.5), ("disk", lambda: Circle([0.5, 0.5], 0.5), 0.8)):
    mesh, cells = generate(body() & HalfSpace(ones, offset), 0.1, tol=1e-5, max_steps=300)
    print(f"{name}, normal of length 1.414, quotient put right: {len(mesh)} points, area {area(mesh, cells):.3f}")
    as_described &= abs(area(mesh, cells) - right[name]) < 0.01 and len(mesh) > 0.8 * figures[name, unit][1]
    good, bad = figures[name, unit], figures[name, 1.0]
    as_described &= abs(good[0] - right[name]) < 0.01 and abs(bad[0] - right[name]) > 0.1 and bad[1] < good[1] / 3
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore half.py
