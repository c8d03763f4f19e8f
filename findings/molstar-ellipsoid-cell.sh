#!/bin/sh
# molstar 5.11.0 (npm): the displacement ellipsoids of atoms of a small-molecule CIF are right only if the cell has right angles. In the core CIF
# U_ij belongs to the cell's own axes (exp(-2 pi^2 sum U_ij h_i h_j a*_i a*_j)), in files of the PDB to x, y, z. Coordinates are taken from the cell
# to x, y, z (cif-core.js), but atomSiteAnisotropFromCifCore() hands U on as it is, and createEllipsoidMesh() takes the eigenvectors of it in x, y, z.
# An atom that moves alike in all directions has U12 = U/2 in a hexagonal cell and should be a ball; it is drawn 1.73 times as long as broad. Axes
# at 110 degrees (monoclinic) make it 1.43, and on a threefold axis the ellipsoid has lost the threefold symmetry. The extent along x, y and z of
# the ball is right all the same. In cells with right angles a ball and three different axes are drawn rightly. Besides, the factor 1.5958 in
# createEllipsoidMesh() is for 53 % and not, as is said there, for 50 %, which is 1.5382: it is the mean of the distance, not the median. Nothing is
# said of either.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts --legacy-peer-deps molstar@5.11.0
cat > ellipsoid.cjs <<'J'
const { CIF } = require('molstar/lib/commonjs/mol-io/reader/cif.js')
const { trajectoryFromCifCore } = require('molstar/lib/commonjs/mol-model-formats/structure/cif-core.js')
const { ModelSymmetry } = require('molstar/lib/commonjs/mol-model-formats/structure/property/symmetry.js')
const { Structure } = require('molstar/lib/commonjs/mol-model/structure.js')
const { createEllipsoidMesh } = require('molstar/lib/commonjs/mol-repr/structure/visual/ellipsoid-mesh.js')
console.log('molstar', require('molstar/package.json').version)
const near = (x, y, by = 0.003) => Math.abs(x - y) <= by
const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
const times = (m, v) => m.map(row => dot(row, v))

// one atom: the directions from its centre to the points of the ellipsoid that molstar draws, and the cell (columns a, b, c in x, y, z)
async function drawn(cell, u) {
  const text = `data_one
_cell_length_a ${cell[0]}
_cell_length_b ${cell[1]}
_cell_length_c ${cell[2]}
_cell_angle_alpha ${cell[3]}
_cell_angle_beta ${cell[4]}
_cell_angle_gamma ${cell[5]}
_space_group_IT_number 1
_space_group_name_H-M_alt 'P 1'
loop_
_atom_site_label
_atom_site_type_symbol
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
Zn1 Zn 0.25 0.25 0.25
loop_
_atom_site_aniso_label
_atom_site_aniso_U_11
_atom_site_aniso_U_22
_atom_site_aniso_U_33
_atom_site_aniso_U_12
_atom_site_aniso_U_13
_atom_site_aniso_U_23
Zn1 ${u.join(' ')}
`
  const file = await CIF.parseText(text).run()
  const model = (await trajectoryFromCifCore(file.result.blocks[0]).run()).representative
  const structure = Structure.ofModel(model), unit = structure.units[0]
  const props = { detail: 3, sizeFactor: 1, ignoreHydrogens: false, ignoreHydrogensVariant: 'all', traceOnly: false }
  const mesh = createEllipsoidMesh({}, unit, structure, {}, props)
  const at = unit.conformation.invariantPosition(unit.elements[0], [0, 0, 0]), v = mesh.vertexBuffer.ref.value, points = []
  for (let i = 0; i < mesh.vertexCount; ++i) points.push([0, 1, 2].map(k => v[3 * i + k] - at[k]))
  const m = ModelSymmetry.Provider.get(model).spacegroup.cell.fromFractional
  return { points, m: [0, 1, 2].map(r => [0, 1, 2].map(c => m[4 * c + r])) }
}

