#!/bin/sh
# @cesium/engine 26.3.0 (npm): HermiteSpline.createNaturalCubic() and createClampedCubic() are right only if the times are 1 apart. generateNatural()
# and generateClamped() solve for tangents per segment, as if each took the time 1, and never see `times`; evaluate() takes tangents per unit of
# time and multiplies them by the segment's length, since 2022, when it was made fit for glTF. So each tangent is too long by that length: a
# point that moves evenly along a line, with a point each 60 seconds, runs 5.5 segments ahead and as far back within each, and with times 0.1 apart
# it all but halts at every point. The curve, 'in the class C2' by the documentation, bends with a jump at every point, with the times 1.5 apart of
# the documentation's own example too. It does pass through its points and in the middle of a segment of an even motion is right; with
# times 0, 1, 2, 3 all is right, and so is createC1() with the right tangents. Nothing is said. With unequal times there is no factor that mends it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @cesium/engine@26.3.0
cat > spline.mjs <<'J'
import { readFileSync } from 'node:fs'
import HermiteSpline from '@cesium/engine/Source/Core/HermiteSpline.js'
import Cartesian3 from '@cesium/engine/Source/Core/Cartesian3.js'
console.log('@cesium/engine', JSON.parse(readFileSync('node_modules/@cesium/engine/package.json')).version)
const near = (x, y, by = 1e-6) => Math.abs(x - y) <= by
const C = (x, y = 0, z = 0) => new Cartesian3(x, y, z)
let good = true

// the tangents of the natural cubic spline through points at times, one coordinate: Gauss-Seidel on the usual equations
function natural(times, values) {
  const n = times.length - 1, h = i => times[i + 1] - times[i], slope = i => (values[i + 1] - values[i]) / h(i), m = times.map(() => 0)
  for (let turn = 0; turn < 500; ++turn) {
    m[0] = (3 * slope(0) - m[1]) / 2
    for (let i = 1; i < n; ++i) m[i] = (3 * (slope(i - 1) * h(i) + slope(i) * h(i - 1)) - h(i) * m[i - 1] - h(i - 1) * m[i + 1]) / (2 * (h(i - 1) + h(i)))
    m[n] = (3 * slope(n - 1) - m[n - 1]) / 2
  }
  return m
}
const own = (times, points) => {
  const [x, y, z] = ['x', 'y', 'z'].map(k => natural(times, points.map(p => p[k])))
  return HermiteSpline.createC1({ times, points, tangents: times.map((_, i) => C(x[i], y[i], z[i])) })
}

// 1. an even motion along a line: point i at time i h is at x = i
for (const [h, ahead] of [[1, 0], [1.5, 0.046875], [60, 5.53125], [0.1, -0.084375]]) {
  const times = [0, 1, 2, 3, 4].map(i => i * h), points = times.map((_, i) => C(i))
  const spline = HermiteSpline.createNaturalCubic({ times, points }), mine = own(times, points)
  const at = (s, i) => s.evaluate(i * h).x
  console.log(`times ${h} apart: at 1, 1.25, 1.5 and 1.75 of the way the point is at`,
    [1, 1.25, 1.5, 1.75].map(i => at(spline, i).toFixed(3)).join(', '), '| createC1 with own tangents:', [1, 1.25, 1.5, 1.75].map(i => at(mine, i).toFixed(3)).join(', '))
  good &&= near(at(spline, 1), 1) && near(at(spline, 1.5), 1.5) && near(at(spline, 1.25) - 1.25, ahead) && near(at(spline, 1.75) - 1.75, -ahead)
  for (const i of [1, 1.25, 1.5, 1.75]) good &&= near(at(mine, i), i)
}
// 2. unequal times: x = t at 0, 1, 3, 4
{
  const times = [0, 1, 3, 4], points = times.map(t => C(t)), spline = HermiteSpline.createNaturalCubic({ times, points })
  console.log('x = t at 0, 1, 3, 4: x at 0.5 and 1.5 is', spline.evaluate(0.5).x.toFixed(4), spline.evaluate(1.5).x.toFixed(4),
    '| own', own(times, points).evaluate(0.5).x.toFixed(4), own(times, points).evaluate(1.5).x.toFixed(4))
  good &&= near(spline.evaluate(0.5).x, 0.375) && near(own(times, points).evaluate(0.5).x, 0.5) && near(own(times, points).evaluate(1.5).x, 1.5)
}
// 3. clamped: t^3 with its own derivatives at the ends is t^3
for (const [h, seen] of [[1, 3.375], [2, 9], [0.5, null]]) {
  const times = [0, 1, 2, 3].map(i => i * h), cube = t => C(t, t * t, t ** 3)
  const spline = HermiteSpline.createClampedCubic({ times, points: times.map(cube), firstTangent: C(1, 0, 0), lastTangent: C(1, 6 * h, 27 * h * h) })
  const t = 1.5 * h, p = spline.evaluate(t)
  console.log(`clamped, (t, t^2, t^3) with times ${h} apart, t = ${t}: ${[p.x, p.y, p.z].map(v => v.toFixed(4)).join(', ')} for`,
    [t, t * t, t ** 3].map(v => v.toFixed(4)).join(', '))
  if (seen !== null) good &&= near(p.z, seen)
  good &&= near(p.z, t ** 3) === (h === 1)
}
// 4. the documentation's points: the jump of the second derivative at the inner points, over its largest value
const city = [[1235398, -4810983, 4146266], [1372574, -5345182, 4606657], [-757983, -5542796, 4514323], [-2821260, -5248423, 4021290],
  [-2539788, -4724797, 3620093]].map(p => C(...p))
for (const h of [1, 1.5]) {
  const times = [0, 1, 2, 3, 4].map(i => i * h)
  const jump = spline => {
    let most = 0, size = 0
    const e = 0.01 * h, second = (t, side) => { // of a cubic, from four points on one side
      const [a, b, c, d] = [0, 1, 2, 3].map(k => spline.evaluate(t + side * (k * e + 1e-9)).x)
      return (2 * a - 5 * b + 4 * c - d) / (e * e)
    }
    for (const i of [1, 2, 3]) {
      most = Math.max(most, Math.abs(second(i * h, 1) - second(i * h, -1)))
      size = Math.max(size, Math.abs(second(i * h, 1)), Math.abs(second(i * h, -1)))
    }
    return most / size
  }
  const theirs = jump(HermiteSpline.createNaturalCubic({ times, points: city })), mine = jump(own(times, city))
  console.log(`Philadelphia to Los Angeles, times ${h} apart: jump of the second derivative ${theirs.toFixed(3)} of its size | own ${mine.toFixed(3)}`)
  good &&= mine < 0.01 && (h === 1 ? theirs < 0.01 : theirs > 0.3)
}
process.exit(good ? 0 : 1)
J
node spline.mjs
