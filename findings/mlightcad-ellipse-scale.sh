#!/bin/sh
# @mlightcad/geometry-engine 3.14.3 (npm): AcGeEllipseArc3d.transform() makes another ellipse when the scale differs along x and y, as in blocks of
# drawings that are inserted stretched. It takes the images of the two axes for the axes of the image. They are only conjugate half-diameters, at
# right angles for axes along x and y, or a scale alike in both, and skew else; the minor one is then put at right angles by force, with its
# length kept. An ellipse of 4 x 2 at 45 degrees, stretched threefold along x, should reach 4.74 to the right and 1.58 up and reaches 4.30 and
# 2.55; pi a b of its radii is 31.4 in place of 18.8. Besides, `area` of a full ellipse is 0 after any transformation, the identity too:
# `closed` is false for it (deltaAngle is 2 pi, not 0), so that it is taken for an arc and becomes one from 0 to 0. The comments of the source
# name no such limit, and nothing is said. AcGeEllipseArc2d has the same formula.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @mlightcad/geometry-engine@3.14.3 @mlightcad/common@1.14.3
cat > stretch.cjs <<'J'
const { AcGeEllipseArc3d, AcGeMatrix3d } = require('@mlightcad/geometry-engine')
console.log('@mlightcad/geometry-engine',
  JSON.parse(require('fs').readFileSync('node_modules/@mlightcad/geometry-engine/package.json')).version)
const near = (x, y, by) => Math.abs(x - y) <= by
const reach = points => ['x', 'y'].map(k => Math.max(...points.map(p => p[k])))
function stretch(degrees, sx, sy) {
  const r = degrees * Math.PI / 180, axis = { x: Math.cos(r), y: Math.sin(r), z: 0 }
  const ellipse = new AcGeEllipseArc3d({ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 1 }, axis, 2, 1)
  const area = ellipse.area, points = ellipse.getPoints(2000).map(p => ({ x: p.x * sx, y: p.y * sy }))
  ellipse.transform(new AcGeMatrix3d().makeScale(sx, sy, 1))
  const got = ellipse.getPoints(2000).map(p => ({ x: p.x, y: p.y }))
  const off = Math.max(...points.map(p => Math.min(...got.map(q => Math.hypot(p.x - q.x, p.y - q.y)))))
  const own = reach(points), its = reach(got), spanned = Math.PI * ellipse.majorAxisRadius * ellipse.minorAxisRadius
  const show = list => list.map(x => x.toFixed(3)).join(', ')
  console.log(`4 x 2 at ${degrees} degrees, scaled by ${sx}, ${sy}: reaches ${show(its)}, its points moved by hand ${show(own)}; up to ${off.toFixed(2)} off;`,
    `pi a b ${spanned.toFixed(2)} for ${(area * sx * sy).toFixed(2)}; area ${ellipse.area.toFixed(2)}, ${area.toFixed(2)} before`)
  return { own, its, off, spanned, right: area * sx * sy, area: ellipse.area }
}
const skew = stretch(45, 3, 1)
// by formula: the farthest point to the right of the image is 3 sqrt(4 cos^2 + sin^2), upwards sqrt(4 sin^2 + cos^2)
let good = near(skew.own[0], 3 * Math.sqrt(2.5), 1e-3) && near(skew.own[1], Math.sqrt(2.5), 1e-3) && near(skew.its[0], 4.301, 0.01) &&
  near(skew.its[1], 2.549, 0.01) && near(skew.off, 1.06, 0.02) && near(skew.spanned, 31.416, 0.01) && near(skew.right, 18.85, 0.01)
for (const r of [stretch(0, 3, 1), stretch(90, 3, 1), stretch(45, 3, 3), stretch(45, 1, 1)])
  good &&= r.off < 0.02 && near(r.spanned, r.right, 1e-6) && r.area === 0
process.exit(good ? 0 : 1)
J
node stretch.cjs
