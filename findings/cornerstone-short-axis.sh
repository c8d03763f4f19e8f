#!/bin/sh
# @cornerstonejs/tools 5.14.0 (npm, the measurements of the OHIF viewer): getSegmentLargestBidirectional() gives long and short axis of a segment, as
# RECIST has them, and the short one may be a half of what it should be. createBidirectionalForSlice() takes the longest of those pairs of vertices
# of the contour that are square to the long axis with a cosine of at most 0.01 (0.6 degrees). The vertices are voxels' centres, and few pairs of
# them are so nearly square to a tilted axis, seldom the widest. A lesion of 40 by 18, turned by 39 degrees, has a short axis of 10.6. If no
# pair fits, the whole slice is left out: the 'largest' axes come from a smaller slice, or there are none. The answer hangs on the angle and on
# fractions of a voxel, so that a lesion seems to grow or shrink between visits. Segments along the rows, circles, and most ellipses
# of 2 to 1 look right. Nothing is said: the types have maxMajor and maxMinor, and the request (OHIF issue 4515) was for the longest perpendicular.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts --legacy-peer-deps @cornerstonejs/tools@5.14.0 @cornerstonejs/core@5.14.0 \
  @cornerstonejs/metadata@5.14.0 @kitware/vtk.js@36.4.1 gl-matrix@3.4.3 d3-array@3.2.4 d3-interpolate@3.0.1 comlink@4.4.2
cat > axes.mjs <<'J'
import { readFileSync } from 'node:fs'
import { wrap } from 'comlink'
// The library's own worker, which getSegmentLargestBidirectional() asks, spoken to over a channel in place of a browser's worker.
const { port1, port2 } = new MessageChannel()
Object.assign(globalThis, { self: globalThis, window: globalThis, postMessage: (m, t) => port1.postMessage(m, t),
  addEventListener: (t, f) => port1.addEventListener(t, f), removeEventListener: (t, f) => port1.removeEventListener(t, f) })
port1.start()
console.time = console.timeEnd = () => {}
const home = './node_modules/@cornerstonejs/tools/'
console.log('@cornerstonejs/tools', JSON.parse(readFileSync(home + 'package.json')).version)
await import(home + 'dist/esm/workers/computeWorker.js')
const worker = wrap(port2)

const n = 64, slices = 4
// Slices of voxels of 1 mm: the digital ellipse of half axes a and b, turned by an angle.
const inside = ({ a, b, angle, x = 32, y = 32 }) => (i, j) => {
  const c = Math.cos(angle), s = Math.sin(angle), u = (i - x) * c + (j - y) * s, v = (j - y) * c - (i - x) * s
  return (u / a) ** 2 + (v / b) ** 2 <= 1
}
const voxels = test => Array.from({ length: n * n }, (_, k) => [k % n, Math.floor(k / n)]).filter(([i, j]) => test(i, j))
const measure = async lesions => {
  const scalarData = new Uint8Array(n * n * slices)
  lesions.forEach((lesion, k) => voxels(inside(lesion)).forEach(([i, j]) => { scalarData[(k + 1) * n * n + j * n + i] = 1 }))
  const [found] = await worker.getSegmentLargestBidirectionalInternal({ indices: [1], mode: 'individual',
    segmentationInfo: { scalarData, dimensions: [n, n, slices], spacing: [1, 1, 1], origin: [0, 0, 0], direction: [1, 0, 0, 0, 1, 0, 0, 0, 1] } })
  return found && { long: found.maxMajor, short: found.maxMinor, axis: found.majorAxis, slice: found.majorAxis[0][2] }
}
// The longest chord at right angles to the long axis found, of the hull of the voxels' centres.
const cross = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
const hull = points => {
  const half = list => list.reduce((h, p) => { while (h.length > 1 && cross(h[h.length - 2], h[h.length - 1], p) <= 0) h.pop(); h.push(p); return h }, [])
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1])
  return [...half(sorted).slice(0, -1), ...half(sorted.reverse()).slice(0, -1)]
}
const widest = (lesion, [p, q]) => {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]), e = [(q[0] - p[0]) / length, (q[1] - p[1]) / length]
  const turned = hull(voxels(inside(lesion))).map(([i, j]) => [i * e[0] + j * e[1], j * e[0] - i * e[1]])
  const chord = t => {
    const cuts = turned.flatMap((a, k) => {
      const b = turned[(k + 1) % turned.length], s = (t - a[0]) / (b[0] - a[0])
      return s >= 0 && s <= 1 ? [a[1] + s * (b[1] - a[1])] : []
    })
    return Math.max(...cuts) - Math.min(...cuts)
  }
  return Math.max(...turned.map(([t]) => chord(t)))
}
let good = true
const near = (x, y, by = 0.005) => Math.abs(x - y) <= by
const degree = Math.PI / 180
for (const [a, b, tilt, seen, right] of [[20, 9, 0, 18, 18], [20, 9, 9, 14.32, 17.5], [20, 9, 39, 10.63, 17.5], [12, 7, 40, 11.66, 13.3], [10, 10, 0, 20, 20],
  [20, 10, 30, 19.72, 19.7]]) {
  const lesion = { a, b, angle: tilt * degree }, found = await measure([lesion]), most = widest(lesion, found.axis)
  console.log(`${2 * a} by ${2 * b} mm at ${tilt} degrees: long ${found.long.toFixed(2)}, short ${found.short.toFixed(2)}; the longest chord square to it is ${most.toFixed(2)}`)
  good &&= near(found.long, 2 * a, 1.3) && near(found.short, seen) && near(most, right, 0.6)
}
const large = { a: 8, b: 5, angle: 9 * degree }, small = { a: 5, b: 4, angle: 0 }
const alone = await measure([large]), both = await measure([large, small]), upright = await measure([{ ...large, angle: 0 }, small])
console.log('16 by 10 mm at 9 degrees, alone:', alone ?? 'nothing')
console.log(`and 10 by 8 mm in the next slice: long ${both.long.toFixed(2)}, short ${both.short.toFixed(2)}, of slice ${both.slice}; the first upright: long`,
  `${upright.long.toFixed(2)}, short ${upright.short.toFixed(2)}, of slice ${upright.slice}`)
good &&= alone === undefined && both.slice === 2 && near(both.long, 10) && upright.slice === 1 && near(upright.long, 16) && near(upright.short, 10)

let seed = 1
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647
for (const [a, b, fewest] of [[8, 5, 40], [15, 8, 40]]) {
  const ratios = []
  let none = 0
  for (let k = 0; k < 100; ++k) {
    const lesion = { a, b, angle: Math.PI * random(), x: 32 + random(), y: 32 + random() }, found = await measure([lesion])
    if (found) ratios.push(found.short / widest(lesion, found.axis)); else ++none
  }
  ratios.sort((p, q) => p - q)
  const low = ratios.filter(r => r < 0.85).length
  console.log(`${2 * a} by ${2 * b} mm, 100 places and angles: short axis under 85 % of the chord in ${low}, at the least ${ratios[0].toFixed(2)} of it, none in ${none}`)
  good &&= low + none >= fewest && ratios[0] < 0.7
}
port1.close()
process.exit(good ? 0 : 1)
J
node axes.mjs
