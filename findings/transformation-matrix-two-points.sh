#!/bin/sh
# transformation-matrix 3.1.0 (npm): fromTwoMovingPoints(A, B, A', B'), for the gesture of two fingers, is the wrong transformation as soon as
# the fingers move and spread or turn at once. Its scale and rotation are about A', where A is after the translation, but compose() is given
# the translation first, which means last to act: A goes to A' + s R (A - A') + (A' - A), as far off as it moved, turned and scaled. A gesture that
# only moves, and one about a resting A, are right, and so are its scale and its angle in every case: only where the picture lies is wrong.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save transformation-matrix@3.1.0
cat > gesture.mjs <<'J'
import { readFileSync } from 'node:fs'
import { applyToPoints, compose, fromTwoMovingPoints, rotate, scale, translate } from 'transformation-matrix'
console.log('transformation-matrix', JSON.parse(readFileSync('node_modules/transformation-matrix/package.json')).version)
const gestures = {
  moves: [[10, 20], [20, 20], [40, 60], [50, 60]],
  'spreads about A': [[10, 20], [20, 20], [10, 20], [30, 20]],
  'moves and spreads': [[10, 20], [20, 20], [40, 60], [60, 60]],
  'moves and turns': [[10, 20], [20, 20], [40, 60], [40, 70]]
}
let wrong = 0
for (const [name, points] of Object.entries(gestures)) {
  const [a, b, c, d] = points.map(([x, y]) => ({ x, y }))
  const got = applyToPoints(fromTwoMovingPoints(a, b, c, d), [a, b])
  const off = Math.max(Math.hypot(got[0].x - c.x, got[0].y - c.y), Math.hypot(got[1].x - d.x, got[1].y - d.y))
  // the same by hand: scale and turn about A, then move A to A'
  const s = Math.hypot(d.x - c.x, d.y - c.y) / Math.hypot(b.x - a.x, b.y - a.y)
  const angle = Math.atan2(d.y - c.y, d.x - c.x) - Math.atan2(b.y - a.y, b.x - a.x)
  const own = applyToPoints(compose(translate(c.x - a.x, c.y - a.y), scale(s, s, a.x, a.y), rotate(angle, a.x, a.y)), [a, b])
  const own_off = Math.hypot(own[0].x - c.x, own[0].y - c.y) + Math.hypot(own[1].x - d.x, own[1].y - d.y)
  console.log(`${name}: A should be at (${c.x}, ${c.y}), is at (${got[0].x.toFixed(1)}, ${got[0].y.toFixed(1)});`,
    `off by ${off.toFixed(1)}, by hand ${own_off.toFixed(1)}`)
  if (own_off > 1e-9) process.exit(2)
  wrong += off > 1
}
process.exit(wrong === 2 ? 0 : 1)
J
node gesture.mjs
