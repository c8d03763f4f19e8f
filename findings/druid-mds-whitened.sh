#!/bin/sh
# @saehrimnir/druidjs 0.9.0 (npm, September 2026): MDS, 'Classical Multidimensional Scaling', does not keep distances, not even when the points
# lie in a plane and two dimensions are asked for, where classical scaling gives the points back up to a turn. transform() returns the unit
# eigenvectors of the centred matrix of squared distances as coordinates, without multiplying each by the square root of its eigenvalue, so that
# every axis has the same spread: points of a strip of 8 by 1 come back as a square. The library's own stress() tells it: 0.9 in place of 0.
# PCA of the same library, which is to be the same up to a motion for such points, keeps the distances.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @saehrimnir/druidjs@0.9.0
cat > strip.mjs <<'J'
import { readFileSync } from 'node:fs'
import { MDS, PCA } from '@saehrimnir/druidjs'
console.log('@saehrimnir/druidjs', JSON.parse(readFileSync('node_modules/@saehrimnir/druidjs/package.json')).version)
const points = []
for (let i = 0; i < 9; ++i) for (let j = 0; j < 3; ++j) points.push([i, j / 2])
const spread = list => [0, 1].map(k => {
  const mean = list.reduce((s, p) => s + p[k], 0) / list.length
  return Math.sqrt(list.reduce((s, p) => s + (p[k] - mean) ** 2, 0) / list.length)
})
const distance = (list, a, b) => Math.hypot(list[a][0] - list[b][0], list[a][1] - list[b][1])
const mds = new MDS(points, { d: 2 })
const projected = mds.transform(), pca = new PCA(points, { d: 2 }).transform()
// classical scaling by hand: on the centred points the axes are the eigenvectors, the spreads the roots of eigenvalue / n
const ratios = {}
for (const [name, list] of [['points', points], ['MDS', projected], ['PCA', pca]]) {
  const s = spread(list).sort((a, b) => b - a)
  ratios[name] = s[0] / s[1]
  console.log(`${name}: spreads ${s.map(x => x.toFixed(3)).join(' and ')}, ratio ${ratios[name].toFixed(2)}; ends ${distance(list, 0, 24).toFixed(3)} apart,`,
    `sides ${distance(list, 0, 2).toFixed(3)}`)
}
console.log(`stress of MDS by its own stress(): ${mds.stress().toFixed(2)}`)
process.exit(Math.abs(ratios.MDS - 1) < 1e-3 && Math.abs(ratios.PCA - ratios.points) < 1e-3 && ratios.points > 6 && mds.stress() > 0.8 ? 0 : 1)
J
node strip.mjs
