#!/bin/sh
# hdbscan-ts 1.0.17 (npm): finds the smallest dense core of each cluster and calls the rest noise. Of two normal clouds of 50 points, 10 standard
# deviations apart, about 80 of 100 points are noise, and the clusters have about minClusterSize members, or break up in several such; HDBSCAN
# (here written out below, after the paper that the README names) gives 50 and 50 for every minClusterSize from 3 to 30.
# Cause: in HDBSCAN a cluster that sheds single points, or fewer than minClusterSize, goes on as the same cluster. buildClusterHierarchy() makes a new
# cluster of what remains, so that every shed point adds one to a chain of nested clusters. extractClusters() then compares a cluster with the sum
# over all its descendants, the nested ones too, in place of the best of its two parts, and takes the innermost. With the chains left out (below, by
# an own condenseHierarchy()) the clouds come out whole. Besides, euclideanDistance() is the square of the distance, stability thus in 1/d^2.
# It does not show in clusters that are evenly dense, as a square grid or the README's example, which fall apart at once. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts hdbscan-ts@1.0.17
cat > cores.cjs <<'J'
const { readFileSync } = require('fs')
const { HDBSCAN } = require('hdbscan-ts')
console.log('hdbscan-ts', JSON.parse(readFileSync('node_modules/hdbscan-ts/package.json')).version)
// HDBSCAN: mutual reachability, single linkage, condensed tree, clusters by excess of mass, the root left out
function reference(points, size) {
  const n = points.length, distance = (a, b) => Math.hypot(...a.map((v, i) => v - b[i]))
  const core = points.map((p, i) => points.map((q, j) => j === i ? Infinity : distance(p, q)).sort((a, b) => a - b)[size - 1])
  const reach = (i, j) => Math.max(distance(points[i], points[j]), core[i], core[j])
  const nearest = points.map((_, j) => [reach(0, j), 0]), edges = [], left = new Set(points.keys())
  left.delete(0)
  while (left.size) {
    const next = [...left].reduce((a, b) => nearest[b][0] < nearest[a][0] ? b : a)
    left.delete(next)
    edges.push([...nearest[next], next])
    for (const j of left) if (reach(next, j) < nearest[j][0]) nearest[j] = [reach(next, j), next]
  }
  const at = points.map((_, i) => ({ points: [i], parts: [] }))
  for (const [width, a, b] of edges.sort((a, b) => a[0] - b[0])) {
    const node = { points: [...at[a].points, ...at[b].points], parts: [at[a], at[b]], width }
    for (const i of node.points) at[i] = node
  }
  function condense(node, birth) {
    const cluster = { points: node.points, stability: 0, children: [] }
    while (node.parts.length) {
      const death = 1 / node.width, large = node.parts.filter(part => part.points.length >= size)
      cluster.stability += (node.points.length - (large.length === 1 ? large[0].points.length : 0)) * (death - birth)
      if (large.length === 2) cluster.children = large.map(part => condense(part, death))
      if (large.length !== 1) break
      node = large[0]
    }
    return cluster
  }
  function best(cluster) {
    const below = cluster.children.map(best), sum = below.reduce((s, b) => s + b.stability, 0)
    return cluster.stability >= sum ? { stability: cluster.stability, chosen: [cluster] } : { stability: sum, chosen: below.flatMap(b => b.chosen) }
  }
  const labels = points.map(() => -1)
  condense(at[0], 0).children.flatMap(child => best(child).chosen).forEach((cluster, label) => cluster.points.forEach(i => { labels[i] = label }))
  return labels
}
function sizes(labels) {
  const members = []
  for (const label of labels) if (label >= 0) members[label] = (members[label] || 0) + 1
  return { members, noise: labels.filter(label => label < 0).length }
}
const show = ({ members, noise }) => `clusters of ${members.join(', ') || 'none'}, noise ${noise}`
const found = (points, minClusterSize) => sizes(new HDBSCAN({ minClusterSize }).fit(points))
let seed = 3
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const cloud = (x, y, spread, n) => Array.from({ length: n }, () => {
  const far = spread * Math.sqrt(-2 * Math.log(random())), turn = 2 * Math.PI * random()
  return [x + far * Math.cos(turn), y + far * Math.sin(turn)]
})
let good = true
const clouds = [...cloud(0, 0, 1, 50), ...cloud(10, 0, 1, 50)]
// the library with clusters of true splits only: where both parts have minClusterSize points
class Splits extends HDBSCAN {
  condenseHierarchy([root, ...parts]) {
    return [root, ...parts.filter((part, i) => part.size >= this.minClusterSize && parts[i ^ 1].size >= this.minClusterSize)]
  }
}
for (const [size, noise] of [[3, 60], [5, 70], [10, 60], [20, 40], [30, 25]]) {
  const got = found(clouds, size), right = sizes(reference(clouds, size)), tenfold = found(clouds.map(p => p.map(v => 10 * v)), size)
  const splits = sizes(new Splits({ minClusterSize: size }).fit(clouds))
  console.log(`two clouds of 50, minClusterSize ${size}: ${show(got)}; HDBSCAN: ${show(right)}; with the chains left out: ${show(splits)}`)
  good &&= right.members.join() === '50,50' && got.noise > noise && Math.max(...got.members) < size + 12 && show(got) === show(tenfold) &&
    (size < 5 || splits.members.join() === '50,50')
}
const three = [...cloud(0, 0, 0.3, 40), ...cloud(5, 0, 0.3, 40), ...cloud(0, 6, 1, 40)], got = found(three, 5), right = sizes(reference(three, 5))
console.log(`three clouds of 40, minClusterSize 5: ${show(got)}; HDBSCAN: ${show(right)}`)
good &&= right.members.join() === '40,40,40' && got.noise > 60
// two rows whose points lie ever farther apart: each loses its end
const rows = [0, 100].flatMap(start => Array.from({ length: 12 }, (_, i) => [start + i + i * i / 100]))
const ends = found(rows, 3), whole = sizes(reference(rows, 3))
console.log(`two rows of 12, minClusterSize 3: ${show(ends)}; HDBSCAN: ${show(whole)}`)
good &&= whole.members.join() === '12,12' && ends.members.join() === '10,10' && ends.noise === 4
// even squares: right, and the README's example
const squares = [0, 20].flatMap(x => Array.from({ length: 36 }, (_, i) => [x + i % 6, Math.floor(i / 6)]))
const even = found(squares, 5), evenRight = sizes(reference(squares, 5))
const readme = found([[1.1, 2.1], [2.1, 1.1], [1.1, 1.1], [0.1, 1.1], [10.1, 11.1], [11.1, 10.1], [10.1, 10.1]], 2)
console.log(`two squares of 36, minClusterSize 5: ${show(even)}; HDBSCAN: ${show(evenRight)}; the README's: ${show(readme)}`)
good &&= even.members.join() === '36,36' && evenRight.members.join() === '36,36' && readme.members.join() === '4,3'
process.exit(good ? 0 : 1)
J
node cores.cjs
