#!/bin/sh
# @itowns/geographic 2.46.0 (npm, iTowns): a Lambert map's turn against true north is wrong unless its origin lies on its standard parallel.
# quaternionFromEnuToCRS(), FromCRSToEnu() and CRSToCRS() are 6.2 degrees off in the Canada Atlas Lambert (EPSG:3978) at St. John's, 0.27 in the
# Belgian Lambert 72 (EPSG:31370) at Liege, 0.13 in NAD83 Texas Central: a photograph or model set by them stands turned on the globe.
# Cause: quaternionFromLCCToEnu() multiplies the longitude from the central meridian by sin(lat_0), the latitude of origin. The factor is the cone's
# constant n, which proj4 keeps as ns; n = sin(lat_0) for cones of one parallel only. With two it depends on these, and lat_0 is a free choice.
# It does not show in France's Lambert 93 (EPSG:2154, 0.001 degrees), whose origin is midway, nor with one standard parallel, nor on the central
# meridian. There and back, or between two Lambert maps at once, the error is made twice. Nothing is said; the docs name the meridian convergence.
# The measure is the direction of two points on a meridian in the same projection by proj4, and the formula n (lon - lon_0).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @itowns/geographic@2.46.0 proj4@2.22.0 three@0.174.0
cat > lambert.mjs <<'J'
import { readFileSync } from 'node:fs'
import proj4 from 'proj4'
import { Vector3 } from 'three'
import { Coordinates, OrientationUtils } from '@itowns/geographic'
console.log('@itowns/geographic', JSON.parse(readFileSync('node_modules/@itowns/geographic/package.json')).version)
const degrees = 180 / Math.PI, near = (a, b, by) => Math.abs(a - b) <= by
const maps = [
  ['EPSG:3978', 'Canada Atlas Lambert, St. John\'s', '+lat_0=49 +lon_0=-95 +lat_1=49 +lat_2=77 +x_0=0 +y_0=0 +datum=NAD83', -52.71, 47.56, -6.178],
  ['EPSG:31370', 'Belgian Lambert 72, Liege', '+lat_0=90 +lon_0=4.36748666666667 +lat_1=51.1666672333333 +lat_2=49.8333339 +x_0=150000.013 +y_0=5400088.438 +ellps=intl', 5.57, 50.63, 0.275],
  ['EPSG:3034', 'LCC Europe, Dublin', '+lat_0=52 +lon_0=10 +lat_1=35 +lat_2=65 +x_0=4000000 +y_0=2800000 +ellps=GRS80', -6.26, 53.35, -0.205],
  ['EPSG:32139', 'Texas Central, Beaumont', '+lat_0=29.6666666666667 +lon_0=-100.333333333333 +lat_1=31.8833333333333 +lat_2=30.1166666666667 +x_0=700000 +y_0=3000000 +datum=NAD83', -94.1, 30.1, -0.125],
  ['EPSG:2154', 'Lambert 93, Strasbourg', '+lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80', 7.75, 48.58, -0.001],
  ['one', 'one standard parallel, Strasbourg', '+lat_0=46.5 +lon_0=3 +lat_1=46.5 +k_0=0.9998 +x_0=600000 +y_0=200000 +ellps=GRS80', 7.75, 48.58, 0],
  ['middle', 'Canada Atlas Lambert on the central meridian', '+lat_0=49 +lon_0=-95 +lat_1=49 +lat_2=77 +x_0=0 +y_0=0 +datum=NAD83', -95, 60, 0]
]
// the angle, counterclockwise in the map, by which true north is turned
const turn = q => { const north = new Vector3(0, 1, 0).applyQuaternion(q); return Math.atan2(-north.x, north.y) * degrees }
let good = true
for (const [name, words, terms, lon, lat, error] of maps) {
  proj4.defs(name, '+proj=lcc ' + terms + ' +units=m +no_defs')
  const projection = proj4(name), { ns, long0 } = projection.oProj, h = 1e-4
  const [x0, y0] = projection.forward([lon, lat - h]), [x1, y1] = projection.forward([lon, lat + h])
  const measured = Math.atan2(x0 - x1, y1 - y0) * degrees, formula = ns * (lon - long0 * degrees)
  const point = new Coordinates('EPSG:4326', lon, lat, 0)
  const to = turn(OrientationUtils.quaternionFromEnuToCRS(name, point)), from = turn(OrientationUtils.quaternionFromCRSToEnu(name, point))
  console.log(`${name} (${words}): north is turned by ${to.toFixed(4)}, measured ${measured.toFixed(4)}, n (lon - lon_0) ${formula.toFixed(4)}: off by`,
    `${(to - measured).toFixed(4)}; n ${ns.toFixed(5)}, sin(lat_0) ${Math.sin(projection.oProj.lat0).toFixed(5)}`)
  good &&= near(measured, formula, 1e-6) && near(to - measured, error, 0.002) && near(from, -to, 1e-9) &&
    near(to, Math.sin(projection.oProj.lat0) * (lon - long0 * degrees), 1e-6)
}
// from the map to the globe: the direction "up the sheet" at St. John's, carried to geocentric coordinates
const place = new Coordinates('EPSG:4326', -52.71, 47.56, 0), centre = place.as('EPSG:4978')
const sheet = new Vector3(0, 1, 0).applyQuaternion(OrientationUtils.quaternionFromCRSToCRS('EPSG:3978', 'EPSG:4978')(centre))
const map = proj4('EPSG:4326', 'EPSG:3978'), [x, y] = map.forward([-52.71, 47.56]), [lon, lat] = map.inverse([x, y + 100])
const step = new Coordinates('EPSG:4326', lon, lat, 0).as('EPSG:4978').toVector3().sub(centre.toVector3()).normalize()
const apart = sheet.angleTo(step) * degrees
console.log(`St. John's, up the sheet on the globe: ${sheet.toArray().map(v => v.toFixed(4))}, by 100 m on the map ${step.toArray().map(v => v.toFixed(4))}: ${apart.toFixed(3)} apart`)
good &&= near(apart, 6.178, 0.01)
process.exit(good ? 0 : 1)
J
node lambert.mjs
