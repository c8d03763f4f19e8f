#!/bin/sh
# @loaders.gl/tiles 4.5.4 (npm, the 3D tiles and I3S of deck.gl): tile.boundingBox, the least and greatest longitude, latitude and altitude of a
# tile, is too small for tiles bounded by a sphere, such as those of I3S that have no oriented box. boundingSphereToCartographicBounds() goes by the
# radius along three axes that should be up and square to it. For an upward normal (x, y, z) the first has to be (-y, x, 0), but is (z, -y, 0), not
# square to the normal, and the second, their cross product, is shorter than 1. At longitudes 0 and 180 both are right and near the poles they are
# nearly so; on the equator the extent is that of the sphere times the cosine of the longitude, so that at 90 degrees the box is a line. A sphere
# of 1000 m reaches 1000 m to each side; its box has 726 in Berlin, 583 in Tokyo, 410 in Kolkata and 216 in Singapore. The altitudes are
# right, the centre is, and culling goes by the sphere itself. Boxes and regions have code of their own. Nothing is said: the description is
# 'bounding box in cartographic coordinates', and it was made for tiles on terrain.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts --legacy-peer-deps @loaders.gl/tiles@4.5.4 @loaders.gl/core@4.5.4 \
  @math.gl/geospatial@4.1.0
cat > sphere.mjs <<'J'
import { readFileSync } from 'node:fs'
import { Tileset3D } from '@loaders.gl/tiles'
import { Ellipsoid } from '@math.gl/geospatial'
console.log('@loaders.gl/tiles', JSON.parse(readFileSync('node_modules/@loaders.gl/tiles/package.json')).version)
const earth = Ellipsoid.WGS84, radius = 1000
// Half the extent to the east, to the north and upwards in metres, at the equator's 111320 m for a degree.
const metres = ([low, high], latitude) => [111320 * Math.cos(latitude * Math.PI / 180), 111320, 1].map((m, d) => m * (high[d] - low[d]) / 2)
async function box(bound) {
  const root = { id: 'root', type: 'empty', refine: 2, geometricError: 1, lodMetricType: 'geometricError', lodMetricValue: 1, children: [],
    boundingVolume: bound }
  const tileset = new Tileset3D({ asset: { version: '1.0' }, type: 'TILES3D', loader: { id: '3d-tiles' }, url: 'tileset.json', basePath: '',
    lodMetricType: 'geometricError', lodMetricValue: 1, root }, {})
  await tileset.tilesetInitializationPromise
  return tileset.root.boundingBox
}
let good = true
for (const [name, longitude, latitude, seen] of [['longitude 0', 0, 0, 1000], ['longitude 45', 45, 0, 708], ['longitude 90', 90, 0, 0],
  ['Singapore', 103.8, 1.35, 215], ['Kolkata', 88.36, 22.57, 410], ['Tokyo', 139.7, 35.7, 582], ['Chicago', -87.6, 41.9, 698],
  ['Berlin', 13.4, 52.5, 726], ['a degree from the pole', 0, 89, 997]]) {
  const centre = [...earth.cartographicToCartesian([longitude, latitude, 0])]
  const got = metres(await box({ sphere: [...centre, radius] }), latitude)
  // 20000 points of the sphere, evenly spread
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity]
  for (let k = 0; k < 20000; ++k) {
    const z = 1 - (2 * k + 1) / 20000, r = Math.sqrt(1 - z * z), turn = k * Math.PI * (3 - Math.sqrt(5))
    const point = earth.cartesianToCartographic([r * Math.cos(turn), r * Math.sin(turn), z].map((x, d) => centre[d] + radius * x))
    point.forEach((x, d) => { low[d] = Math.min(low[d], x); high[d] = Math.max(high[d], x) })
  }
  const right = metres([low, high], latitude), show = list => list.map(x => x.toFixed(0)).join(', ')
  console.log(`${name}: boundingBox reaches ${show(got)} m to the east, north and up; the sphere ${show(right)}`)
  good &&= Math.abs(got[0] - seen) < 4 && got[1] < seen + 8 && Math.abs(got[2] - 1000) < 2 && right.every(x => Math.abs(x - 1000) < 8)
}
// The same ball in a cube along the axes of the ground, for comparison
const cube = await box({ box: [...earth.cartographicToCartesian([90, 0, 0]), 1000, 0, 0, 0, 1000, 0, 0, 0, 1000] }), side = metres(cube, 0)
console.log(`a cube of 2000 m at longitude 90: ${side.map(x => x.toFixed(0)).join(', ')}`)
good &&= side[0] > 998 && side[1] > 998
process.exit(good ? 0 : 1)
J
node sphere.mjs
