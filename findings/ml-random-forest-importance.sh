#!/bin/sh
# ml-random-forest 2.1.0 (npm): featureImportance() is not the decrease in impurity. Of two features that make four classes by quadrants a single tree
# gives -1 and 2 (right: 1/3 and 2/3). Of a step of 10 with noise of 1, seen in one of eleven columns, that column has 0.57 in place of 0.998, and ten
# columns of pure noise share the rest; a step of 1000 gives the same.
# Cause: a node's importance is taken as n gain less that of its two parts, a formula for impurities. But the gain of ml-cart is a decrease already
# for classes (so that good splits below count against the node above, and sums turn negative), and for regression the squared error that remains
# after the split, so that a node counts the less the better it splits. Both are then divided by a sum of such terms.
# Besides, maxSamples, said to draw that many samples, takes the first rows: of a sorted table with maxSamples 0.5 the upper half is never learned.
# It does not show for two classes told apart by one cut. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts ml-random-forest@2.1.0 ml-cart@2.1.1 ml-matrix@6.15.1
cat > importance.mjs <<'J'
import { readFileSync } from 'node:fs'
import forest from 'ml-random-forest'
const { RandomForestClassifier, RandomForestRegression } = forest
console.log('ml-random-forest', JSON.parse(readFileSync('node_modules/ml-random-forest/package.json')).version)
let seed = 1
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const near = (a, b, by) => Math.abs(a - b) <= by
const mean = a => a.reduce((s, v) => s + v, 0) / a.length
// impurity times the number of samples: Gini's for classes, the squared error for numbers
const gini = y => y.length - [...new Set(y)].reduce((s, c) => s + y.filter(v => v === c).length ** 2, 0) / Math.max(1, y.length)
const square = y => { const m = mean(y); return y.length ? y.reduce((s, v) => s + (v - m) ** 2, 0) : 0 }
// mean decrease in impurity, in the very trees of the forest
function decrease(model, X, y, impurity) {
  const { estimators, indexes } = JSON.parse(JSON.stringify(model)).baseModel, total = X[0].map(() => 0)
  estimators.forEach(({ root }, t) => {
    const own = X[0].map(() => 0)
    function walk(node, rows) {
      if (!node.left || !node.right || !rows.length) return
      const column = indexes[t][node.splitColumn], less = rows.filter(i => X[i][column] < node.splitValue), more = rows.filter(i => X[i][column] >= node.splitValue)
      const values = part => part.map(i => y[i])
      own[column] += impurity(values(rows)) - impurity(values(less)) - impurity(values(more))
      walk(node.left, less)
      walk(node.right, more)
    }
    walk(root, X.map((_, i) => i))
    const sum = own.reduce((s, v) => s + v, 0)
    own.forEach((v, k) => { total[k] += v / sum / estimators.length })
  })
  return total
}
const show = a => a.map(v => v.toFixed(3)).join(' ')
let good = true
function compare(name, Model, X, y, options) {
  const model = new Model({ maxFeatures: X[0].length, replacement: false, seed: 1, noOOB: true, ...options })
  model.train(X, y)
  const got = model.featureImportance(), right = decrease(model, X, y, Model === RandomForestClassifier ? gini : square)
  console.log(`${name}: importance ${show(got)}; decrease in impurity ${show(right)}`)
  return { got, right, sorted: [...got].sort((a, b) => a - b) }
}
const table = (n, d) => Array.from({ length: n }, () => Array.from({ length: d }, random))
const square2 = table(400, 2), quadrant = square2.map(([a, b]) => (a > 0.5 ? 1 : 0) + (b > 0.5 ? 2 : 0))
const many = [1, 2, 3, 4].map(s => compare(`four classes by quadrants, one tree, seed ${s}`, RandomForestClassifier, square2, quadrant, { nEstimators: 1, seed: s }))
good &&= many.every(m => near(m.sorted[0], -1, 0.1) && near(m.sorted[1], 2, 0.1) && m.right.every(v => v > 0.25))
const cut = compare('two classes by one cut, 20 trees', RandomForestClassifier, square2, square2.map(([a]) => a > 0.5 ? 1 : 0), { nEstimators: 20 })
good &&= near(cut.got[0], 1, 1e-6) && near(cut.right[0], 1, 0.01)
const wide = table(300, 11)
for (const height of [10, 1000]) {
  const step = compare(`step of ${height} with noise, one column of eleven, 20 trees`, RandomForestRegression, wide, wide.map(x => (x[0] > 0.5 ? height : 0) + random()), { nEstimators: 20 })
  good &&= step.got[0] < 0.65 && step.right[0] > 0.99
}
const sum = compare('10 a + 5 b, 20 trees', RandomForestRegression, wide, wide.map(x => 10 * x[0] + 5 * x[1]), { nEstimators: 20 })
good &&= near(sum.right[0], 0.8, 0.05)
// half the rows of a table, sorted and not
const rows = Array.from({ length: 200 }, (_, i) => [i, i]), mixed = rows.map(row => [random(), row]).sort((a, b) => a[0] - b[0]).map(([, row]) => row)
const half = rows => { const model = new RandomForestRegression({ nEstimators: 30, maxSamples: 0.5, seed: 1 }); model.train(rows, rows.map(([v]) => v)); return model.predict([[20, 20], [150, 150], [199, 199]]) }
const sorted = half(rows), shuffled = half(mixed)
console.log(`0 to 199, maxSamples 0.5, predictions for 20, 150 and 199: sorted ${show(sorted)}; shuffled ${show(shuffled)}`)
good &&= near(sorted[0], 20, 3) && sorted[1] < 100 && sorted[2] < 100 && near(shuffled[0], 20, 6) && near(shuffled[1], 150, 6) && near(shuffled[2], 199, 8)
process.exit(good ? 0 : 1)
J
node importance.mjs
