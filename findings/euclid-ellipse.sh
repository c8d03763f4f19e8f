#!/bin/sh
# @mathigon/euclid 1.2.4 (npm, plane geometry): the extremes of a turned Ellipse do not lie on it. Half axes 5 and 3 turned by 30 degrees: its highest
# point is given as (4.083, 3.606), an eighth outside the ellipse; it is (1.922, 3.606). All four points are off alike.
# Cause: the getter extremes takes (a^2 + b^2) sin cos / yMax for the abscissa of the top, and likewise for the others; right is the
# difference of the squares, a^2 - b^2. A circle, turned by 45 degrees, has its top and its right in one point outside.
# Besides, contains() evaluates the equation at p, not at p - c: an ellipse not about the origin does not contain its own centre, and contains the
# origin; and project() takes the polar angle of p for the parameter: its point is neither the nearest nor the one in that direction.
# The heights themselves are right, so are ellipses with level axes (extremes), about the origin (contains), points on the axes (project), at() and
# intersect(). Nothing is said. The measure is a dense row of points by at().
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @mathigon/euclid@1.2.4 @mathigon/fermat@1.1.24 @mathigon/core@1.1.23
cat > ellipse.cjs <<'J'
const { readFileSync } = require('fs')
const { Ellipse, Point, Line } = require('@mathigon/euclid')
console.log('@mathigon/euclid', JSON.parse(readFileSync('node_modules/@mathigon/euclid/package.json')).version)
const near = (a, b, by = 1e-6) => Math.abs(a - b) <= by, show = p => `(${p.x.toFixed(3)}, ${p.y.toFixed(3)})`, degrees = Math.PI / 180
// how far out a point lies, in half axes: 1 on the ellipse
function out({ c, a, b, angle }, p) {
  const x = p.x - c.x, y = p.y - c.y, u = x * Math.cos(angle) + y * Math.sin(angle), v = y * Math.cos(angle) - x * Math.sin(angle)
  return Math.hypot(u / a, v / b)
}
const row = Array.from({ length: 200000 }, (_, i) => i / 200000)
const most = (ellipse, f) => row.map(t => ellipse.at(t)).reduce((best, p) => f(p) > f(best) ? p : best)
let good = true
for (const [a, b, turn, cx, cy] of [[5, 3, 30, 0, 0], [5, 3, 30, 10, 4], [5, 3, 75, 0, 0], [5, 3, -20, 0, 0], [10, 1, 45, 0, 0], [3, 3, 45, 0, 0], [5, 3, 0, 0, 0], [5, 3, 90, 2, 1]]) {
  const ellipse = new Ellipse(new Point(cx, cy), a, b, turn * degrees), [top, bottom, right, left] = ellipse.extremes
  const highest = most(ellipse, p => p.y), rightmost = most(ellipse, p => p.x), turned = turn % 90 !== 0
  console.log(`half axes ${a} and ${b}, turned by ${turn}, about (${cx}, ${cy}): top ${show(top)}, measured ${a === b ? `(${cx}.000, ${(cy + a).toFixed(3)})` : show(highest)};`,
    `right ${show(right)}, measured ${show(rightmost)}; half axes out: ${[top, bottom, right, left].map(p => out(ellipse, p).toFixed(3)).join(' ')}`)
  good &&= near(top.y, highest.y) && near(right.x, rightmost.x) && near(out(ellipse, highest), 1)
  // with the difference of the squares, from the library's own points
  const ratio = (a * a - b * b) / (a * a + b * b), mended = [cx + (top.x - cx) * ratio, cy + (right.y - cy) * ratio]
  good &&= near(out(ellipse, new Point(mended[0], top.y)), 1) && near(out(ellipse, new Point(right.x, mended[1])), 1)
  if (a !== b) good &&= near(mended[0], highest.x, 1e-3) && near(mended[1], rightmost.y, 1e-3)
  good &&= [top, bottom, right, left].every(p => turned ? out(ellipse, p) > 1.004 : near(out(ellipse, p), 1))
}
// contains
for (const [cx, cy] of [[0, 0], [2, 1], [10, 4]]) {
  const ellipse = new Ellipse(new Point(cx, cy), 5, 3, 30 * degrees)
  let wrong = 0
  for (let i = 0; i < 40; ++i) for (let j = 0; j < 40; ++j) {
    const p = new Point(cx - 6.03 + 0.3 * i, cy - 6.03 + 0.3 * j)
    wrong += ellipse.contains(p) !== (out(ellipse, p) <= 1)
  }
  console.log(`about (${cx}, ${cy}): contains its centre ${ellipse.contains(ellipse.c)}, contains the origin ${ellipse.contains(new Point(0, 0))}; of 1600 points ${wrong} wrong`)
  good &&= cx === 0 ? wrong === 0 : wrong > 100 && ellipse.contains(new Point(0, 0))
  if (cx === 10) good &&= !ellipse.contains(ellipse.c) && out(ellipse, new Point(0, 0)) > 1
  const cut = ellipse.intersect(new Line(new Point(cx - 1, cy + 0.5), new Point(cx + 2, cy + 1)))
  good &&= cut.length === 2 && cut.every(p => near(out(ellipse, p), 1))
}
// project
const flat = new Ellipse(new Point(0, 0), 5, 1), p = new Point(3, 0.3), got = flat.project(p)
const nearest = most(flat, q => -Point.distance(q, p)), towards = 1 / out(flat, p)
console.log(`half axes 5 and 1: (3, 0.3) is projected to ${show(got)}, ${Point.distance(got, p).toFixed(3)} away; the nearest point is ${show(nearest)}, ${Point.distance(nearest, p).toFixed(3)} away;`,
  `in the direction from the centre (${(3 * towards).toFixed(3)}, ${(0.3 * towards).toFixed(3)})`)
good &&= near(out(flat, got), 1) && near(got.x, 5 * Math.cos(Math.atan2(0.3, 3))) && Point.distance(got, p) > Point.distance(nearest, p) + 1 && !near(got.x / got.y, 10, 1)
process.exit(good ? 0 : 1)
J
node ellipse.cjs
