#!/bin/sh
# @turf/directional-mean 7.4.0 (npm): a mean direction in the western half comes back reversed. getAngleBySinAndCos() takes atan2(), which knows all
# four quadrants, and then adds or takes off 180 degrees where the cosine is negative, as one has to after atan(). Two lines that run to the
# north-west have a cartesianAngle of 315 (south-east) and a bearingAngle of -225, outside the range of bearings, and the line that is returned
# runs from the end to the beginning. Due south comes back as north. circularVariance is right, 0 here, so that all seems well; so are directions
# in the eastern half, with which one tries it. The README has 'the mean angle of all lines' and nothing of half turns, and the
# sign does count: opposite lines cancel. The course that all lines share, and @turf/bearing, are the measure here.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @turf/directional-mean@7.4.0 @turf/bearing@7.4.0 @turf/helpers@7.4.0
cat > mean.mjs <<'J'
import { readFileSync } from 'node:fs'
import { directionalMean } from '@turf/directional-mean'
import { bearing } from '@turf/bearing'
import { featureCollection, lineString } from '@turf/helpers'
console.log('@turf/directional-mean', JSON.parse(readFileSync('node_modules/@turf/directional-mean/package.json')).version)
const apart = (a, b) => Math.abs(((a - b) % 360 + 540) % 360 - 180)
let good = true
for (const planar of [true, false]) for (let course = 15; course < 360; course += 45) {
  const r = course * Math.PI / 180, step = [0.1 * Math.cos(r), 0.1 * Math.sin(r)]
  // two lines of the same course side by side; their mean can be nothing but that course
  const ways = [[0, 0], [0.05, 0.02]].map(([x, y]) => [[x, y], [x + step[0], y + step[1]]])
  const mean = directionalMean(featureCollection(ways.map(way => lineString(way))), { planar }), p = mean.properties
  const [from, to] = mean.geometry.coordinates, own = bearing(...ways[0])
  const line = apart(bearing(from, to), own), angle = apart(p.cartesianAngle, course)
  console.log(`${planar ? 'planar' : 'geographical'}, course ${course}: cartesianAngle ${p.cartesianAngle.toFixed(1)}, bearingAngle`,
    `${p.bearingAngle.toFixed(1)} for ${own.toFixed(1)}; the mean line is ${line.toFixed(0)} degrees off; variance ${Math.abs(p.circularVariance).toFixed(3)}`)
  const want = course > 90 && course < 270 ? 180 : 0
  good &&= Math.abs(line - want) < 0.1 && Math.abs(angle - want) < 0.1 && apart(p.bearingAngle, own + want) < 0.1 && Math.abs(p.circularVariance) < 1e-3
}
process.exit(good ? 0 : 1)
J
node mean.mjs
