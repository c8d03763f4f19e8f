#!/bin/sh
# image-js 1.7.0 (npm): the axes of roi.ellipse are wrong, and differently so as the shape turns. getEllipse() takes the axes from the moments,
# which is right, but the length of the minor one between points of both: its columns from a minor and a MAJOR one, its rows from two minor ones.
# As both axes are then scaled until the area is that of the pixels, the major one is wrong as well, while `surface` is right, which hides it.
# An ellipse of 60 x 20 pixels is 45 x 27 lying, 114 x 11 turned by 75 degrees and 85 x 14 standing; a disk is twice as long as broad. Centre
# and angle are right, and so is the ratio of the distances between the end points, whose scale is wrong too. Nothing is said. Feret diameters
# and the least rectangle (mbr) of the same pixels are right.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts image-js@1.7.0
cat > ellipse.mjs <<'J'
import { readFileSync } from 'node:fs'
import { Mask, fromMask } from 'image-js'
console.log('image-js', JSON.parse(readFileSync('node_modules/image-js/package.json')).version)
const size = 101, middle = 50
const distance = ([p, q]) => Math.hypot(p.column - q.column, p.row - q.row)
function measure(a, b, degrees) {
  const mask = new Mask(size, size), c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180), inside = []
  for (let row = 0; row < size; ++row) for (let column = 0; column < size; ++column) {
    const x = column - middle, y = row - middle
    if (((x * c + y * s) / a) ** 2 + ((y * c - x * s) / b) ** 2 > 1) continue
    mask.setBit(column, row, 1)
    inside.push([x, y])
  }
  const roi = fromMask(mask).getRois()[0], e = roi.ellipse
  // the same by hand: an ellipse's axes are four times the roots of the moments about its centre, here as area demands
  const m = (i, j) => inside.reduce((sum, p) => sum + p[i] * p[j], 0) / inside.length
  const mean = (m(0, 0) + m(1, 1)) / 2, half = Math.hypot((m(0, 0) - m(1, 1)) / 2, m(0, 1))
  const own = [4 * Math.sqrt(mean + half), 4 * Math.sqrt(mean - half)]
  const got = [e.majorAxis.length, e.minorAxis.length]
  const show = list => list.map(x => x.toFixed(1)).join(' x ')
  console.log(`${2 * a} x ${2 * b} turned by ${degrees}: axes ${show(got)}, by hand ${show(own)};`,
    `end points ${show([distance(e.majorAxis.points), distance(e.minorAxis.points)])} apart; mbr ${show([roi.mbr.width, roi.mbr.height])};`,
    `surface ${e.surface.toFixed(0)} of ${roi.surface}`)
  return { own, got, ends: distance(e.majorAxis.points) / distance(e.minorAxis.points), surface: e.surface / inside.length }
}
const near = (x, y, by) => Math.abs(x - y) <= by
let good = true
for (const [degrees, major, minor] of [[0, 44.7, 26.7], [30, 45.2, 26.7], [60, 78.1, 15.4], [75, 114.3, 10.5], [90, 85.4, 13.9]]) {
  const r = measure(30, 10, degrees)
  good &&= near(r.got[0], major, 0.1) && near(r.got[1], minor, 0.1) && near(r.own[0], 60, 0.6) && near(r.own[1], 20, 0.6) &&
    near(r.ends, 3, 0.06) && near(r.surface, 1, 1e-6)
}
const disk = measure(20, 20, 0)
good &&= near(disk.got[0] / disk.got[1], 2, 0.3) && near(disk.own[0] / disk.own[1], 1, 1e-6)
process.exit(good ? 0 : 1)
J
node ellipse.mjs
