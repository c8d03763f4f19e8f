#!/bin/sh
# @itwin/core-geometry 5.13.3 (npm): PolyfaceQuery.computePrincipalVolumeMoments() puts the centroid of a closed mesh at the true centroid plus the
# mesh's first vertex. A box from (10,20,30) to (11,22,33) has its 'centroid' at (20.5,41,61.5); moved by t, a solid's centroid moves by 2 t.
# Cause: PolygonOps.addSecondMomentTransformedProducts() takes vectors from the given origin, but for volumes places them at that origin instead
# of 0, so that the products are about the world's zero; inertiaProductsToPrincipalAxes() believes them to be about the first vertex and adds it.
# sumFacetSecondVolumeMomentProducts(), which takes an origin, gives the same for each. Where the first vertex is at zero, as in a box that starts
# there, nothing shows. Volume, radii of gyration and axes are right, and so is the centroid of the surface, computePrincipalAreaMoments().
# The documentation says that the map's origin is the centroid if the mesh is closed, which isPolyfaceClosedByEdgePairing() confirms here.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @itwin/core-geometry@5.13.3 @itwin/core-bentley@5.13.3
cat > centroid.cjs <<'J'
const { readFileSync } = require('fs')
const { Angle, AngleSweep, Box, Matrix3d, Point3d, PolyfaceBuilder, PolyfaceQuery, Range3d, Sphere, StrokeOptions, TorusPipe, Transform,
  Vector3d } = require('@itwin/core-geometry')
console.log('@itwin/core-geometry', JSON.parse(readFileSync('node_modules/@itwin/core-geometry/package.json')).version)
function mesh(solid) {
  const options = StrokeOptions.createForFacets()
  options.angleTol = Angle.createDegrees(10)
  const builder = PolyfaceBuilder.create(options)
  builder.addGeometryQuery(solid)
  return builder.claimPolyface()
}
// by hand: tetrahedra from zero to the triangles of each facet
function byHand(polyface) {
  let volume = 0, sum = [0, 0, 0]
  const facet = polyface.createVisitor(0)
  while (facet.moveToNextFacet()) for (let i = 2; i < facet.point.length; ++i) {
    const [a, b, c] = [0, i - 1, i].map(k => facet.point.getPoint3dAtUncheckedPointIndex(k))
    const v = (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6
    volume += v
    sum = [sum[0] + v * (a.x + b.x + c.x) / 4, sum[1] + v * (a.y + b.y + c.y) / 4, sum[2] + v * (a.z + b.z + c.z) / 4]
  }
  return { volume, centroid: Point3d.create(...sum.map(s => s / volume)) }
}
const show = p => '(' + p.toArray().map(v => (Math.abs(v) < 5e-4 ? 0 : v).toFixed(3)).join(', ') + ')'
const turned = Transform.createOriginAndMatrix(Point3d.create(-7, 4, 9), Matrix3d.createRotationAroundVector(Vector3d.create(1, 2, 3), Angle.createDegrees(70)))
const ball = () => Sphere.createEllipsoid(Transform.createOriginAndMatrix(Point3d.create(1, 2, 3), Matrix3d.createScale(1, 2, 3)), AngleSweep.createFullLatitude(), true)
const solids = [
  ['box that starts at zero', Box.createRange(Range3d.createXYZXYZ(0, 0, 0, 1, 2, 3), true)],
  ['the same box, moved', Box.createRange(Range3d.createXYZXYZ(10, 20, 30, 11, 22, 33), true)],
  ['ellipsoid about (1,2,3)', ball()],
  ['the same ellipsoid, turned and moved', ball().cloneTransformed(turned)],
  ['quarter of a torus', TorusPipe.createInFrame(Transform.createIdentity(), 3, 1, Angle.createDegrees(90), true)]]
let good = true, radii = []
for (const [name, solid] of solids) {
  const polyface = mesh(solid), hand = byHand(polyface), first = polyface.data.getPoint(0)
  const moments = PolyfaceQuery.computePrincipalVolumeMoments(polyface), centroid = moments.localToWorldMap.getOrigin()
  const surface = PolyfaceQuery.computePrincipalAreaMoments(polyface).localToWorldMap.getOrigin()
  const closed = PolyfaceQuery.isPolyfaceClosedByEdgePairing(polyface)
  console.log(`${name}: closed ${closed}, volume ${moments.absoluteQuantity.toFixed(3)} (by hand ${hand.volume.toFixed(3)}), centroid ${show(centroid)}`,
    `for ${show(hand.centroid)}; first vertex ${show(first)}; of the surface ${show(surface)}`)
  radii.push(moments.radiusOfGyration)
  good &&= closed && Math.abs(moments.absoluteQuantity - hand.volume) < 1e-9 * hand.volume && moments.origin.distance(centroid) < 1e-12 &&
    centroid.distance(hand.centroid.plus(first)) < 1e-8 && (name.includes('quarter') || surface.distance(hand.centroid) < 1e-6)
}
const [box, moved, still, spun] = radii
good &&= box.distance(moved) < 1e-9 && still.distance(spun) < 1e-6 && box.distance(Vector3d.create(Math.sqrt(5 / 12), Math.sqrt(10 / 12), Math.sqrt(13 / 12))) < 1e-9
// the products should change with the origin they are taken about
const sums = [0, 100].map(x => PolyfaceQuery.sumFacetSecondVolumeMomentProducts(mesh(ball()), Point3d.create(x, 0, 0)).atIJ(0, 3))
console.log(`sum of x over the ellipsoid about x = 0: ${sums[0].toFixed(3)}, about x = 100: ${sums[1].toFixed(3)}`)
good &&= Math.abs(sums[0] - sums[1]) < 1e-6
// moved by t, the centroid moves by 2 t
const t = Vector3d.create(5, -3, 8), at = p => PolyfaceQuery.computePrincipalVolumeMoments(p).localToWorldMap.getOrigin()
const polyface = mesh(ball()), shifted = polyface.cloneTransformed(Transform.createTranslation(t)), shift = Vector3d.createStartEnd(at(polyface), at(shifted))
console.log(`the ellipsoid moved by ${show(t)}: its centroid moves by ${show(shift)}`)
good &&= shift.distance(t.scale(2)) < 1e-8
process.exit(good ? 0 : 1)
J
node centroid.cjs
