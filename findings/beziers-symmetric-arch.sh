#!/bin/sh
# beziers 0.5.0 (Debian 12; 0.6.0 of Debian 13 gives the same), a library for the outlines of letters: symmetric curves have no top. The bounding
# box of the arch (0,0) (0,100) (100,100) (100,0), which is 75 high, has the height 0, as has that of a half circle; findExtremes() is empty, and
# lines that cut it, parallel to its foot, do not meet it. quadraticRoots(a, b, c) has no roots where a is 0, in place of the one of the linear
# equation, and CubicBezier._findRoots() none where the coefficient of the cube is 0, in place of the two of the quadratic one; for such arches
# both are 0. The second is 0, or nearly, for any quadratic curve made cubic, as quadraticsToCubics() does for TrueType outlines: of the intersections
# with lines, in any direction, nearly all are gone, and half of the boxes are too small. As boxes decide whether two curves can meet, an arch
# meets no other curve, and pointIsInside() takes a point beside a letter D for inside. One unit of asymmetry, and all is right. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq python3-beziers=0.5.0+dfsg1-1 python3-pyclipper=1.2.1-1+b4 libpolyclipping22 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > arch.py <<'P'
import random
import sys
import beziers.cubicbezier
from beziers.boundingbox import BoundingBox
from beziers.cubicbezier import CubicBezier
from beziers.line import Line
from beziers.path import BezierPath
from beziers.point import Point as P
from beziers.quadraticbezier import QuadraticBezier

print("beziers 0.5.0")
as_described = True


def box(b):
    return (round(b.left, 2), round(b.bottom, 2), round(b.right, 2), round(b.top, 2))


def sampled(curve, n=2000):
    """The right bounding box, but for the spacing of the samples."""
    b = BoundingBox()
    for i in range(n + 1):
        b.extend(curve.pointAtTime(i / n))
    return box(b)


def crossings(curve, y0, y1, n=2000):
    """How often the curve goes through the line from (-1000, y0) to (1000, y1)."""
    side = [p.y - (y0 + (y1 - y0) * (p.x + 1000) / 2000) > 0 for p in (curve.pointAtTime(i / n) for i in range(n + 1))]
    return sum(a != b for a, b in zip(side, side[1:]))


other = CubicBezier(P(50, 50), P(50, 100), P(60, 100), P(60, 50))  # goes up through the top of the arch and down again
curves = (("arch", CubicBezier(P(0, 0), P(0, 100), P(100, 100), P(100, 0))), ("arch, one control point 1 higher", CubicBezier(P(0, 0), P(0, 100), P(100, 101), P(100, 0))),
          ("half circle", CubicBezier(P(-100, 0), P(-100, 400 / 3), P(100, 400 / 3), P(100, 0))))
for name, curve in curves:
    lines = [len(curve.intersections(Line(P(-1000, y), P(1000, y)))) for y in (10, 30, 50, 70)]
    meets = len(curve.intersections(other))
    right = sampled(curve)
    print(f"{name}: box {box(curve.bounds())}, right {right}; extremes at {[round(t, 3) for t in curve.findExtremes()]}; intersections with the lines "
          f"y = 10, 30, 50, 70: {lines}, right {[crossings(curve, y, y) for y in (10, 30, 50, 70)]}; with another curve: {meets}")
    as_described &= all(crossings(curve, y, y) == 2 for y in (10, 30, 50, 70)) and right[3] > 74.9
    if "higher" in name:
        as_described &= abs(box(curve.bounds())[3] - right[3]) < 0.01 and lines == [2, 2, 2, 2] and meets == 2
    else:
        as_described &= box(curve.bounds())[3] == 0 and lines == [0, 0, 0, 0] and curve.findExtremes() == []
        as_described &= meets == 0 or name != "arch"

letter = [Line(P(0, 0), P(0, 100)), CubicBezier(P(0, 100), P(100, 100), P(100, 0), P(0, 0))]
bent = [letter[0], CubicBezier(P(0, 100), P(101, 100), P(100, 0), P(0, 0))]
for name, segments in (("D", letter), ("D, one control point 1 farther out", bent)):
    path = BezierPath.fromSegments(segments)
    path.closed = True
    inside = [path.pointIsInside(P(x, 40)) for x in (-5, 30, 60, 70)]
    print(f"{name}: box {box(path.bounds())}; inside at x = -5, 30, 60, 70, y = 40: {inside}, right [False, True, True, True]; area {path.area:.0f}")
    as_described &= inside == ([True, True, True, True] if name == "D" else [False, True, True, True])
    as_described &= box(path.bounds())[2] == 0 if name == "D" else box(path.bounds())[2] > 70

random.seed(1)
found, cubic, right, small, worst = 0, 0, 0, 0, 0
for _ in range(1000):
    q = QuadraticBezier(*(P(random.randint(0, 100), random.randint(0, 100)) for _ in range(3)))
    c = q.toCubicBezier()
    y0, y1 = random.randint(0, 100) + 0.5, random.randint(0, 100) + 0.5
    line = Line(P(-1000, y0), P(1000, y1))
    found, cubic, right = found + len(q.intersections(line)), cubic + len(c.intersections(line)), right + crossings(q, y0, y1)
    a, b, d = box(c.bounds()), box(q.bounds()), sampled(q)
    small += max(abs(u - v) for u, v in zip(a, d)) > 1
    worst = max(worst, max(abs(u - v) for u, v in zip(a, d)))
    assert max(abs(c.pointAtTime(t).distanceFrom(q.pointAtTime(t))) for t in (0.2, 0.5, 0.9)) < 1e-9
print(f"1000 quadratic curves and lines: {found} intersections (by signs {right}); the same curves made cubic: {cubic}; {small} of their boxes off by more than 1, up to {worst}")
as_described &= abs(found - right) < 0.02 * right and cubic < 0.2 * right and small > 200

# the same with the linear equation solved as well
quadratic = beziers.cubicbezier.quadraticRoots
beziers.cubicbezier.quadraticRoots = lambda a, b, c: quadratic(a, b, c) if a != 0 or b == 0 else [t for t in [-c / b] if 0 <= t <= 1]
print(f"with the root of the linear equation: box of the arch {box(curves[0][1].bounds())}, of the half circle {box(curves[2][1].bounds())}")
as_described &= box(curves[0][1].bounds())[3] == 75 and box(curves[2][1].bounds())[3] == 100
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu"
PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore arch.py
