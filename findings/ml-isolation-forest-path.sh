#!/bin/sh
# ml-isolation-forest 0.1.0 (npm): anomaly scores are divided by the wrong mean depth, so that the usual limit of 0.5 tells nothing for small samples.
# The score of a point is 2^(-E(h) / c(n)) with c(n) = 2 H(n-1) - 2 (n-1) / n, the mean depth of a search in a tree of n points (Liu, Ting and Zhou,
# 'Isolation forest', 2008, where H(i) = ln i + 0.5772 is an estimate): points at the mean depth score 0.5, whatever n is.
# Cause: averagePathLengthFromRoot() doubles ln(n-1) but not Euler's constant: c is too small by 0.577 at every n, and below that of two points, which is
# 1, at three (0.63) and above it only from four (1.27). As c(n) also stands for what is below a leaf with n points, leaves of three look shallower than of two.
# For 3, 4, 8, 16 and 256 points of one law the mean score is 0.17, 0.31, 0.43, 0.46 and 0.49 in place of a half.
# The order of the points, and two points, are right. Nothing is said. The measure is the harmonic sum, and c is read back from score and depth of each point.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts ml-isolation-forest@0.1.0 ml-array-max@1.2.4 ml-array-min@1.2.3
cat > forest.cjs <<'J'
const { IsolationForest } = require('ml-isolation-forest')
console.log('ml-isolation-forest', require('ml-isolation-forest/package.json').version)
let state = 12345
Math.random = () => (state = (state * 16807) % 2147483647) / 2147483647  // the same every time
const harmonic = n => { let sum = 0; for (let i = 1; i < n; ++i) sum += 1 / i; return sum }
const right = n => n < 2 ? 0 : 2 * harmonic(n) - 2 * (n - 1) / n
const found = n => n < 2 ? 0 : n === 2 ? 1 : 2 * Math.log(n - 1) + 0.57721 - 2 * (n - 1) / n
// the leaf of a point: its depth, and how many points of the training are there
function leaf(node, x, depth = 0) {
  if (node.isLeafNode()) return [depth, node.numberDataPoints()]
  return leaf(x[node.splitColumn] < node.splitValue ? node.left : node.right, x, depth + 1)
}
let good = true
for (const n of [2, 3, 4, 8, 16, 256]) {
  let sum = 0, proper = 0, count = 0, c = 0, far = 0, ranks = true
  for (let k = 0; k < Math.ceil(400 / n); ++k) {
    const points = Array.from({ length: n }, () => [Math.random(), Math.random()])
    const forest = new IsolationForest({ nEstimators: 200 })
    forest.train(points)
    const scores = forest.predict(points)
    const depths = points.map(x => forest.forest.map(tree => leaf(tree, x)))
    const mean = (rows, of) => rows.reduce((s, [d, m]) => s + d + of(m), 0) / rows.length
    points.forEach((x, i) => {
      const h = mean(depths[i], found)
      c = -h / Math.log2(scores[i])
      far = Math.max(far, Math.abs(c - found(n)))
      sum += scores[i]
      proper += 2 ** (-mean(depths[i], right) / right(n))
      ++count
    })
    // more isolated, higher score
    const order = points.map((_, i) => i).sort((a, b) => mean(depths[a], found) - mean(depths[b], found))
    ranks &&= order.every((p, i) => i === 0 || scores[order[i - 1]] >= scores[p] - 1e-12)
  }
  console.log(`${n} points: divided by ${c.toFixed(4)} for ${right(n).toFixed(4)};`,
    `mean score ${(sum / count).toFixed(3)}, with the right divisor ${(proper / count).toFixed(3)}`)
  good &&= far < 1e-6 && ranks
  good &&= n === 2 ? Math.abs(sum / count - 0.5) < 1e-9 && right(2) === 1 : found(n) < right(n) - 0.5 && sum / count < proper / count - 0.005
}
good &&= found(3) < found(2) && right(3) > right(2)
process.exit(good ? 0 : 1)
J
node forest.cjs
