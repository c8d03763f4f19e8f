#!/bin/sh
# density-clustering 1.3.0 (npm): the reachability plot of OPTICS knows no core distance, so that minPts smooths nothing. For points 1 apart on a line and
# minPts 5 no reachability can be below 2, the distance from a point to its fifth neighbour, itself counted; the plot is 1 throughout, as for minPts 1.
# Cause: _distanceToCore() tries whole numbers from 0 up and asks for the points within each. _regionQuery() takes a radius of 0 as none given, and puts
# epsilon there: every core point passes at once with core distance 0, and max(core distance, distance) is the plain distance. The plot is that of single
# linkage, and a thin chain of points, as far apart as theirs, joins two clusters: no cut of the plot parts them, where the package's own DBSCAN does.
# minPts only decides, as it should, which points are core at epsilon. Up to minPts 2, as in the documentation's examples, all is right, as the nearest
# point is never farther than the distance. Nothing is said. The documentation refers to Wikipedia for the plot, and has it as the way to the clusters.
# The measure is the definition (Ankerst and others, 1999): the least of max(core distance of o, distance to o) of all core points o before, in the order given.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts density-clustering@1.3.0
cat > optics.cjs <<'J'
const { DBSCAN, OPTICS } = require('density-clustering')
console.log('density-clustering', require('density-clustering/package.json').version)
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1])
// the distance to the minPts-th point, the point itself being the first, if below epsilon
function core(points, i, epsilon, minPts) {
  const d = points.map(p => distance(points[i], p)).sort((a, b) => a - b)[minPts - 1]
  return d < epsilon ? d : undefined
}
// by definition, in the order of the plot that is given; or, with bare distances, what is left without core distances
function byDefinition(points, order, epsilon, minPts, bare) {
  return order.map((p, k) => {
    let least = Infinity
    for (const o of order.slice(0, k)) {
      const c = core(points, o, epsilon, minPts), d = distance(points[o], points[p])
      if (c !== undefined && d < epsilon) least = Math.min(least, bare ? d : Math.max(c, d))
    }
    return least
  })
}
function plot(points, epsilon, minPts) {
  const optics = new OPTICS()
  optics.run(points, epsilon, minPts)
  const pairs = optics.getReachabilityPlot()
  return { order: pairs.map(([i]) => i), reach: pairs.map(([, r]) => r === undefined ? Infinity : r) }
}
const same = (a, b) => a.every((v, i) => v === b[i] || Math.abs(v - b[i]) < 1e-9)
const mean = a => a.filter(Number.isFinite).reduce((s, v) => s + v, 0) / a.filter(Number.isFinite).length
let good = true

const line = Array.from({ length: 20 }, (_, i) => [i, 0])
for (const minPts of [1, 2, 3, 5, 9]) {
  const { order, reach } = plot(line, 15, minPts), right = byDefinition(line, order, 15, minPts)
  console.log(`20 points 1 apart, minPts ${minPts}: reachability ${Math.min(...reach)} to ${Math.max(...reach.slice(1))};`,
    `by definition ${Math.min(...right)} to ${Math.max(...right.slice(1))}`)
  good &&= reach.slice(1).every(r => r === 1) && same(reach, right) === (minPts < 3) && Math.min(...right) === (minPts < 3 ? 1 : (minPts - 1) / 2)
}

// points at random, a dense group and a thin one
let seed = 7
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const two = Array.from({ length: 160 }, (_, i) => i < 100 ? [random(), random()] : [2 + 4 * random(), 4 * random()])
const first = plot(two, 6, 1)
for (const minPts of [1, 2, 3, 5, 10, 20]) {
  const { order, reach } = plot(two, 6, minPts), right = byDefinition(two, order, 6, minPts)
  console.log(`points at random, minPts ${minPts}: mean reachability ${mean(reach).toFixed(4)}, by definition ${mean(right).toFixed(4)};`,
    `the plot of minPts 1: ${same(order, first.order) && same(reach, first.reach) ? 'yes' : 'no'}`)
  good &&= same(order, first.order) && same(reach, first.reach) && same(reach, byDefinition(two, order, 6, minPts, true)) &&
    same(reach, right) === (minPts < 3) && (minPts < 5 || mean(right) > 1.5 * mean(reach))
}

// Two squares of 7 by 7 points, 1 apart, that a chain joins. A cut of the plot at some height gives the clusters of DBSCAN for that radius.
const joined = []
for (let x = 0; x < 7; ++x) for (let y = 0; y < 7; ++y) joined.push([x, y], [x + 20, y])
for (let x = 7; x < 20; ++x) joined.push([x, 3])
const centres = [[3, 3], [23, 3]].map(c => joined.findIndex(p => distance(p, c) === 0))
function cut(order, reach, radius, minPts) {
  let cluster = 0
  const of = []
  order.forEach((p, k) => {
    if (reach[k] >= radius) cluster = core(joined, p, radius, minPts) === undefined ? 0 : Math.max(0, ...of.filter(v => v)) + 1
    of[p] = cluster
  })
  return of[centres[0]] === of[centres[1]] ? 'one cluster' : 'two clusters'
}
for (const [radius, minPts] of [[1.6, 6], [1.6, 5], [1.2, 4], [1.6, 2]]) {
  const { order, reach } = plot(joined, 9, minPts)
  const clusters = new DBSCAN().run(joined, radius, minPts), own = clusters.some(c => centres.every(i => c.includes(i))) ? 'one cluster' : 'two clusters'
  const cuts = [cut(order, reach, radius, minPts), cut(order, byDefinition(joined, order, 9, minPts), radius, minPts)]
  console.log(`two squares and a chain, radius ${radius}, minPts ${minPts}: DBSCAN ${own}, plot of OPTICS cut there ${cuts[0]}, by definition ${cuts[1]}`)
  good &&= own === cuts[1] && cuts[0] === 'one cluster' && own === (minPts > 2 ? 'two clusters' : 'one cluster')
}
// what minPts does: a point that is core at epsilon takes its neighbours along
const few = [[0, 0], [1, 0], [2, 0]], sizes = [3, 4].map(minPts => new OPTICS().run(few, 5, minPts).map(c => c.length).join(' '))
console.log(`three points within epsilon: clusters of ${sizes[0]} for minPts 3, of ${sizes[1]} for minPts 4`)
good &&= sizes[0] === '3' && sizes[1] === '1 1 1'
process.exit(good ? 0 : 1)
J
node optics.cjs
