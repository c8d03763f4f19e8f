#!/bin/sh
# @niivue/niivue 0.69.0 (npm, a viewer of medical images): getDescriptives({ drawingIsMask: true }), the statistics of what one has drawn, are those
# of other voxels unless the file's voxels run to the right, to the front and up (RAS). A drawing is kept in that order (loadDrawing() turns it,
# the pen and the flood fill use it), the image in the order of its file; getDescriptives() masks img[i] with drawBitmap[i] as they stand. Of
# an image stored as LAS, as FSL's templates are, one gets the mean of the other side: of a lesion's mirror image. Of slices taken sagittally
# the voxels are scattered. The number of voxels and the volume are right, the drawing is shown in its place, in a symmetric head the mean
# is plausible, and the same mask given as an overlay (masks: [1]) has the right figures. Nothing is said. drawOtsu() had the same fault and
# was mended in April 2026 (pull request 1583 of niivue); the statistics are not mentioned there.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @niivue/niivue@0.69.0
cat > drawing.mjs <<'J'
import { readFileSync } from 'node:fs'
// A page and a WebGL context that take every call and do nothing: only what is shown needs them, not the figures.
const nothing = over => new Proxy(function () {}, { apply: () => nothing(), construct: () => nothing(), set: () => true,
  get: (_, k) => over && k in over ? over[k] : k === 'then' ? undefined : k === Symbol.toPrimitive ? () => 1 : nothing() })
const listen = { addEventListener() {}, removeEventListener() {} }
class Observer { observe() {} disconnect() {} }
class Picture { set src(_) { setTimeout(() => this.onload?.(), 0) } }
Object.assign(globalThis, listen, { window: globalThis, document: nothing(), location: { search: '' }, devicePixelRatio: 1, Image: Picture,
  requestAnimationFrame: () => 0, ResizeObserver: Observer, MutationObserver: Observer, matchMedia: () => ({ matches: false, ...listen }) })
globalThis.navigator ??= { userAgent: '', platform: '', maxTouchPoints: 0 }
const gl = nothing({ getParameter: () => 4096, isContextLost: () => false })
const page = { style: {}, width: 64, height: 64, clientWidth: 64, clientHeight: 64, offsetWidth: 64, offsetHeight: 64, ...listen,
  getBoundingClientRect: () => ({ left: 0, top: 0, width: 64, height: 64 }) }
const canvas = nothing({ ...page, getContext: () => gl, parentElement: nothing(page) })
const { Niivue, NVImage } = await import('@niivue/niivue')
console.log('@niivue/niivue', JSON.parse(readFileSync('node_modules/@niivue/niivue/package.json')).version)

// The same head, 12 x 8 x 6 voxels of 1 mm from left to right, back to front, feet to head, as a NIfTI file in any order of storage.
const size = [12, 8, 6]
function nifti(order, type, value) {
  const axis = [...order].map(c => 'LRPAIS'.indexOf(c) >> 1), up = [...order].map(c => 'RAS'.includes(c)), n = axis.map(a => size[a])
  const bytes = type === 2 ? 1 : 2, v = new DataView(new ArrayBuffer(352 + bytes * n[0] * n[1] * n[2]))
  const shorts = (at, ...list) => list.forEach((x, i) => v.setInt16(at + 2 * i, x, true))
  const floats = (at, ...list) => list.forEach((x, i) => v.setFloat32(at + 4 * i, x, true))
  v.setInt32(0, 348, true)
  shorts(40, 3, ...n, 1)
  shorts(70, type, 8 * bytes)
  floats(76, 1, 1, 1, 1)
  floats(108, 352, 1)
  shorts(252, 0, 1)
  for (let d = 0; d < 3; ++d) { // sform: row d is the world's axis d
    const k = axis.indexOf(d), row = [0, 0, 0, up[k] ? 0 : size[d] - 1]
    row[k] = up[k] ? 1 : -1
    floats(280 + 16 * d, ...row)
  }
  v.setInt32(344, 0x312b6e, true)
  for (let k = 0, at = 352; k < n[2]; ++k) for (let j = 0; j < n[1]; ++j) for (let i = 0; i < n[0]; ++i, at += bytes) {
    const x = []
    ;[i, j, k].forEach((m, q) => { x[axis[q]] = up[q] ? m : n[q] - 1 - m })
    bytes === 1 ? v.setUint8(at, value(...x)) : v.setInt16(at, value(...x), true)
  }
  return v.buffer
}
// The left half has 100, the right one 200; the drawing is a block in the left half.
const head = x => x < 6 ? 100 : 200, drawn = (x, y, z) => x >= 1 && x < 4 && y >= 2 && y < 6 && z >= 1 && z < 5 ? 1 : 0
let good = true
for (const [order, seen] of [['RAS', 100], ['LAS', 200], ['RPS', 100], ['PSR', null]]) {
  const viewer = new Niivue({ logLevel: 'silent', isResizeCanvas: false })
  await viewer.attachToCanvas(canvas)
  const image = await NVImage.loadFromUrl({ url: nifti(order, 4, head), name: 'head.nii' })
  const mask = await NVImage.loadFromUrl({ url: nifti(order, 2, drawn), name: 'drawing.nii' })
  viewer.addVolume(image)
  const loaded = viewer.loadDrawing(mask)
  const drawing = viewer.getDescriptives({ layer: 0, drawingIsMask: true })
  viewer.addVolume(mask)
  const overlay = viewer.getDescriptives({ layer: 0, masks: [1] })
  const line = d => `mean ${d.mean.toFixed(1)}, sd ${d.stdev.toFixed(1)}, ${d.min} to ${d.max}, ${d.nvox} voxels, ${d.volumeMM3} mm3`
  console.log(`${order}: as a drawing ${line(drawing)}; as an overlay ${line(overlay)}`)
  good &&= loaded && drawing.nvox === 48 && overlay.nvox === 48 && Math.abs(overlay.mean - 100) < 1e-9 && overlay.max === 100
  good &&= seen ? Math.abs(drawing.mean - seen) < 1e-9 : drawing.min === 100 && drawing.max === 200 && drawing.stdev > 40
}
process.exit(good ? 0 : 1)
J
node drawing.mjs
