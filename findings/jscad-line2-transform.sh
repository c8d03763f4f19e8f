#!/bin/sh
# @jscad/modeling 2.13.0 (npm, CAD by program): maths.line2.transform() moves a line even by the identity, unless the line passes through zero.
# The line y = 4 becomes the line through (0,4) and (1,0); moved by (0,10) it should be y = 14 and is the line through (0,14) and (1,10).
# The line through (0,2) and (4,5) turned a quarter about zero misses the two turned points, by 1.02 and by 5.26.
# Cause: line2/transform.js takes the line's point nearest to zero and its direction, transforms both as points, so that a translation is added to
# the direction too, and hands both to fromPoints(), which wants two points of the line: the direction is taken for a second point.
# Where the line passes through zero, the nearest point is zero and the direction lies on the line, and all is right. The library's tests have such
# lines only. line3.transform() is right: it adds the point to the direction first. Nothing is said; the documentation says 'Transforms the given line'.
# Right is the line through two transformed points, which is what fromPoints() and vec2.transform() give here.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @jscad/modeling@2.13.0
cat > line.cjs <<'J'
const { readFileSync } = require('fs')
const { line2, line3, mat4, vec2, vec3 } = require('@jscad/modeling').maths
console.log('@jscad/modeling', JSON.parse(readFileSync('node_modules/@jscad/modeling/package.json')).version)
const shift = (x, y) => mat4.fromTranslation(mat4.create(), [x, y, 0]), turn = a => mat4.fromZRotation(mat4.create(), a)
const maps = [
  ['identity', mat4.create()],
  ['moved by (0,10)', shift(0, 10)],
  ['moved by (3,-2)', shift(3, -2)],
  ['turned by a quarter', turn(Math.PI / 2)],
  ['twice the size', mat4.fromScaling(mat4.create(), [2, 2, 2])],
  ['turned by 0.7 and moved by (5,1)', mat4.multiply(mat4.create(), shift(5, 1), turn(0.7))]]
const lines = [['y = 4', [[0, 4], [1, 4]]], ['through (0,2) and (4,5)', [[0, 2], [4, 5]]], ['x = -3', [[-3, 0], [-3, 1]]],
  ['y = x, through zero', [[0, 0], [1, 1]]], ['the x axis', [[-2, 0], [5, 0]]]]
// how far a point is from the line a x + b y = c
const off = ([a, b, c], [x, y]) => Math.abs(a * x + b * y - c)
const show = l => Array.from(l, v => (Math.abs(v) < 5e-5 ? 0 : v).toFixed(4)).join(', ')
let good = true, largest = 0
for (const [name, points] of lines) {
  const line = line2.fromPoints(line2.create(), ...points), zero = name.includes('zero') || name.includes('axis')
  console.log(`line ${name}: ${show(line)}`)
  good &&= points.every(p => off(line, p) < 1e-12 && Math.abs(line2.distanceToPoint(line, p)) < 1e-12)
  for (const [what, matrix] of maps) {
    const moved = points.map(p => vec2.transform(vec2.create(), p, matrix))
    const got = line2.transform(line2.create(), line, matrix), right = line2.fromPoints(line2.create(), ...moved)
    const away = moved.map(p => off(got, p))
    console.log(`  ${what}: ${show(got)}, right ${show(right)}; the two points, moved too, are ${away.map(d => d.toFixed(3)).join(' and ')} away`)
    // the same in space, by the library
    const space = line3.transform(line3.create(), line3.fromPoints(line3.create(), ...points.map(p => [...p, 0])), matrix)
    good &&= moved.every(p => off(right, p) < 1e-9 && line3.distanceToPoint(space, [...p, 0]) < 1e-9)
    // what the source does: the line through the image of the nearest point and the image of the direction
    const [a, b, c] = line, asRead = line2.fromPoints(line2.create(), ...[[a * c, b * c], [b, -a]].map(p => vec2.transform(vec2.create(), p, matrix)))
    good &&= asRead.every((v, i) => Math.abs(v - got[i]) < 1e-9)
    good &&= zero ? away.every(d => d < 1e-9) : away.some(d => d > 0.3)
    largest = Math.max(largest, ...away)
  }
}
// the identity, time and again, on y = 4
let line = line2.fromPoints(line2.create(), [0, 4], [1, 4])
const heights = [line2.distanceToPoint(line, [0, 0])]
for (let i = 0; i < 4; ++i) {
  line = line2.transform(line2.create(), line, mat4.create())
  heights.push(line2.distanceToPoint(line, [0, 0]))
}
console.log(`distance from zero of y = 4 under the identity, again and again: ${heights.map(d => d.toFixed(4)).join(', ')}; largest miss above ${largest.toFixed(3)}`)
good &&= heights[0] === 4 && heights.slice(1).every(d => d < 1)
process.exit(good ? 0 : 1)
J
node line.cjs
