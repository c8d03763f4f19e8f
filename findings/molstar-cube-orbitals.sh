#!/bin/sh
# molstar 5.11.0 (npm): of a Gaussian cube file that holds several orbitals Mol* shows none of them. In the file the orbitals take turns: at every
# point of the grid the value of the first, of the second and so on. volumeFromCube() has a parameter dataIndex, and VolumeFromCube, the transform of
# the viewer, offers the numbers of the orbitals for it, but orbital d is taken as every (d + 1)th number from the first on, in place of every m-th
# from the d-th on, where m are the orbitals in the file. With the default, 0, the first numbers stand in a row: of a file with three orbitals the
# first third of the grid is spread over the whole, the three mixed, and the rest is lost. With dataIndex = m - 1, which is offered as the last
# orbital, the first one is got, and only there a shape is right, under the wrong name. Nothing is said. The parser itself is right: all numbers
# are read, in their order; and a file with one orbital comes out right.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts --legacy-peer-deps molstar@5.11.0
cat > orbitals.cjs <<'J'
const { parseCube } = require('molstar/lib/commonjs/mol-io/reader/cube/parser.js')
const { volumeFromCube } = require('molstar/lib/commonjs/mol-model-formats/volume/cube.js')
const { VolumeFromCube } = require('molstar/lib/commonjs/mol-plugin-state/transforms/volume.js')
const { Grid } = require('molstar/lib/commonjs/mol-model/volume.js')
console.log('molstar', require('molstar/package.json').version)

const bohr = 0.529177210859, n = [30, 24, 27], step = 0.4, atoms = [[2, 4, 3], [9, 6, 5], [6, 3, 8]], width = 0.9
const away = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])
// orbital d: a ball about atom d, of the height 1, 2, 4
const orbital = (d, p) => 2 ** d * Math.exp(-(away(p, atoms[d]) ** 2) / (2 * width * width))

// lengths in bohr; the orbitals `list` take turns at each point, z runs fastest
function cube(list) {
  const lines = ['balls', 'balls', ` -${atoms.length} 0 0 0`, ` ${n[0]} ${step} 0 0`, ` ${n[1]} 0 ${step} 0`, ` ${n[2]} 0 0 ${step}`]
  for (const atom of atoms) lines.push(` 2 2.0 ${atom.join(' ')}`)
  lines.push(` ${list.length} ${list.map(d => d + 11).join(' ')}`)
  const numbers = []
  for (let i = 0; i < n[0]; ++i) for (let j = 0; j < n[1]; ++j) for (let k = 0; k < n[2]; ++k)
    for (const d of list) numbers.push(orbital(d, [i * step, j * step, k * step]).toExponential(8))
  for (let i = 0; i < numbers.length; i += 6) lines.push(' ' + numbers.slice(i, i + 6).join(' '))
  return lines.join('\n') + '\n'
}

async function read(list, dataIndex) {
  const file = (await parseCube(cube(list), 'balls').run()).result, { grid } = await volumeFromCube(file, { dataIndex }).run()
  const m = Grid.getGridToCartesianTransform(grid), { space, data } = grid.cells
  const differ = list.map(() => 0)                       // greatest difference from each orbital, in parts of its height
  let parsed = 0, top = 0, to = 0
  for (let i = 0; i < n[0]; ++i) for (let j = 0; j < n[1]; ++j) for (let k = 0; k < n[2]; ++k) {
    const value = space.get(data, i, j, k), p = [0, 1, 2].map(r => (m[r] * i + m[4 + r] * j + m[8 + r] * k + m[12 + r]) / bohr)
    top = Math.max(top, value)
    list.forEach((d, s) => {
      differ[s] = Math.max(differ[s], Math.abs(value - orbital(d, p)) / 2 ** d)
      parsed = Math.max(parsed, Math.abs(file.values[to++] - orbital(d, p)))
    })
  }
  return { differ, parsed, top, file }
}

async function main() {
  let good = true
  for (const [list, dataIndex, same] of [
    [[0], 0, 0], [[1], 0, 0], [[0, 1], 0, null], [[0, 1], 1, 0], [[0, 1, 2], 0, null], [[0, 1, 2], 1, null], [[0, 1, 2], 2, 0]]) {
    const { differ, parsed, top, file } = await read(list, dataIndex), ids = file.header.dataSetIds
    const offered = VolumeFromCube.definition.params({ data: file }).dataIndex.options.map(o => `${o[0]}: orbital ${o[1]}`).join(', ')
    const right = differ[dataIndex] < 1e-5, is = differ.findIndex(x => x < 1e-5)
    console.log(`orbitals ${ids.join(', ')} in the file; offered ${offered}; asked for ${ids[dataIndex]}:`,
      `${is < 0 ? `none of them, off by up to ${differ[dataIndex].toFixed(2)} of its height` : `it is ${ids[is]}`}; greatest value ${top.toFixed(2)}`)
    good &&= parsed < 1e-6 && ids.length === list.length && offered.split(',').length === list.length
    good &&= right === (list.length === 1) && (same === null ? is === -1 && differ[dataIndex] > 0.5 : is === same)
  }
  process.exit(good ? 0 : 1)
}
main()
J
node orbitals.cjs
