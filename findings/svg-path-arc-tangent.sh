#!/bin/sh
# svg.path 6.1 (Python, Debian 12): the tangents of elliptical arcs are wrong. Arc.tangent() takes the point of the arc, as seen from the centre of
# the ellipse, and turns it by 90 degrees, in place of differentiating by the angle: in a circle the tangent is at right angles to the radius, in
# an ellipse it is so only at the ends of the axes. For radii of 5 and 1 the direction is up to 67 degrees off. Besides, the angle grows with the
# parameter only where the sweep flag is 1: with 0, circles included, the tangent points backwards. Lines and Bezier curves give the derivative,
# in direction and sense, so that along one path the tangent jumps to the opposite and back, and an offset or an object that follows it changes
# sides. It does not show for circular arcs with sweep 1. A comment in the tests says of the figures asked for that they were not calculated.
# Nothing is said.
set -eu
svgpath=6.1-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-svg.path=$svgpath" 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > tangent.py <<'P'
import cmath
import math
import sys
from svg.path import parse_path

print("svg.path, Debian's", sys.argv[1])
as_described = True


def off(segment, t):
    """The angle from the difference of two neighbouring points to the tangent, in degrees."""
    h = 1e-6
    return math.degrees(cmath.phase(segment.tangent(t) / (segment.point(t + h) - segment.point(t - h))))


cases = (("line", "M 0,0 L 6,4", 0, 0), ("Bezier curve", "M 0,0 C 1,3 4,-2 5,1", 0, 0), ("circle, sweep 1", "M -5,0 A 5 5 0 0 1 5 0", 0, 0),
         ("circle, sweep 0", "M -5,0 A 5 5 0 0 0 5 0", 180, 180), ("ellipse, sweep 1", "M -5,0 A 5 1 0 0 1 5 0", 0, 67.4),
         ("ellipse, sweep 0", "M -5,0 A 5 1 0 0 0 5 0", 112.6, 180), ("turned, sweep 1", "M 0,0 A 5 3 30 1 1 6 4", 0, 28.1))
for name, path, least, most in cases:
    segment = parse_path(path)[1]
    angles = [abs(off(segment, k / 200)) for k in range(2, 199)]
    print(f"{name:18s} {path:26s} tangent {min(angles):5.1f} to {max(angles):5.1f} degrees off")
    as_described &= abs(min(angles) - least) < 0.5 and abs(max(angles) - most) < 0.5
    if "ellipse" in name or "circle" in name or "turned" in name:
        # the derivative by the angle, with the sign of the sweep
        worst = 0
        for k in range(2, 199):
            a, r = math.radians(segment.theta + segment.delta * k / 200), segment.radius * segment.radius_scale
            d = complex(-r.real * math.sin(a), r.imag * math.cos(a)) * cmath.rect(1, math.radians(segment.rotation)) * math.copysign(1, segment.delta)
            h = segment.point(k / 200 + 1e-6) - segment.point(k / 200 - 1e-6)
            worst = max(worst, abs(math.degrees(cmath.phase(d / h))))
        as_described &= worst < 0.01
# an S of two half circles, through which one goes straight: the tangent before and after the joint
path = parse_path("M 0,0 A 1 1 0 0 1 2 0 A 1 1 0 0 0 4 0")
before, after = path[1].tangent(1), path[2].tangent(0)
jump = abs(math.degrees(cmath.phase(after / before)))
print(f"S of two half circles: tangent at the joint {before:.1f} before, {after:.1f} after, a jump of {jump:.0f} degrees where there is none")
as_described &= abs(jump - 180) < 1e-6
sys.exit(0 if as_described else 1)
P
PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 tangent.py "$svgpath"
