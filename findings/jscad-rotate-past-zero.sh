#!/bin/sh
# @jscad/modeling 2.13.0 (npm, CAD by program): extrudeRotate() makes the wrong sector when startAngle + angle goes past a full turn: the rest of the
# turn, which was not asked for, is made, and what was asked for is left open. For startAngle 6 and angle 1 (radians) the solid spans 5.28 radians and has
# 5.28 times the volume; for three quarters of a turn and half a turn on, the volume is right but the half is the opposite one.
# Cause: the sum is reduced by a turn, which makes it less than the start; the two are then swapped, as for a negative angle, and the sector between
# them is swept from the lesser to the larger. With negative angles the same holds past minus a turn.
# Sectors that do not pass a full turn are right, so are full turns; extrudeHelical() of the same sector with a pitch of next to nothing is right, and so is
# the same sector made from zero and turned by startAngle. Nothing is said; both angles are documented as angles in radians, with no bound.
# The measure is Pappus' rule, volume = area * path of the centroid, and the centre of mass of a sector.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @jscad/modeling@2.13.0
cat > rotate.cjs <<'J'
const { readFileSync } = require('fs')
const { primitives, extrusions, measurements, transforms } = require('@jscad/modeling')
console.log('@jscad/modeling', JSON.parse(readFileSync('node_modules/@jscad/modeling/package.json')).version)
// a unit square 2 away from the axis
const square = () => primitives.rectangle({ size: [1, 1], center: [2, 0] }), turn = 2 * Math.PI, segments = 720
const of = solid => ({ volume: measurements.measureVolume(solid), center: measurements.measureCenterOfMass(solid) })
// volume by Pappus; centre of mass: at the middle of the sector, (R^3 - r^3) / (R^2 - r^2) * 2/3 * sin(half) / half from the axis
function sector(start, angle) {
  const far = 2 / 3 * (2.5 ** 3 - 1.5 ** 3) / (2.5 ** 2 - 1.5 ** 2) * Math.sin(angle / 2) / (angle / 2), middle = start + angle / 2
  return { volume: 2 * Math.abs(angle), center: [far * Math.cos(middle), far * Math.sin(middle), 0] }
}
const near = (a, b) => Math.abs(a.volume - b.volume) < 1e-3 * b.volume && Math.hypot(...a.center.map((c, i) => c - b.center[i])) < 0.02
const show = o => `volume ${o.volume.toFixed(3)} about (${o.center.slice(0, 2).map(c => (Math.abs(c) < 5e-4 ? 0 : c).toFixed(3)).join(', ')})`
// with the angles as the source reads them
function asRead(start, angle) {
  let end = start + angle
  if (Math.abs(end) > turn) end %= turn
  const [low, high] = [Math.min(start, end), Math.max(start, end)]
  return sector(low, high - low)
}
let good = true
const quarter = Math.PI / 2
for (const [start, angle, past] of [[0, 1], [3, 3], [3 * quarter, 1], [4, -3], [-1, 2], [0, 5], [6, 1, true], [3 * quarter, 2 * quarter, true], [2, 5, true],
  [3, 4, true], [5, 2, true], [-1, -6, true], [-5, -2, true]]) {
  const got = of(extrusions.extrudeRotate({ startAngle: start, angle, segments }, square())), right = sector(start, angle), read = asRead(start, angle)
  console.log(`startAngle ${start.toFixed(3)}, angle ${angle.toFixed(3)}: ${show(got)}, right: ${show(right)}`)
  good &&= near(got, read) && near(got, right) === !past
}
// a full turn from wherever
for (const start of [0, 1, Math.PI]) {
  const full = of(extrusions.extrudeRotate({ startAngle: start, angle: turn, segments }, square()))
  good &&= Math.abs(full.volume - 2 * turn) < 0.01
}
// the library's other ways to the same sector
const start = 6, angle = 1, right = sector(start, angle)
const helical = of(extrusions.extrudeHelical({ startAngle: start, angle, pitch: 1e-6, segmentsPerRotation: segments }, square()))
const turned = of(transforms.rotateZ(start, extrusions.extrudeRotate({ angle, segments }, square())))
const less = of(extrusions.extrudeRotate({ startAngle: start - turn, angle, segments }, square()))
const ring = r => of(primitives.cylinderElliptic({ height: 1, startRadius: [r, r], endRadius: [r, r], startAngle: start, endAngle: (start + angle) % turn, segments }))
const wedge = ring(2.5).volume - ring(1.5).volume
console.log(`startAngle 6, angle 1 by extrudeHelical: ${show(helical)}; made from zero and turned by 6: ${show(turned)}; by startAngle 6 - 2 pi: ${show(less)};`,
  `by cylinders: volume ${wedge.toFixed(3)}; right: ${show(right)}`)
good &&= near(helical, right) && near(turned, right) && near(less, right) && Math.abs(wedge - right.volume) < 1e-2
process.exit(good ? 0 : 1)
J
node rotate.cjs
