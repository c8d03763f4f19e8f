#!/bin/sh
# @kitware/vtk.js 37.4.3 (npm): vtkOBBTree.intersectWithOBBTree(treeB, XformBtoA, callback) takes a matrix that moves B before the test, so that
# moving parts need no new tree. findTriangleIntersections(), the callback that gives the lines of intersection, gets it too, as its `transform`,
# but the lines are those of the parts at rest. The boxes are moved rightly (disjointOBBNodes()); where two of them meet, the triangles of B are
# taken as they lie (intersectWithTriangle()), and the test in between, triangleIntersectsNode(), moves a triangle of A by the matrix for B. A
# ball that is moved from afar onto another meets it in 0 lines, 'no collision', in place of 125, although the boxes do meet; one moved away by
# half its radius meets it in the circle where it met it before. With null all is right, as in the tests and the example, and with the parts
# moved by hand. No word in the source says that the matrix is not for this callback, and nothing is said at run time.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --no-save --ignore-scripts @kitware/vtk.js@37.4.3 gl-matrix@3.4.3
cat > trees.mjs <<'C'
import { readFileSync } from 'node:fs'
import { mat4 } from 'gl-matrix'
import PolyData from '@kitware/vtk.js/Common/DataModel/PolyData.js'
import OBBTree from '@kitware/vtk.js/Filters/General/OBBTree.js'
import TriangleFilter from '@kitware/vtk.js/Filters/General/TriangleFilter.js'
import SphereSource from '@kitware/vtk.js/Filters/Sources/SphereSource.js'
console.log('@kitware/vtk.js', JSON.parse(readFileSync('node_modules/@kitware/vtk.js/package.json')).version)
function ball(x) {
  const source = SphereSource.newInstance({ radius: 1, center: [x, 0, 0], thetaResolution: 17, phiResolution: 16 })
  const triangles = TriangleFilter.newInstance()
  triangles.setInputData(source.getOutputData())
  triangles.update()
  const tree = OBBTree.newInstance()
  tree.setDataset(triangles.getOutputData())
  tree.buildLocator()
  return tree
}
function meet(name, x, by) {
  // ball A about 0, ball B about x, moved by `by`: they meet in a circle half way
  const a = ball(0), b = ball(x), matrix = by === 0 ? null : mat4.fromTranslation(mat4.create(), [by, 0, 0])
  let boxes = 0
  a.intersectWithOBBTree(b, matrix, () => { ++boxes; return 1 })
  const found = { obbTree1: b, intersectionLines: PolyData.newInstance() }
  a.intersectWithOBBTree(b, matrix, a.findTriangleIntersections.bind(null, found))
  const points = found.intersectionLines.getPoints().getData(), lines = found.intersectionLines.getLines().getNumberOfCells()
  let middle = 0
  for (let i = 0; i < points.length; i += 3) middle += points[i] / (points.length / 3)
  console.log(`${name}: ${boxes} pairs of boxes meet, ${lines} lines${lines > 0 ? `, at x = ${middle.toFixed(3)}` : ''}`)
  return { boxes, lines, middle }
}
const near = meet('ball at 1', 1, 0), far = meet('ball at 10, moved by -9', 10, -9)
const next = meet('ball at 1.5', 1.5, 0), along = meet('ball at 1, moved by 0.5', 1, 0.5), alone = meet('ball at 10', 10, 0)
const back = meet('ball at 1.5, moved by -0.5', 1.5, -0.5)
const close = (a, b) => Math.abs(a - b) < 0.02
process.exit(near.lines > 50 && close(near.middle, 0.5) && next.lines > 30 && close(next.middle, 0.75) && alone.lines === 0 && alone.boxes === 0 &&
  Math.abs(far.boxes - near.boxes) < 5 && far.lines === 0 && Math.abs(along.boxes - next.boxes) < 5 && Math.abs(back.boxes - near.boxes) < 5 &&
  along.lines > 50 && close(along.middle, 0.5) && back.lines < 20 ? 0 : 1)
C
node trees.mjs