// U in x, y, z after the core CIF: M U M', where M has the cell's axes, each multiplied by the length of its reciprocal one
function cartesian(m, u) {
  const axis = [0, 1, 2].map(c => m.map(row => row[c]))
  const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
  const volume = dot(axis[0], cross(axis[1], axis[2]))
  const star = [0, 1, 2].map(i => Math.hypot(...cross(axis[(i + 1) % 3], axis[(i + 2) % 3])) / volume)
  const full = [[u[0], u[3], u[4]], [u[3], u[1], u[5]], [u[4], u[5], u[2]]]
  return [0, 1, 2].map(r => [0, 1, 2].map(c => {
    let sum = 0
    for (let i = 0; i < 3; ++i) for (let j = 0; j < 3; ++j) sum += m[r][i] * star[i] * full[i][j] * star[j] * m[c][j]
    return sum
  }))
}

async function main() {
  let good = true
  const c110 = Math.cos(110 * Math.PI / 180), u = 0.04
  const cases = [
    // cell, U, is the tensor right, ratio of the longest and the shortest half axis that is drawn, the ratio that is right
    ['right angles, three different axes', [6, 7, 8, 90, 90, 90], [0.09, 0.04, 0.01, 0, 0, 0], true, 3, 3],
    ['right angles, alike in all directions', [6, 7, 8, 90, 90, 90], [u, u, u, 0, 0, 0], true, 1, 1],
    ['hexagonal, alike in all directions', [3, 3, 5, 90, 90, 120], [u, u, u, u / 2, 0, 0], false, 1.732, 1],
    ['monoclinic, alike in all directions', [6, 8, 7, 90, 110, 90], [u, u, u, 0, -u * c110, 0], false, 1.428, 1],
    ['hexagonal, on the threefold axis', [3, 3, 5, 90, 90, 120], [0.01, 0.01, 0.03, 0.005, 0, 0], false, 2.449, 1.732]]
  for (const [name, cell, tensor, right, ratio, trueRatio] of cases) {
    const { points, m } = await drawn(cell, tensor), w = cartesian(m, tensor)
    const lengths = points.map(p => Math.hypot(...p)), low = Math.min(...lengths), high = Math.max(...lengths)
    // half axes of the true ellipsoid, per unit of the factor: on a fine ball of directions s, the length of L s, where L L' = U
    const l = [[Math.sqrt(w[0][0]), 0, 0], [0, 0, 0], [0, 0, 0]]
    l[1][0] = w[1][0] / l[0][0]; l[1][1] = Math.sqrt(w[1][1] - l[1][0] ** 2)
    l[2][0] = w[2][0] / l[0][0]; l[2][1] = (w[2][1] - l[2][0] * l[1][0]) / l[1][1]; l[2][2] = Math.sqrt(w[2][2] - l[2][0] ** 2 - l[2][1] ** 2)
    let trueLow = Infinity, trueHigh = 0
    for (let i = 0; i <= 60; ++i) for (let j = 0; j < 120; ++j) {
      const a = Math.PI * i / 60, b = Math.PI * j / 60, r = Math.hypot(...times(l, [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)]))
      trueLow = Math.min(trueLow, r); trueHigh = Math.max(trueHigh, r)
    }
    const extent = [0, 1, 2].map(k => Math.max(...points.map(p => p[k])))
    console.log(`${name}: half axes from ${low.toFixed(3)} to ${high.toFixed(3)}, ratio ${(high / low).toFixed(3)};`,
      `right is ${(trueHigh / trueLow).toFixed(3)}; extent along x, y, z ${extent.map(v => v.toFixed(3)).join(', ')}`)
    good &&= near(high / low, ratio, 0.02) && near(trueHigh / trueLow, trueRatio, 0.005) && right === near(high / low, trueHigh / trueLow, 0.02)
    if (right && ratio === 1) {
      const factor = high / Math.sqrt(u)
      // share of a normal distribution in space within `factor` standard deviations, by Simpson's rule
      const density = r => Math.sqrt(2 / Math.PI) * r * r * Math.exp(-r * r / 2), share = r => {
        let sum = 0
        for (let i = 0; i <= 400; ++i) sum += density(r * i / 400) * (i === 0 || i === 400 ? 1 : i % 2 ? 4 : 2)
        return sum * r / 1200
      }
      console.log(`radius of this ball: ${factor.toFixed(4)} standard deviations, within which are ${(100 * share(factor)).toFixed(1)} %;`,
        `within 1.5382 are ${(100 * share(1.5382)).toFixed(1)} %`)
      good &&= near(factor, 1.5958, 0.001) && near(share(factor), 0.533, 0.001) && near(share(1.5382), 0.5, 0.0005)
    }
  }
  process.exit(good ? 0 : 1)
}
main()
J
node ellipsoid.cjs
