#!/bin/sh
# @itwin/core-geometry 5.13.3 (npm): a mirrored transition spiral has a negative length. cloneTransformed() with a reflection gives the right points,
# but curveLength(), documented as the length, is -139.6 in place of 139.6, and an alignment of a straight of 100 and that spiral is -39.6 long.
# A distance along it runs backwards: 30 ahead of its start is 30 before it, and the alignment as a CurveChainWithDistanceIndex ends at -39.6.
# Written with IModelJson and read back, the length is positive but the curve sets out the opposite way, its end 279 from where it was.
# Cause: TransitionSpiral3d.applyRigidPartOfTransform() has factorRigidWithSignedScale() write the mirror as -1 times a rotation, and
# IntegratedSpiral3d.tryTransformInPlace() multiplies the arc length by that -1 as by a change of unit.
# All five integrated spirals do so, with any mirror, even in z, which leaves an xy curve where it is. Turns, real changes of unit, direct spirals,
# arcs and straights are right, and two mirrors make good. Nothing is said; the wire moments of the path, from its strokes, show the true length.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @itwin/core-geometry@5.13.3 @itwin/core-bentley@5.13.3
cat > spiral.cjs <<'J'
const { readFileSync } = require('fs')
const { Angle, AngleSweep, Arc3d, CurveChainWithDistanceIndex, DirectSpiral3d, IModelJson, IntegratedSpiral3d, LineSegment3d, Matrix3d, Path, Point3d,
  RegionOps, Segment1d, Transform } = require('@itwin/core-geometry')
console.log('@itwin/core-geometry', JSON.parse(readFileSync('node_modules/@itwin/core-geometry/package.json')).version)
const P = (x, y) => Point3d.create(x, y, 0), near = (a, b, by = 1e-6) => Math.abs(a - b) <= by
const scaled = (x, y, z) => Transform.createOriginAndMatrix(P(0, 0), Matrix3d.createScale(x, y, z))
const spiral = type => IntegratedSpiral3d.createRadiusRadiusBearingBearing(Segment1d.create(0, 500), AngleSweep.createStartEndDegrees(0, 8),
  Segment1d.create(0, 1), Transform.createOriginAndMatrix(P(100, 0), Matrix3d.createIdentity()), type)
function chords(curve, n = 2000) {
  let sum = 0
  for (let i = 0; i < n; ++i) sum += curve.fractionToPoint(i / n).distance(curve.fractionToPoint((i + 1) / n))
  return sum
}
const misplaced = (a, b, t) => Math.max(...[0, 0.3, 0.7, 1].map(f => t.multiplyPoint3d(a.fractionToPoint(f)).distance(b.fractionToPoint(f))))
let good = true
for (const type of ['clothoid', 'bloss', 'biquadratic', 'cosine', 'sine']) for (const signs of [[1, -1, 1], [-1, 1, 1], [1, 1, -1]]) {
  const mirror = scaled(...signs), before = spiral(type), after = before.cloneTransformed(mirror), twice = after.cloneTransformed(mirror)
  const json = IModelJson.Reader.parse(IModelJson.Writer.toIModelJson(after)), moved = json.fractionToPoint(1).distance(after.fractionToPoint(1))
  const first = before.moveSignedDistanceFromFraction(0, 30, true).fraction, then = after.moveSignedDistanceFromFraction(0, 30, true).fraction
  console.log(`${type} mirrored by ${signs}: points off by ${misplaced(before, after, mirror).toFixed(3)}, length ${after.curveLength().toFixed(3)}`,
    `(chords ${chords(after).toFixed(3)}), 30 ahead is at ${then.toFixed(3)} for ${first.toFixed(3)}, mirrored back ${twice.curveLength().toFixed(3)};`,
    `from JSON: length ${json.curveLength().toFixed(3)}, end off by ${moved.toFixed(1)}`)
  const length = before.curveLength()
  good &&= near(length, chords(before)) && misplaced(before, after, mirror) < 1e-9 && near(chords(after), length) && near(after.curveLength(), -length) &&
    near(after.curveLengthBetweenFractions(0, 0.5), -length / 2) && near(then, -first) && near(first, 30 / length) && near(twice.curveLength(), length) &&
    near(json.curveLength(), length) && near(moved, 278.7, 0.2)
}
const path = () => Path.create(LineSegment3d.create(P(0, 0), P(100, 0)), spiral('clothoid')), whole = path().sumLengths()
const mirrored = path().cloneTransformed(scaled(1, -1, 1)), chain = CurveChainWithDistanceIndex.createCapture(mirrored), end = chain.fractionToPoint(1)
const wire = RegionOps.computeXYZWireMomentSums(mirrored).quantitySum, trueEnd = mirrored.children[1].fractionToPoint(1)
console.log(`straight of 100 and clothoid: length ${whole.toFixed(3)}, mirrored ${mirrored.sumLengths().toFixed(3)} (wire moments ${wire.toFixed(3)});`,
  `its chain ends at (${end.x.toFixed(2)}, ${end.y.toFixed(2)}) for (${trueEnd.x.toFixed(2)}, ${trueEnd.y.toFixed(2)})`)
good &&= near(whole, 239.626, 1e-3) && near(mirrored.sumLengths(), 200 - whole) && near(wire, whole, 1e-2) && near(end.x, 200 - whole) && near(end.y, 0) &&
  near(trueEnd.x, 239.354, 1e-3) && near(trueEnd.y, -6.489, 1e-3)
// what is right: half a turn, another unit, and the other curves
const clothoid = spiral('clothoid'), length = clothoid.curveLength(), turned = clothoid.cloneTransformed(scaled(1, -1, -1)), feet = clothoid.cloneTransformed(scaled(2, 2, 2))
const direct = DirectSpiral3d.createJapaneseCubic(Transform.createIdentity(), 100, 400), arc = Arc3d.createXY(P(0, 0), 5, AngleSweep.createStartEnd(Angle.zero(), Angle.createDegrees(90)))
const [directMirrored, arcMirrored] = [direct, arc].map(c => c.cloneTransformed(scaled(1, -1, 1)).curveLength())
console.log(`half a turn about x: ${turned.curveLength().toFixed(3)}; twice the size: ${feet.curveLength().toFixed(3)}; mirrored Japanese cubic`,
  `${directMirrored.toFixed(3)} for ${direct.curveLength().toFixed(3)}; mirrored arc ${arcMirrored.toFixed(3)} for ${arc.curveLength().toFixed(3)}`)
good &&= near(turned.curveLength(), length) && near(feet.curveLength(), 2 * length) && near(directMirrored, direct.curveLength()) && near(arcMirrored, arc.curveLength())
process.exit(good ? 0 : 1)
J
node spiral.cjs
