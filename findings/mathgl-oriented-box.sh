#!/bin/sh
# @math.gl/culling 4.1.0 (npm, the bounding volumes of loaders.gl and deck.gl): makeOrientedBoundingBoxFromPoints() makes boxes larger than the
# axis-aligned one. Its axes come from computeEigenDecomposition(), ported from Cesium, where an index is asked for by (column, row); math.gl's
# Matrix3.getElementIndex() takes (row, column), so that every Jacobi rotation turns the wrong way, away from the diagonal, and after the tenth
# sweep, not converged, what there is is returned as 'diagonal' and 'unitary'. The two are orthogonal and multiply to the input, and at 0, 45
# and 90 degrees all is right, so that simple tests pass; a box turned by 15 degrees is taken for one about twice as large.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save @math.gl/culling@4.1.0 @math.gl/core@4.1.0
cat > box.mjs <<'J'
import { readFileSync } from 'node:fs'
import { computeEigenDecomposition, makeAxisAlignedBoundingBoxFromPoints, makeOrientedBoundingBoxFromPoints } from '@math.gl/culling'
console.log('@math.gl/culling', JSON.parse(readFileSync('node_modules/@math.gl/culling/package.json')).version)
const show = list => [...list].map(x => x.toFixed(3)).join(' ')
// a symmetric matrix whose eigenvalues are (7 +- sqrt(5)) / 2 and 2
const result = computeEigenDecomposition([4, 1, 0, 1, 3, 0, 0, 0, 2])
const unitary = [...result.unitary], diagonal = [...result.diagonal] // copies, as the next call writes into the same matrices
console.log(`eigenvalues ${show([(7 + Math.sqrt(5)) / 2, (7 - Math.sqrt(5)) / 2, 2])}; on the diagonal ${show([diagonal[0], diagonal[4], diagonal[8]])},`,
  `beside it ${diagonal[1].toFixed(3)}`)
const u = [unitary[0], unitary[1]] // first column: A u should be lambda u
const residual = Math.hypot(4 * u[0] + u[1] - diagonal[0] * u[0], u[0] + 3 * u[1] - diagonal[0] * u[1])
console.log(`first eigenvector off by ${residual.toFixed(3)}`)
const half = [4, 2, 1], larger = []
for (const degrees of [0, 15, 30, 45, 60, 75, 90]) {
  const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180), corners = []
  for (const x of [-4, 4]) for (const y of [-2, 2]) for (const z of [-1, 1]) corners.push([c * x - s * y, s * x + c * y, z])
  const got = [...makeOrientedBoundingBoxFromPoints(corners).halfSize].sort((a, b) => b - a)
  const aligned = makeAxisAlignedBoundingBoxFromPoints(corners).halfDiagonal
  const volume = list => 8 * list[0] * list[1] * list[2]
  console.log(`box turned by ${degrees}: half sizes ${show(half)}, volume ${volume(half)}; oriented box ${show(got)}, volume ${volume(got).toFixed(1)};`,
    `axis-aligned one ${volume(aligned).toFixed(1)}`)
  if (volume(got) > volume(aligned) + 0.1) larger.push(degrees)
}
console.log('larger than the axis-aligned one at', larger.join(' and '))
process.exit(Math.abs(diagonal[1]) > 0.6 && residual > 0.6 && larger.join() === '15,75' ? 0 : 1)
J
node box.mjs
