#!/bin/sh
# @itwin/core-geometry 5.13.3 (npm): areas of regions leave out their Bezier edges. RegionOps.computeXYArea() of a disc of four rational Beziers is 0,
# and a square with that disc as its hole has the area of the full square; centroidAreaNormal() of the disc answers with the world's zero.
# Of a loop with other edges too, these alone count, each as a triangle from zero, so that the figure changes with the place of the loop, even its
# sign: -18.1 comes out as 0, and as 15 ten units to the right. The same curve as a B-spline gives -18.1 everywhere.
# Cause: RegionMomentsXY strokes B-splines and spirals but has no handler for Bezier curves, and the one that it inherits from NullGeometryHandler
# does nothing: no error, as if the loop had a gap there. constructAllXYRegionLoops() finds no region in such a loop.
# Length, point in region, facets (whose area comes out right) and swept solids all know the Bezier. The documentation promises
# the signed area of any loop, and BezierCurve3d is one of the curve primitives that it lists.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @itwin/core-geometry@5.13.3 @itwin/core-bentley@5.13.3
cat > region.cjs <<'J'
const { readFileSync } = require('fs')
const { BezierCurve3d, BezierCurve3dH, BSplineCurve3d, LineString3d, Loop, ParityRegion, Point3d, Point4d, PolyfaceBuilder, PolyfaceQuery,
  RegionOps, Transform } = require('@itwin/core-geometry')
console.log('@itwin/core-geometry', JSON.parse(readFileSync('node_modules/@itwin/core-geometry/package.json')).version)
const P = (x, y) => Point3d.create(x, y, 0), near = (a, b, by = 1e-9) => Math.abs(a - b) <= by
const corners = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]]
const disc = (cx, cy, r) => Loop.create(...[0, 2, 4, 6].map(i => BezierCurve3dH.create([0, 1, 2].map(k => {
  const w = k === 1 ? Math.SQRT1_2 : 1, [x, y] = corners[i + k]
  return Point4d.create((cx + r * x) * w, (cy + r * y) * w, 0, w)
}))))
// by hand: trapezoids under chords
function byHand(loop) {
  let area = 0
  for (const curve of loop.children) for (let i = 0, n = 20000; i < n; ++i) {
    const a = curve.fractionToPoint(i / n), b = curve.fractionToPoint((i + 1) / n)
    area += (a.x * b.y - a.y * b.x) / 2
  }
  return area
}
function facets(region) {
  const builder = PolyfaceBuilder.create()
  builder.addGeometryQuery(region)
  return PolyfaceQuery.sumFacetAreas(builder.claimPolyface())
}
const circle = disc(5, 3, 2), area = 4 * Math.PI
const centre = RegionOps.centroidAreaNormal(circle)
const inside = [[5, 3], [6.9, 3], [6.9, 4.9]].map(p => RegionOps.testPointInOnOutRegionXY(circle, ...p))
console.log(`disc of radius 2 about (5, 3): area ${RegionOps.computeXYArea(circle)} for ${area.toFixed(3)} (by hand ${byHand(circle).toFixed(3)}, of its facets`,
  `${facets(circle).toFixed(3)}), length ${circle.sumLengths().toFixed(3)}, centroid (${centre?.origin.x}, ${centre?.origin.y}); points in, in, out: ${inside}`)
let good = RegionOps.computeXYArea(circle) === 0 && near(byHand(circle), area, 1e-5) && near(facets(circle), area, 0.5) &&
  near(circle.sumLengths(), area, 1e-6) && centre.origin.x === 0 && centre.origin.y === 0 && inside.join() === '1,1,-1'
const square = Loop.create(LineString3d.create([P(0, 0), P(10, 0), P(10, 10), P(0, 10), P(0, 0)])), hole = ParityRegion.create(square, disc(5, 3, 2))
console.log(`square of 10 with that disc as hole: area ${RegionOps.computeXYArea(hole).toFixed(3)} for ${(100 - area).toFixed(3)}, of its facets ${facets(hole).toFixed(3)}`)
good &&= near(RegionOps.computeXYArea(hole), 100) && near(facets(hole), 100 - area, 0.5)
const poles = [P(0, 3), P(1, 6), P(5, 6), P(4, 0)]
const bezier = Loop.create(LineString3d.create([P(4, 0), P(0, 0), P(0, 3)]), BezierCurve3d.create(poles))
const spline = Loop.create(LineString3d.create([P(4, 0), P(0, 0), P(0, 3)]), BSplineCurve3d.create(poles, [0, 0, 0, 1, 1, 1], 4))
const regions = loop => RegionOps.constructAllXYRegionLoops([loop]).reduce((n, l) => n + l.positiveAreaLoops.length, 0)
console.log(`straight edges and one curve: area ${RegionOps.computeXYArea(bezier)} with a Bezier, ${RegionOps.computeXYArea(spline).toFixed(3)} with the same curve as`,
  `a B-spline, by hand ${byHand(bezier).toFixed(3)} and ${byHand(spline).toFixed(3)}; regions found: ${regions(bezier)} and ${regions(spline)}`)
good &&= RegionOps.computeXYArea(bezier) === 0 && near(byHand(bezier), byHand(spline), 1e-6) && near(RegionOps.computeXYArea(spline), byHand(spline), 0.1) &&
  near(facets(bezier), Math.abs(byHand(bezier)), 0.5) && regions(bezier) === 0 && regions(spline) === 1
const move = Transform.createTranslationXYZ(10, 0, 0), moved = bezier.cloneTransformed(move)
console.log(`moved by 10: ${RegionOps.computeXYArea(moved).toFixed(3)} with the Bezier, ${RegionOps.computeXYArea(spline.cloneTransformed(move)).toFixed(3)} with the B-spline`)
good &&= near(RegionOps.computeXYArea(moved), 15) && near(RegionOps.computeXYArea(spline.cloneTransformed(move)), RegionOps.computeXYArea(spline))
process.exit(good ? 0 : 1)
J
node region.cjs
