#!/bin/sh
# @mathigon/fermat 1.1.24 (npm, mathematics): Matrix.determinant() is wrong for matrices of 4 rows and more. Two rows exchanged in the 4 x 4 identity
# give 0 in place of -1, two equal rows do not give 0, det(AB) is not det(A) det(B). The triangle of sides 3, 4, 5 has area 0 by its 4 x 4
# Cayley-Menger determinant, in place of 6, and the incircle test of four points has the right sign for 57 of 200, and is never 0 on the circle.
# Cause: determinant() sums the products along the n diagonals to the right less those along the n to the left, which is the rule of Sarrus, for
# 3 x 3 only: of the 24 products of a 4 x 4 matrix it takes 8, some with the wrong sign. 2 and 3 rows are right, diagonal and triangular ones too.
# Matrix.inverse() does not use it and is right, a check. Besides, correlation() divides a covariance of n by deviations of n - 1: points
# on a line have (n - 1) / n, 0.8 for five points, 0.5 for two, in place of 1. Nothing is said. The measure is Laplace's expansion.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @mathigon/fermat@1.1.24 @mathigon/core@1.1.23
cat > determinant.cjs <<'J'
const { readFileSync } = require('fs')
const { Matrix, correlation } = require('@mathigon/fermat')
console.log('@mathigon/fermat', JSON.parse(readFileSync('node_modules/@mathigon/fermat/package.json')).version)
const near = (a, b, by = 1e-9) => Math.abs(a - b) <= by * (1 + Math.abs(b))
const laplace = m => m.length === 1 ? m[0][0] : m[0].reduce((s, v, j) => s + (j % 2 ? -v : v) * laplace(m.slice(1).map(row => row.filter((_, k) => k !== j))), 0)
// the rule of Sarrus, written for any n: what the library does
const sarrus = m => m.reduce((s, _, j) => s + m.reduce((p, row, i) => p * row[(j + i) % m.length], 1) - m.reduce((p, row, i) => p * row[(j - i + m.length) % m.length], 1), 0)
let seed = 1
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const some = n => Array.from({ length: n }, () => Array.from({ length: n }, () => 18 * random() - 9))
let good = true
const show = (name, m, wrong) => {
  const got = Matrix.determinant(m), right = laplace(m)
  console.log(`${name}: ${got}, right ${right}`)
  good &&= wrong === undefined ? near(got, right) : near(got, wrong) && !near(right, wrong)
}
show('identity, 4 rows', Matrix.identity(4))
show('triangular, 4 rows', [[2, 5, 1, 3], [0, 3, 4, 1], [0, 0, 4, 6], [0, 0, 0, 5]])
show('identity, 4 rows, the first two exchanged', [[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], 0)
show('rows turned by one, 4 rows', [[0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1], [1, 0, 0, 0]], 1)
show('two equal rows', [[1, 2, 3, 4], [1, 2, 3, 4], [2, 0, 1, 5], [3, 1, 4, 1]], 60)
for (const n of [2, 3, 4, 5, 6]) {
  let right = 0, inverse = 0, product = 0, rule = 0
  for (let k = 0; k < 200; ++k) {
    const A = some(n), B = some(n), a = Matrix.determinant(A)
    right += near(a, laplace(A))
    rule += n < 3 || near(a, sarrus(A))
    product += near(Matrix.determinant(Matrix.product(A, B)), a * Matrix.determinant(B))
    inverse += Matrix.product(A, Matrix.inverse(A)).every((row, i) => row.every((v, j) => Math.abs(v - (i === j)) < 1e-6))
  }
  console.log(`${n} rows, 200 random matrices: determinant right in ${right}, det(AB) = det(A) det(B) in ${product}; rule of Sarrus in ${rule}; inverse right in ${inverse}`)
  good &&= rule === 200 && inverse >= 199 && (n < 4 ? right === 200 && product === 200 : right < 10 && product < 10)
}
// the area of a triangle by its sides
const area = (det, a, b, c) => -det([[0, 1, 1, 1], [1, 0, c * c, b * b], [1, c * c, 0, a * a], [1, b * b, a * a, 0]]) / 16
const [found, true2] = [area(Matrix.determinant, 3, 4, 5), area(laplace, 3, 4, 5)]
console.log(`triangle 3, 4, 5: the square of its area by Cayley and Menger is ${found}, right ${true2}`)
good &&= near(true2, 36) && near(found, 0)
// in the circle through three points, counterclockwise: positive inside
const circle = (det, ...points) => det(points.map(([x, y]) => [x, y, x * x + y * y, 1]))
let same = 0, on = 0
for (let k = 0; k < 200; ++k) {
  const at = t => [3 + 2 * Math.cos(t), 1 + 2 * Math.sin(t)], p = [3 + 4 * random() - 2, 1 + 4 * random() - 2], three = [at(0.2), at(2), at(4.5)]
  same += Math.sign(circle(Matrix.determinant, ...three, p)) === Math.sign(circle(laplace, ...three, p))
  on += Math.abs(circle(Matrix.determinant, ...three, at(6 * random()))) < 1e-6
  good &&= Math.abs(circle(laplace, ...three, at(6 * random()))) < 1e-6 && (circle(laplace, ...three, p) > 0) === (Math.hypot(p[0] - 3, p[1] - 1) < 2)
}
console.log(`incircle test, 200 points: the sign is right for ${same}; of 200 points on the circle ${on} have 0`)
good &&= same < 100 && on < 10
for (const n of [2, 5, 20]) {
  const x = Array.from({ length: n }, (_, i) => i + 1), r = correlation(x, x.map(v => 2 * v + 3))
  console.log(`correlation of ${n} points on a line: ${r.toFixed(4)}`)
  good &&= near(r, (n - 1) / n)
}
process.exit(good ? 0 : 1)
J
node determinant.cjs
