#!/bin/sh
# maath 0.10.8 (npm, mathematics for three.js scenes): random.inSphere() does not fill a ball evenly: it crowds the points along the four diagonals.
# Toward a corner, such as (1,1,1), it has 2.72 times the density of an even ball, toward an axis 0.52 times: 5.2 to 1 (three times the root of three).
# Cause: the direction is that of a point drawn evenly from the cube -1 to 1, whose corners are farther out than its faces. An even direction would
# come from three normal deviates, or from the cube with the points outside the ball left out. The density in direction u is 1 / (24 max|u|^3) in place
# of 1 / (4 pi). The radius, a cube root, is right; so are, by symmetry, the centre and the spread along each axis.
# onSphere() of the same package is even. Nothing is said, and the ball is offered beside inCircle(), which is even too.
# The measures are the solid angle of a cone and the mean of x^4 over directions, 1/5; the seed is fixed.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts --legacy-peer-deps maath@0.10.8 three@0.170.0
cat > ball.mjs <<'J'
import { createRequire } from 'node:module'
import { readFileSync } from 'node:fs'
const random = createRequire(import.meta.url)('maath/random')
console.log('maath', JSON.parse(readFileSync('node_modules/maath/package.json')).version)
const n = 1000000
let good = true
// the share of directions within an angle of an axis given, for all of its signs; the solid angle of the cones over that of the sphere is right
function shares(points, angle) {
  let axes = 0, corners = 0, fourth = 0, second = 0, cubed = 0, mean = 0
  for (let i = 0; i < points.length; i += 3) {
    const p = [points[i], points[i + 1], points[i + 2]], r = Math.hypot(...p), u = p.map(x => Math.abs(x) / r), c = Math.cos(angle)
    if (Math.max(...u) > c) ++axes
    if ((u[0] + u[1] + u[2]) / Math.sqrt(3) > c) ++corners
    fourth += u[0] ** 4
    second += p[0] ** 2
    cubed += r ** 3
    mean += p[0]
  }
  const m = points.length / 3
  return { axes: axes / m, corners: corners / m, fourth: fourth / m, second: second / m, cubed: cubed / m, mean: mean / m }
}
const angle = 10 * Math.PI / 180, cone = (1 - Math.cos(angle)) / 2
const even = { axes: 6 * cone, corners: 8 * cone, fourth: 1 / 5, second: 1 / 5, cubed: 1 / 2, mean: 0 }
// by the density 1 / (24 max|u|^3), in steps over the cones
function cube() {
  const share = (pole, a, b) => {
    let sum = 0
    for (let i = 0; i < 300; ++i) for (let j = 0; j < 300; ++j) {
      const t = angle * (i + 0.5) / 300, f = 2 * Math.PI * (j + 0.5) / 300
      const u = pole.map((v, k) => v * Math.cos(t) + (a[k] * Math.cos(f) + b[k] * Math.sin(f)) * Math.sin(t))
      sum += Math.sin(t) / (24 * Math.max(...u.map(Math.abs)) ** 3)
    }
    return sum * angle * 2 * Math.PI / 90000
  }
  const s = Math.sqrt
  let fourth = 0
  for (let x = 0.005; x < 1; x += 0.01) for (let y = 0.005; y < 1; y += 0.01) for (let z = 0.005; z < 1; z += 0.01) fourth += (x * x / (x * x + y * y + z * z)) ** 2
  const corner = share([1, 1, 1].map(v => v / s(3)), [1, -1, 0].map(v => v / s(2)), [1, 1, -2].map(v => v / s(6)))
  return { axes: 6 * share([1, 0, 0], [0, 1, 0], [0, 0, 1]), corners: 8 * corner, fourth: fourth / 1e6 }
}
const show = o => Object.entries(o).map(([k, v]) => `${k} ${v.toFixed(4)}`).join(', ')
const crowded = cube()
console.log(`right: ${show(even)}`)
console.log(`by 1 / (24 max^3): ${show(crowded)}`)
for (const seed of [1, 2, 77]) {
  const got = shares(random.inSphere(new Float32Array(3 * n), { radius: 1, center: [0, 0, 0] }, new random.Generator(seed)), angle)
  const shell = shares(random.onSphere(new Float32Array(3 * n), { radius: 1, center: [0, 0, 0] }, new random.Generator(seed)), angle)
  console.log(`inSphere, seed ${seed}: ${show(got)}`)
  console.log(`onSphere, seed ${seed}: ${show(shell)}`)
  good &&= Math.abs(got.axes - crowded.axes) < 0.003 && Math.abs(got.corners - crowded.corners) < 0.003 && Math.abs(got.fourth - crowded.fourth) < 0.002
  good &&= Math.abs(got.axes - even.axes) > 0.015 && Math.abs(got.corners - even.corners) > 0.05 && Math.abs(got.fourth - even.fourth) > 0.01
  good &&= Math.abs(got.cubed - 0.5) < 0.002 && Math.abs(got.second - 0.2) < 0.002 && Math.abs(got.mean) < 0.003
  const disc = random.inCircle(new Float32Array(2 * n), { radius: 1, center: [0, 0] }, new random.Generator(seed))
  let flat = 0
  for (let i = 0; i < disc.length; i += 2) flat += (disc[i] ** 2 / (disc[i] ** 2 + disc[i + 1] ** 2)) ** 2 / n
  console.log(`inCircle, seed ${seed}: fourth ${flat.toFixed(4)}, right ${(3 / 8).toFixed(4)}`)
  good &&= Math.abs(flat - 3 / 8) < 0.002
  good &&= Math.abs(shell.axes - even.axes) < 0.002 && Math.abs(shell.corners - even.corners) < 0.002 && Math.abs(shell.fourth - 0.2) < 0.002
}
process.exit(good ? 0 : 1)
J
node ball.mjs
