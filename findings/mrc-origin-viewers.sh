#!/bin/sh
# 3dmol 2.5.5 and molstar 5.11.0 (npm): a map in the MRC format that has an ORIGIN (x, y, z in angstrom, words 50 to 52) is not put where the header
# says. 3dmol adds ORIGIN to the start of the columns, rows and sections, which is counted in voxels (VolumeData.ccp4()): with voxels of 0.5 a map
# at 40, 20, 10 lies at 20, 10, 5, off the atoms that were fitted to it; voxels of 1 angstrom hide it. Mol* divides by the voxel
# (getCcp4Origin()), but then has x, y, z put in order as if they were columns, rows, sections (normalizeOrder in volumeFromCcp4()), which is due to
# the starts alone: if the columns run along z (MAPC, MAPR, MAPS = 3, 2, 1) the map starts at 10, 20, 40, and with voxels of unequal sides still
# elsewhere; 3dmol does that too. In both the map itself is right, and so is its place if it is given by the starts, or if there is no ORIGIN.
# Neither says a word of it; a comment in Mol* says that ORIGIN is used when available.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts --legacy-peer-deps 3dmol@2.5.5 molstar@5.11.0
cat > origin.cjs <<'J'
const { parse } = require('molstar/lib/commonjs/mol-io/reader/ccp4/parser.js')
const { volumeFromCcp4 } = require('molstar/lib/commonjs/mol-model-formats/volume/ccp4.js')
const { Grid } = require('molstar/lib/commonjs/mol-model/volume.js')
// 3dmol asks for a browser when it is loaded; here a stand-in that answers to everything and does nothing
const nothing = new Proxy(function () {}, {
  get: (t, key) => key === Symbol.toPrimitive ? () => '' : nothing, apply: () => nothing, construct: () => nothing, set: () => true })
globalThis.window = globalThis.self = globalThis
globalThis.document = nothing
Object.defineProperty(globalThis, 'navigator', { value: { userAgent: '' }, configurable: true })
const { VolumeData, GLShape } = require('3dmol')
console.log('3dmol', require('3dmol/package.json').version, 'molstar', require('molstar/package.json').version)

// a map of n voxels along x, y, z, of the sides `side`, stored in the order `axes` (1, 2, 3 for x, y, z; columns first)
function mrc(n, side, axes, origin, start, value) {
  const stored = axes.map(a => n[a - 1]), bytes = new ArrayBuffer(1024 + 4 * n[0] * n[1] * n[2])
  const int = new Int32Array(bytes), float = new Float32Array(bytes)
  int.set(stored, 0)
  int[3] = 2                                             // real numbers
  int.set(axes.map(a => start[a - 1]), 4)                // NXSTART, NYSTART, NZSTART: of columns, rows, sections
  int.set(n, 7)                                          // MX, MY, MZ
  float.set(n.map((m, k) => m * side[k]), 10)
  float.set([90, 90, 90], 13)
  int.set(axes, 16)
  float.set([0, 1, 0.02, 0.1], 19)                       // least, greatest, mean
  int[22] = 1
  float.set(origin, 49)
  new Uint8Array(bytes).set([77, 65, 80, 32, 68, 68, 0, 0], 208)
  float[54] = 0.1
  let to = 256
  for (let s = 0; s < stored[2]; ++s) for (let r = 0; r < stored[1]; ++r) for (let c = 0; c < stored[0]; ++c) {
    const at = [0, 0, 0]
    at[axes[0] - 1] = c; at[axes[1] - 1] = r; at[axes[2] - 1] = s
    float[to++] = value(at.map((x, k) => x * side[k]))
  }
  return bytes
}
const mean = points => [0, 1, 2].map(k => points.reduce((sum, p) => sum + p[k], 0) / points.length)
const away = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])
const show = v => v.map(x => x.toFixed(2)).join(', ')

// the middle of the isosurface at one half
function in3dmol(bytes) {
  const shape = new GLShape({}), points = []
  shape.addIsosurface(new VolumeData(bytes, 'ccp4'), { isoval: 0.5, smoothness: 0 })
  for (const group of shape.geo.geometryGroups)
    for (let i = 0; i < group.vertices; ++i) points.push([0, 1, 2].map(k => group.vertexArray[3 * i + k]))
  return mean(points)
}
// the middle of the voxels above one half, by the transform of the grid
async function inMolstar(bytes) {
  const file = await parse(new Uint8Array(bytes), 'map').run(), { grid } = await volumeFromCcp4(file.result).run()
  const m = Grid.getGridToCartesianTransform(grid), { space, data } = grid.cells, points = []
  for (let i = 0; i < space.dimensions[0]; ++i) for (let j = 0; j < space.dimensions[1]; ++j) for (let k = 0; k < space.dimensions[2]; ++k)
    if (space.get(data, i, j, k) > 0.5) points.push([0, 1, 2].map(r => m[r] * i + m[4 + r] * j + m[8 + r] * k + m[12 + r]))
  return mean(points)
}

async function main() {
  let good = true
  const n = [24, 28, 32], none = [0, 0, 0], xyz = [1, 2, 3], zyx = [3, 2, 1]
  for (const [name, side, axes, origin, start, off3dmol, offMolstar] of [
    ['no origin', [0.5, 0.5, 0.5], xyz, none, none, none, none],
    ['no origin, columns along z', [0.5, 0.5, 0.5], zyx, none, none, none, none],
    ['place by the starts, columns along z', [0.5, 0.5, 0.5], zyx, none, [80, 40, 20], none, none],
    ['voxels of 1', [1, 1, 1], xyz, [40, 20, 10], none, none, none],
    ['voxels of 0.5', [0.5, 0.5, 0.5], xyz, [40, 20, 10], none, [-20, -10, -5], none],
    ['voxels of 2', [2, 2, 2], xyz, [40, 20, 10], none, [40, 20, 10], none],
    ['voxels of 1, columns along z', [1, 1, 1], zyx, [40, 20, 10], none, [-30, 0, 30], [-30, 0, 30]],
    ['voxels of 0.5, columns along z', [0.5, 0.5, 0.5], zyx, [40, 20, 10], none, [-35, -10, 10], [-30, 0, 30]],
    ['voxels of 0.5, 0.5, 1, columns along z', [0.5, 0.5, 1], zyx, [40, 20, 10], none, [-35, -10, 30], [-35, 0, 70]]]) {
    const ball = [0.4, 0.5, 0.625].map((f, k) => f * n[k] * side[k]), width = 2 * Math.max(...side)
    const bytes = mrc(n, side, axes, origin, start, p => Math.exp(-(away(p, ball) ** 2) / (2 * width * width)))
    const right = ball.map((x, k) => x + origin[k] + start[k] * side[k])
    const a = in3dmol(bytes.slice(0)), b = await inMolstar(bytes.slice(0))
    console.log(`${name}: ball at ${show(right)}; 3dmol ${show(a)}, ${away(a, right).toFixed(1)} away;`,
      `Mol* ${show(b)}, ${away(b, right).toFixed(1)} away`)
    const near = (p, off) => away(p, right.map((x, k) => x + off[k])) < 0.6 * Math.max(...side)
    good &&= near(a, off3dmol) && near(b, offMolstar)
  }
  process.exit(good ? 0 : 1)
}
main()
J
node origin.cjs
