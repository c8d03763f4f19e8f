#!/bin/sh
# ml-cart 2.1.1 (npm, decision trees): DecisionTreeRegression refuses a split that is perfect. Trained on a clean step (0 for the smaller half of x,
# 10 for the larger) it predicts 5 everywhere, R2 0; stairs of four levels come out as two. With noise of 1e-6 in y the same steps are found.
# Cause: for regression the gain of TreeNode.bestSplit() is the squared error that remains, best if 0, but train() asks for this.gain >
# this.gainThreshold, meant for the classifier's gain; the threshold of regression is 0. Besides, it wants gain !== parentGain, 0 at the root.
# So every node whose data one cut would separate stays whole: the less noise the worse, and yes/no data (0 and 1) that are separable give 0.5.
# With gainThreshold: -1, not documented for regression, the stairs are found, and the single step at the root still is not, by the second condition.
# It does not show with noise, nor in DecisionTreeClassifier. RandomForestRegression (ml-random-forest 2.1.0) is made of such trees. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts ml-cart@2.1.1 ml-random-forest@2.1.0 ml-matrix@6.15.1
cat > split.mjs <<'J'
import { readFileSync } from 'node:fs'
import cart from 'ml-cart'
import forest from 'ml-random-forest'
const { DecisionTreeRegression, DecisionTreeClassifier } = cart, { RandomForestRegression } = forest
console.log('ml-cart', JSON.parse(readFileSync('node_modules/ml-cart/package.json')).version)
let seed = 1
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const mean = a => a.reduce((s, v) => s + v, 0) / a.length, square = a => { const m = mean(a); return a.reduce((s, v) => s + (v - m) ** 2, 0) }
const near = (a, b, by = 1e-9) => Math.abs(a - b) <= by, all = (a, f) => a.every(f)
// a regression tree as in the book: cut where the squared error is least, as long as it falls
function reference(rows, y) {
  const before = square(y)
  let best = { error: before - 1e-12 * (1 + before) }
  if (rows.length > 3) rows[0].forEach((_, column) => {
    const values = [...new Set(rows.map(row => row[column]))].sort((a, b) => a - b)
    for (let i = 1; i < values.length; ++i) {
      const cut = (values[i - 1] + values[i]) / 2, less = y.filter((_, k) => rows[k][column] < cut), more = y.filter((_, k) => rows[k][column] >= cut)
      const error = square(less) + square(more)
      if (error < best.error) best = { error, column, cut }
    }
  })
  if (best.column === undefined) { const m = mean(y); return () => m }
  const part = side => reference(rows.filter(row => (row[best.column] < best.cut) === side), y.filter((_, k) => (rows[k][best.column] < best.cut) === side))
  const less = part(true), more = part(false)
  return row => row[best.column] < best.cut ? less(row) : more(row)
}
function fit(name, rows, y, options) {
  const tree = new DecisionTreeRegression(options)
  tree.train(rows, y)
  const got = tree.predict(rows), r2 = p => 1 - p.reduce((s, v, i) => s + (v - y[i]) ** 2, 0) / square(y), book = rows.map(reference(rows, y))
  console.log(`${name}: R2 ${r2(got).toFixed(4)}, predicts ${[...new Set(got.map(v => +v.toFixed(3)))].slice(0, 8)}; a tree by the book R2 ${r2(book).toFixed(4)}`)
  return { got, r2: r2(got), book: r2(book) }
}
let good = true
for (const n of [6, 10, 40, 200]) {
  const rows = Array.from({ length: n }, (_, i) => [i]), y = rows.map(([x]) => x < n / 2 ? 0 : 10)
  const clean = fit(`step, ${n} points`, rows, y)
  good &&= near(clean.r2, 0) && all(clean.got, v => near(v, 5)) && near(clean.book, 1)
  if (n < 40) continue
  for (const noise of [1e-6, 0.1]) {
    const found = fit(`step, ${n} points, noise ${noise}`, rows, y.map(v => v + noise * (random() - 0.5)))
    good &&= found.r2 > 0.999
  }
  const outcome = fit(`no (0) and yes (1), ${n} points`, rows, y.map(v => v / 10))
  good &&= all(outcome.got, v => near(v, 0.5)) && near(outcome.r2, 0)
  const second = fit(`step, ${n} points, gainThreshold -1`, rows, y, { gainThreshold: -1 })
  good &&= near(second.r2, 0)
  const sorter = new DecisionTreeClassifier()
  sorter.train(rows, y.map(v => v / 10))
  const right = sorter.predict(rows).filter((v, i) => v === y[i] / 10).length
  console.log(`the classifier, ${n} points: ${right} right`)
  good &&= right === n
  const trees = new RandomForestRegression({ seed: 3, maxFeatures: 1.0, replacement: true, nEstimators: 50 })
  trees.train(rows.map(([x]) => [x, x]), y)
  const woods = trees.predict(rows.map(([x]) => [x, x]))
  console.log(`a forest of 50 trees, ${n} points: from ${Math.min(...woods).toFixed(3)} to ${Math.max(...woods).toFixed(3)}`)
  good &&= Math.max(...woods) - Math.min(...woods) < 1e-6 && Math.abs(woods[0] - 5) < 1
}
const line = Array.from({ length: 40 }, (_, i) => [i]), stairs = line.map(([x]) => 10 * Math.floor(x / 10))
const four = fit('stairs of four levels', line, stairs), mended = fit('stairs of four levels, gainThreshold -1', line, stairs, { gainThreshold: -1 })
good &&= all(four.got, (v, i) => near(v, i < 20 ? 5 : 25)) && near(four.book, 1) && near(mended.r2, 1)
// four fields of a map, each with its own level
const field = Array.from({ length: 100 }, (_, i) => [i % 10, Math.floor(i / 10)]), level = field.map(([x, y]) => (x < 5 ? 0 : 20) + (y < 5 ? 0 : 6))
const map = fit('map of four fields', field, level)
good &&= all(map.got, (v, i) => near(v, field[i][0] < 5 ? 3 : 23)) && near(map.book, 1)
process.exit(good ? 0 : 1)
J
node split.mjs
