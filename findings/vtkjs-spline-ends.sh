#!/bin/sh
# @kitware/vtk.js 37.4.3 (npm): the ends of open splines (vtkSpline3D and its two kinds, as of the spline widget) are wrong in three ways.
# By default the slope at an end is to be that from the end to the second point after it (a comment in Spline1D's constants): (y2 - y0) / (x2 - x0).
# It is y2 - y0, without the division, twice too long with the default intervals of 1, and 20 times with intervals of 10. An even motion along a line
# is not even, and a quarter of a circle by five points is 7 and 65 times farther off in its first and last piece than between; in another
# unit of the parameter the cardinal spline is another curve. Second, vtkCardinalSpline1D divides the first right-hand side by the last row's diagonal
# (work[0] /= coefficients[4 * N + 1]), so that if the two ends have different conditions the left one is not met: slope 3 is asked for, 1.5 is got.
# Third, vtkKochanekSpline1D takes leftValue at the right end. Closed splines are right, and cardinal ones with given slopes, or given second
# derivatives, at both ends, which reproduce a parabola. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --no-save --ignore-scripts @kitware/vtk.js@37.4.3
cat > ends.mjs <<'C'
import { readFileSync } from 'node:fs'
import Cardinal from '@kitware/vtk.js/Common/DataModel/CardinalSpline1D.js'
import Kochanek from '@kitware/vtk.js/Common/DataModel/KochanekSpline1D.js'
import Spline3D from '@kitware/vtk.js/Common/DataModel/Spline3D.js'
import { BoundaryCondition } from '@kitware/vtk.js/Common/DataModel/Spline1D/Constants.js'
console.log('@kitware/vtk.js', JSON.parse(readFileSync('node_modules/@kitware/vtk.js/package.json')).version)
const near = (a, b, by) => Math.abs(a - b) <= by
const five = [0, 1, 2, 3, 4], circle = five.map(i => [100 * Math.cos(i * Math.PI / 8), 100 * Math.sin(i * Math.PI / 8), 0])
let good = true
function open(kind, h) {
  const spline = points => { const s = Spline3D.newInstance({ kind, intervals: five.map(i => i * h) }); s.computeCoefficients(points); return s }
  const line = spline(five.map(i => [i, 0, 0])), arc = spline(circle), small = h / 1000
  const slope = h * (line.getPoint(0, small)[0] - line.getPoint(0, 0)[0]) / small
  const off = [0, 1, 2, 3].map(k => Math.max(...Array.from({ length: 101 }, (_, i) => Math.abs(Math.hypot(...arc.getPoint(k, i * h / 100)) - 100))))
  console.log(`${kind}, intervals of ${h}: even steps along a line, first step ${slope.toFixed(2)} times too fast at its start, at`,
    `${line.getPoint(0, h / 2)[0].toFixed(3)} when half over; quarter circle of 100: off by ${off.map(v => v.toFixed(2)).join(', ')}`)
  return { slope, half: line.getPoint(0, h / 2)[0], off }
}
const cardinal = open('CARDINAL_SPLINE', 1), ten = open('CARDINAL_SPLINE', 10), divided = open('CARDINAL_SPLINE', 0.5), kochanek = open('KOCHANEK_SPLINE', 1)
good &&= near(cardinal.slope, 2, 0.01) && near(ten.slope, 20, 0.1) && near(divided.slope, 1, 0.01) && near(kochanek.slope, 2, 0.01)
good &&= near(divided.half, 0.5, 1e-4) && near(cardinal.half, 0.661, 0.002) && near(kochanek.half, 0.625, 0.002)
good &&= near(cardinal.off[0], 4.05, 0.05) && near(cardinal.off[1], 0.56, 0.02) && near(ten.off[0], 38.2, 0.3) && near(divided.off[0], 2.56, 0.05) &&
  near(kochanek.off[0], 3.62, 0.05) && near(kochanek.off[1], 0.055, 0.002)
// y = x^2 + 3 x has slopes 3 and 11 at its ends and the second derivative 2: any two of these give it back
const x = Float32Array.from(five), y = five.map(v => v * v + 3 * v), { DERIVATIVE, SECOND_DERIVATIVE } = BoundaryCondition
function parabola(Kind, left, right) {
  const s = Kind.newInstance()
  s.computeOpenCoefficients(5, new Float32Array(5), x, y, { leftConstraint: left, leftValue: left === DERIVATIVE ? 3 : 2, rightConstraint: right,
    rightValue: right === DERIVATIVE ? 11 : 2 })
  let off = 0
  for (let k = 0; k < 4; ++k) for (let t = 0; t <= 1; t += 0.01) off = Math.max(off, Math.abs(s.getValue(k, t) - (k + t) ** 2 - 3 * (k + t)))
  const slopes = [(s.getValue(0, 0.001) - s.getValue(0, 0)) / 0.001, (s.getValue(3, 1) - s.getValue(3, 0.999)) / 0.001]
  const name = v => v === DERIVATIVE ? 'slope' : 'second derivative'
  console.log(`${s.getClassName()}, left ${name(left)}, right ${name(right)}: off by ${off.toFixed(3)}, slopes ${slopes.map(v => v.toFixed(2)).join(', ')}`)
  return { off, slopes }
}
const both = parabola(Cardinal, DERIVATIVE, DERIVATIVE), seconds = parabola(Cardinal, SECOND_DERIVATIVE, SECOND_DERIVATIVE)
const mixed = parabola(Cardinal, DERIVATIVE, SECOND_DERIVATIVE), other = parabola(Cardinal, SECOND_DERIVATIVE, DERIVATIVE)
const copied = parabola(Kochanek, DERIVATIVE, DERIVATIVE)
good &&= both.off < 1e-4 && seconds.off < 1e-4 && near(mixed.slopes[0], 1.5, 0.02) && mixed.off > 0.2 && near(other.slopes[0], 9.34, 0.05) && other.off > 0.9
good &&= near(copied.slopes[0], 3, 0.02) && near(copied.slopes[1], 3, 0.05) && copied.off > 1
process.exit(good ? 0 : 1)
C
node ends.mjs
