#!/bin/sh
# @galacean/engine-math 1.6.13 (npm, the Galacean engine's mathematics): BoundingSphere.fromPoints() gives a radius that depends on where the points
# are. The corners of a cube of side 2 have a sphere of radius 1.732 about the origin, 13.86 about (1, 1, 1) and 123 about (10, 10, 10).
# The sphere may be too small as well: of the points (-1, 0, 0) twice and (4, 0, 0) once the last is left out by 0.33 (radius 3 for 3.33), and
# CollisionUtil then finds no contact with a box there, nor is the sphere seen in a view that looks at that point.
# Cause: the sum of the points is in a temporary vector, divided by their number into out.center only; the distances are then taken from that vector,
# the sum, in place of the centre. The declaration says that the sphere fully contains the points.
# It does not show when the points' mean is the origin, or for one point. fromBox() of the points' box is right. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @galacean/engine-math@1.6.13
cat > sphere.cjs <<'J'
const { readFileSync } = require('fs')
const { BoundingSphere, BoundingBox, BoundingFrustum, CollisionUtil, Matrix, Vector3 } = require('@galacean/engine-math')
console.log('@galacean/engine-math', JSON.parse(readFileSync('node_modules/@galacean/engine-math/package.json')).version)
const near = (a, b, by = 1e-6) => Math.abs(a - b) <= by * (1 + Math.abs(b))
const of = points => { const s = new BoundingSphere(); BoundingSphere.fromPoints(points.map(p => new Vector3(...p)), s); return s }
const mean = points => [0, 1, 2].map(k => points.reduce((s, p) => s + p[k], 0) / points.length), sum = points => [0, 1, 2].map(k => points.reduce((s, p) => s + p[k], 0))
const far = (points, c) => Math.max(...points.map(p => Math.hypot(...p.map((v, k) => v - c[k]))))
let seed = 1, good = true
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const cube = c => [-1, 1].flatMap(x => [-1, 1].flatMap(y => [-1, 1].map(z => [x + c[0], y + c[1], z + c[2]])))
function show(name, points, shows) {
  const s = of(points), centre = mean(points), right = far(points, centre), box = new BoundingBox(), round = new BoundingSphere()
  BoundingBox.fromPoints(points.map(p => new Vector3(...p)), box)
  BoundingSphere.fromBox(box, round)
  console.log(`${name}: radius ${s.radius.toFixed(3)}, right about that centre ${right.toFixed(3)}, from the box ${round.radius.toFixed(3)}`)
  good &&= [s.center.x, s.center.y, s.center.z].every((v, k) => near(v, centre[k])) && near(s.radius, far(points, sum(points))) && (near(s.radius, right) !== shows) &&
    points.every(p => Vector3.distance(round.center, new Vector3(...p)) <= round.radius + 1e-6)
  return s
}
show('cube about the origin', cube([0, 0, 0]), false)
show('cube about (1, 1, 1)', cube([1, 1, 1]), true)
show('cube about (10, 10, 10)', cube([10, 10, 10]), true)
show('cube about (-5, 0, 0)', cube([-5, 0, 0]), true)
show('one point', [[3, 1, 2]], false)
const points = [[-1, 0, 0], [-1, 0, 0], [4, 0, 0]], small = show('points (-1, 0, 0) twice and (4, 0, 0)', points, true)
good &&= near(small.radius, 3) && Vector3.distance(small.center, new Vector3(4, 0, 0)) > small.radius + 0.3
// what is made of it: a small box about the point left out, and a view from x = 10 that looks along -x and begins at x = 3.8
const box = new BoundingBox(new Vector3(3.9, -0.1, -0.1), new Vector3(4.1, 0.1, 0.1)), contact = CollisionUtil.intersectsSphereAndBox(small, box)
const view = new Matrix(), lens = new Matrix(), both = new Matrix()
Matrix.lookAt(new Vector3(10, 0, 0), new Vector3(0, 0, 0), new Vector3(0, 1, 0), view)
Matrix.ortho(-5, 5, -5, 5, 0.1, 6.2, lens)
Matrix.multiply(lens, view, both)
const frustum = new BoundingFrustum(both), whole = new BoundingSphere(small.center, far(points, mean(points)))
const seen = frustum.intersectsSphere(small), right = frustum.intersectsSphere(whole), inside = CollisionUtil.frustumContainsPoint(frustum, new Vector3(4, 0, 0))
console.log(`contact with a box about (4, 0, 0): ${contact}, with the right sphere ${CollisionUtil.intersectsSphereAndBox(whole, box)};`,
  `seen in a view of x from 3.8 to 9.9: ${seen}, with the right sphere ${right}; the point itself there: ${inside === 1}`)
good &&= !contact && CollisionUtil.intersectsSphereAndBox(whole, box) && !seen && right && inside === 1
// clouds of random points: how often, and by how much, the radius is off
for (const [n, spread, shift] of [[3, 1, 0], [4, 1, 0], [20, 1, 0], [20, 1, 3]]) {
  let lost = 0, most = 0
  for (let k = 0; k < 500; ++k) {
    const cloud = Array.from({ length: n }, () => [0, 1, 2].map(() => shift + spread * (2 * random() - 1))), s = of(cloud), r = far(cloud, mean(cloud))
    lost += s.radius < r - 1e-6
    most = Math.max(most, s.radius / r)
  }
  console.log(`500 clouds of ${n} points about (${shift}, ${shift}, ${shift}): some point left out in ${lost}, radius up to ${most.toFixed(1)} times the right one`)
  good &&= (n === 3 ? lost > 0 : true) && (shift ? most > 50 : most > 1.5)
}
process.exit(good ? 0 : 1)
J
node sphere.cjs
