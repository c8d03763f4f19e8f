#!/bin/sh
# three 0.187.0 (npm): NRRDLoader puts scans stored in sagittal or coronal order on their heads, and left and right, or front and back, change sides.
# The matrix from voxels to RAS (right, anterior, superior) should be D * V, with D the signs from LPS to RAS and V the space directions. It is V * D
# (multiplyMatrices in parse()), so that the signs fall on the first two indices of the voxels in place of the first two axes of the patient. With V
# diagonal, as in axial scans, both are the same; a sagittal scan, such as 3D Slicer's MRHead, is turned by 180 degrees about the front-back axis,
# not mirrored, so that an upside-down head is all there is to see. For left-anterior-superior D itself is wrong: z has the minus instead of x, and
# axial scans are turned. Volume.matrix ('IJK to RAS') and extractSlice(), 'coordinates in Right Anterior Superior', go by it. Besides, slices of
# sagittal and coronal scans lie off by half the difference of two edges: the offset of a slice takes RASDimensions, which are in order of storage.
# A scan with space right-anterior-superior has the right matrix in every order. Nothing is said. (That the origin is left out is known, issue 24393.)
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts three@0.187.0
cat > scan.mjs <<'J'
import { readFileSync } from 'node:fs'
import { Vector3 } from 'three'
import { NRRDLoader } from 'three/addons/loaders/NRRDLoader.js'
console.log('three', JSON.parse(readFileSync('node_modules/three/package.json')).version)
// a block, voxels of 1 mm, and one bright voxel in it; both along right, anterior, superior
const size = [20, 24, 28], bright = [16, 5, 22], truth = bright.map((p, k) => p - (size[k] - 1) / 2)
const spaces = { 'left-posterior-superior': [-1, -1, 1], 'right-anterior-superior': [1, 1, 1], 'left-anterior-superior': [-1, 1, 1] }
function scan(space, directions) {
  const ras = directions.map(d => d.map((v, k) => v * spaces[space][k])), axis = ras.map(d => d.findIndex(v => v !== 0))
  const sizes = axis.map(a => size[a]), ijk = axis.map((a, n) => ras[n][a] > 0 ? bright[a] : size[a] - 1 - bright[a])
  const header = ['NRRD0004', 'type: uchar', 'dimension: 3', `space: ${space}`, `sizes: ${sizes.join(' ')}`,
    `space directions: ${directions.map(d => `(${d})`).join(' ')}`, 'kinds: domain domain domain', 'encoding: raw', '', ''].join('\n')
  const bytes = new Uint8Array(header.length + sizes[0] * sizes[1] * sizes[2])
  bytes.set(Buffer.from(header))
  bytes[header.length + (ijk[2] * sizes[1] + ijk[1]) * sizes[0] + ijk[0]] = 255
  return { bytes, ijk, sizes }
}
function look(name, space, directions) {
  const { bytes, ijk, sizes } = scan(space, directions), volume = new NRRDLoader().parse(bytes.buffer)
  const byMatrix = new Vector3(...ijk.map((q, k) => q - (sizes[k] - 1) / 2)).applyMatrix4(volume.matrix).toArray()
  // where the slices show it: row 0 of a slice's picture is the top of its plane, as VolumeSlice lays it on
  const bySlice = ['x', 'y', 'z'].map((axis, k) => {
    for (let n = 0; n < size[k]; ++n) {
      const p = volume.extractPerpendicularPlane(axis, n)
      for (let j = 0; j < p.jLength; ++j) for (let i = 0; i < p.iLength; ++i) if (volume.data[p.sliceAccess(i, j)] === 255) {
        return new Vector3(((i + 0.5) / p.iLength - 0.5) * p.planeWidth, (0.5 - (j + 0.5) / p.jLength) * p.planeHeight, 0).applyMatrix4(p.matrix)
          .toArray().map(v => Math.round(v * 100) / 100)
      }
    }
  })
  console.log(`${name}, ${space}: by the matrix ${byMatrix}; in slices x ${bySlice[0]}; y ${bySlice[1]}; z ${bySlice[2]}`)
  return [byMatrix, ...bySlice].join(' ')
}
console.log('the voxel is at', truth.join(), 'from the middle (right, anterior, superior)')
const lps = 'left-posterior-superior', all = (...p) => Array(4).fill(p).join(' ')
const axial = look('axial', lps, [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
const sagittal = look('sagittal', lps, [[0, 1, 0], [0, 0, -1], [-1, 0, 0]])
const coronal = look('coronal', lps, [[1, 0, 0], [0, 0, -1], [0, 1, 0]])
const axialRas = look('axial', 'right-anterior-superior', [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
const sagittalRas = look('sagittal', 'right-anterior-superior', [[0, -1, 0], [0, 0, -1], [1, 0, 0]])
const axialLas = look('axial', 'left-anterior-superior', [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
const [r, a, s] = truth
process.exit(axial === all(r, a, s) && axialRas === all(r, a, s) && axialLas === all(-r, a, -s) &&
  sagittal === [[-r, a, -s], [-r - 2, a, -s], [-r, a - 2, -s], [-r, a, -s + 4]].join(' ') &&
  sagittalRas === [[r, a, s], [r - 2, a, s], [r, a - 2, s], [r, a, s + 4]].join(' ') &&
  coronal === [[r, -a, -s], [r, -a, -s], [r, -a - 2, -s], [r, -a, -s + 2]].join(' ') ? 0 : 1)
J
node scan.mjs
