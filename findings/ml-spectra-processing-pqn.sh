#!/bin/sh
# ml-spectra-processing 14.35.1 (npm): matrixPQN(), 'probabilistic quotient normalization' after Dieterle et al. 2006 'to account dilution', corrects no
# dilution. The method takes the quotients of a sample, a row, with the median spectrum and divides the sample by their median. matrixPQN() takes
# the quotients by columns: a column over its own median, whose median is 1, always. Then it divides row i by the figure of column i. What is left is
# the first step, each row scaled to a norm of 100, against which the method was made: a sample with one strong peak, otherwise like the
# others, comes out with the rest 6 times lower, as if diluted; differences of groups are found where there are none. medianOfQuotients is nothing
# but ones, which looks like samples that need no correction. With more rows than columns the rows beyond are NaN, and so is a row whose column of the
# same number has median 0. Dilutions of one and the same sample come out alike, so that a simple test passes. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts ml-spectra-processing@14.35.1
cat > dilution.mjs <<'J'
import { readFileSync } from 'node:fs'
import { matrixPQN } from 'ml-spectra-processing'
console.log('ml-spectra-processing', JSON.parse(readFileSync('node_modules/ml-spectra-processing/package.json')).version)
const median = values => {
  const sorted = [...values].sort((a, b) => a - b), half = sorted.length >> 1
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2
}
const scaled = row => { const norm = Math.hypot(...row); return row.map(v => 100 * v / norm) }
const column = (rows, k) => rows.map(row => row[k])
// The method as published, after the same scaling of the rows.
const published = rows => {
  const start = rows.map(scaled), reference = start[0].map((_, k) => median(column(start, k)))
  const factors = start.map(row => median(row.map((v, k) => v / reference[k])))
  return { data: start.map((row, i) => row.map(v => v / factors[i])), factors }
}
const far = (a, b) => Math.max(...a.flatMap((row, i) => row.map((v, k) => Math.abs(v - b[i][k]) / Math.abs(b[i][k]))))
const show = row => row.map(v => v.toFixed(2)).join(' ')
let good = true

const sample = [1, 2, 3, 4, 5, 6, 7, 8, 9], peak = sample.map((v, k) => k === 4 ? v + 100 : v)
const diluted = [1, 2, 0.5, 3].map(f => sample.map(v => f * v))
const plain = matrixPQN(diluted), mixed = matrixPQN([...diluted, peak]), right = published([...diluted, peak])
console.log('four dilutions of one sample differ by', far(plain.data, diluted.map(() => plain.data[0])).toExponential(0))
console.log('one of them, with a fifth sample that has a peak more:', show(mixed.data[0]))
console.log('the fifth:', show(mixed.data[4]), '; medianOfQuotients', mixed.medianOfQuotients.join(' '))
console.log('the fifth, by rows:', show(right.data[4]), '; medians of the quotients', right.factors.map(v => v.toFixed(3)).join(' '))
good &&= far(plain.data, diluted.map(() => plain.data[0])) < 1e-12 && Math.abs(mixed.data[0][0] / mixed.data[4][0] - 6.3) < 0.05 &&
  right.data[4].every((v, k) => k === 4 || Math.abs(v / right.data[0][k] - 1) < 1e-12)

let seed = 1
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647
// 20 samples of 200 variables, each with its own dilution and 10 % of noise; the last 10 have ten peaks more
const truth = Array.from({ length: 200 }, () => 1 + 9 * random()), dilution = Array.from({ length: 20 }, () => 0.3 + 3 * random())
const samples = dilution.map((d, i) => truth.map((v, k) => d * (v * (0.9 + 0.2 * random()) + (i >= 10 && k < 10 ? 60 : 0))))
const ours = matrixPQN(samples), theirs = published(samples)
const between = data => median(Array.from({ length: 190 }, (_, k) => median(column(data.slice(0, 10), k + 10)) / median(column(data.slice(10), k + 10))))
console.log(`20 samples, ten with ten peaks more: all other variables are ${between(ours.data).toFixed(2)} times as high in the first ten; by rows`,
  `${between(theirs.data).toFixed(2)}; medianOfQuotients from ${Math.min(...ours.medianOfQuotients)} to ${Math.max(...ours.medianOfQuotients)}`)
console.log('largest difference from rows scaled to 100 and no more:', far(ours.data, samples.map(scaled)).toExponential(0))
good &&= between(ours.data) > 1.5 && Math.abs(between(theirs.data) - 1) < 0.03 && far(ours.data, samples.map(scaled)) < 1e-9 &&
  ours.medianOfQuotients.length === 200 && ours.medianOfQuotients.every(v => Math.abs(v - 1) < 1e-9)
const tall = matrixPQN([[1, 2], [2, 3], [3, 1], [4, 5]]).data
console.log('four samples of two variables:', tall.map(show).join(', '))
good &&= tall.slice(0, 2).flat().every(Number.isFinite) && tall.slice(2).flat().every(Number.isNaN)
process.exit(good ? 0 : 1)
J
node dilution.mjs
