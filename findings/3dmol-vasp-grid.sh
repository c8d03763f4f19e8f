#!/bin/sh
# 3dmol 2.5.5 (npm): a density read from a CHGCAR (VolumeData, format 'vasp') does not lie where its atoms are, though both come from one text. VASP
# writes x as the fastest index (NGXF first); VolumeData.vasp() keeps the numbers in that order, while getIndex() and the isosurface take z as the
# fastest. With equal counts x and z change places, a mirror image; with unequal ones the grid is scrambled. If the cell's axes are along x, y, z,
# moreover, `unit`, the step of the grid, is the whole edge of the cell in bohr: it is taken before the vectors are divided by the counts and by
# 1.89; for other cells a matrix is made later of the right vectors. A ball of charge about an atom is drawn 4.8 from it in a skew cell, and in a
# cubic one, with 48 steps to an edge of 6, 505 from it and 91 times as wide. The documentation lists 'vasp' as a format and names no limit,
# and nothing is said. A ball in the middle of a skew cell with equal counts, and any crystal with x and z alike, look right. The same density as
# a cube file is right.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts 3dmol@2.5.5
cat > ball.cjs <<'J'
// the build asks for a browser when it is loaded; here a stand-in that answers to everything and does nothing
const nothing = new Proxy(function () {}, {
  get: (t, key) => key === Symbol.toPrimitive ? () => '' : nothing, apply: () => nothing, construct: () => nothing, set: () => true })
globalThis.window = globalThis.self = globalThis
globalThis.document = nothing
Object.defineProperty(globalThis, 'navigator', { value: { userAgent: '' }, configurable: true })
const { VolumeData, GLShape, Parsers } = require('3dmol')
console.log('3dmol', require('3dmol/package.json').version)

const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
const at = (cell, f) => [0, 1, 2].map(c => cell[0][c] * f[0] + cell[1][c] * f[1] + cell[2][c] * f[2])
const away = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])
const rows = numbers => {
  const lines = []
  for (let i = 0; i < numbers.length; i += 5) lines.push(' ' + numbers.slice(i, i + 5).map(x => x.toExponential(10)).join(' '))
  return lines.join('\n')
}
const bohr = 0.52917721

// CHGCAR: density times volume, x fastest, then y, then z
function chgcar(cell, n, atom, density) {
  const c = cross(cell[1], cell[2]), volume = Math.abs(cell[0][0] * c[0] + cell[0][1] * c[1] + cell[0][2] * c[2]), numbers = []
  for (let k = 0; k < n[2]; ++k) for (let j = 0; j < n[1]; ++j) for (let i = 0; i < n[0]; ++i)
    numbers.push(volume * density([i / n[0], j / n[1], k / n[2]]))
  return `ball\n 1.0\n${cell.map(v => ' ' + v.map(x => x.toFixed(8)).join(' ')).join('\n')}\n He\n 1\nDirect\n ${atom.join(' ')}\n\n ` +
    `${n.join(' ')}\n${rows(numbers)}\n`
}

// cube: z fastest, lengths in bohr
function cube(cell, n, atom, density) {
  const numbers = [], place = at(cell, atom).map(x => (x / bohr).toFixed(8)).join(' ')
  for (let i = 0; i < n[0]; ++i) for (let j = 0; j < n[1]; ++j) for (let k = 0; k < n[2]; ++k)
    numbers.push(density([i / n[0], j / n[1], k / n[2]]))
  return `ball\nball\n 1 0 0 0\n${cell.map((v, r) => ` ${n[r]} ` + v.map(x => (x / n[r] / bohr).toFixed(8)).join(' ')).join('\n')}\n` +
    ` 2 2.0 ${place}\n${rows(numbers)}\n`
}

// what is drawn of the part above half of the maximum: middle and mean distance from the middle
function drawn(volume) {
  let top = -Infinity
  for (const x of volume.data) if (x > top) top = x
  const shape = new GLShape({})
  shape.addIsosurface(volume, { isoval: top / 2, smoothness: 0 })
  const points = []
  for (const group of shape.geo.geometryGroups)
    for (let i = 0; i < group.vertices; ++i) points.push([0, 1, 2].map(k => group.vertexArray[3 * i + k]))
  const middle = [0, 1, 2].map(k => points.reduce((sum, p) => sum + p[k], 0) / points.length)
  return { middle, radius: points.reduce((sum, p) => sum + away(p, middle), 0) / points.length }
}

const width = 0.6, ball = (cell, atom) => f => Math.exp(-(away(at(cell, f), at(cell, atom)) ** 2) / (2 * width * width))
const trueRadius = width * Math.sqrt(2 * Math.log(2))
const cubic = [[6, 0, 0], [0, 6, 0], [0, 0, 6]], skew = [[6, 0, 0], [0, 6, 0], [-1.5, 0, 6]]
const one = [0.25, 0.5, 0.75], middle = [0.5, 0.5, 0.5]
const show = v => v.map(x => x.toFixed(2)).join(', ')
let good = true
for (const [name, cell, n, atom, format, right, distance, radius] of [
  ['cubic, cube file', cubic, [48, 48, 48], one, 'cube', true],
  ['skew, cube file', skew, [40, 48, 60], one, 'cube', true],
  ['skew, CHGCAR, equal counts, atom in the middle', skew, [48, 48, 48], middle, 'vasp', true],
  ['skew, CHGCAR, equal counts', skew, [48, 48, 48], one, 'vasp', false, 4.8, 0.65],
  ['skew, CHGCAR, unequal counts', skew, [40, 48, 60], one, 'vasp', false, 3.64, 2.35],
  ['cubic, CHGCAR, atom in the middle', cubic, [48, 48, 48], middle, 'vasp', false, 466.13, 59.2],
  ['cubic, CHGCAR', cubic, [48, 48, 48], one, 'vasp', false, 505.1, 59.2]]) {
  const text = (format === 'cube' ? cube : chgcar)(cell, n, atom, ball(cell, atom))
  const a = Parsers[format](text, {})[0][0], place = [a.x, a.y, a.z], volume = new VolumeData(text, format), seen = drawn(volume)
  const d = away(seen.middle, place)
  console.log(`${name}: atom at ${show(place)}, ball at ${show(seen.middle)}, ${d.toFixed(2)} away, radius ${seen.radius.toFixed(2)}`,
    `(right ${trueRadius.toFixed(2)}), matrix ${volume.matrix ? 'yes' : 'no'}, unit ${show([volume.unit.x, volume.unit.y, volume.unit.z])}`)
  good &&= away(place, at(cell, atom)) < 0.001 && (right ? d < 0.02 && Math.abs(seen.radius - trueRadius) < 0.1
    : Math.abs(d / distance - 1) < 0.03 && Math.abs(seen.radius / radius - 1) < 0.03)
}
process.exit(good ? 0 : 1)
J
node ball.cjs
