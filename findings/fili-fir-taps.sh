#!/bin/sh
# fili 2.0.3 (npm, digital filters): FirFilter leaves out the last coefficient and takes the others but the first backwards. Coefficients 1, 2, 3, 4 answer an
# impulse with 1, 3, 2; the difference 1, 0, -1 gives the signal back as it was; a mean of four, each with a quarter, gives 3 for a signal that is always 4.
# Cause: the ring of samples has a place fewer than there are coefficients, and doStep() goes round it from the newest sample to the oldest one and on to
# newer ones, while the coefficients go from new to old. responsePoint() leaves out the last as well, but keeps the order, so that it shows neither the
# filter that was given nor the one that runs: for 1, 1/2, 1/4, 1/8, 1/16 its phase and that of what runs are up to 0.96 radians apart.
# Filters that FirCoeffs makes are symmetric with ends near 0, so that next to nothing shows with them. Differences, quadrature filters, measured impulse
# responses and minimum-phase filters are wrong. Nothing is said: a comment in the source has it that the coefficients are the impulse response.
# The measure is the sum itself, y[n] = h[0] x[n] + h[1] x[n-1] + ...; and the response its Fourier sum.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts fili@2.0.3
cat > fir.cjs <<'J'
const { FirCoeffs, FirFilter } = require('fili')
console.log('fili', require('fili/package.json').version)
const convolve = (h, x) => x.map((_, n) => h.reduce((s, c, k) => s + (n >= k ? c * x[n - k] : 0), 0))
const far = (a, b) => Math.max(...a.map((v, i) => Math.abs(v - b[i])))
const show = a => a.map(v => +v.toFixed(4)).join(' ')
// the first, then from the last but one back to the second, and no last
const asRun = h => [h[0], ...h.slice(1, -1).reverse(), 0]
function transform(h, f) {
  let re = 0, im = 0
  h.forEach((c, k) => { re += c * Math.cos(2 * Math.PI * f * k); im -= c * Math.sin(2 * Math.PI * f * k) })
  return { magnitude: Math.hypot(re, im), phase: Math.atan2(im, re) }
}
const turn = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)))
let seed = 5
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647 - 0.5
const noise = Array.from({ length: 200 }, random)
let good = true

for (const h of [[1, 2, 3, 4], [1, 0, -1], [1, -1], [0.25, 0.25, 0.25, 0.25], [0.5, 0.3, 0.2], [1, 0.5, 0.25, 0.125, 0.0625], Array.from({ length: 31 }, random)]) {
  const impulse = [1, ...Array(h.length).fill(0)], filter = new FirFilter(h), got = filter.multiStep(impulse)
  if (h.length < 9) console.log(`coefficients ${show(h)}: impulse response ${show(got)}`)
  else console.log(`${h.length} coefficients at random: impulse response off by up to ${far(got, [...h, 0]).toFixed(2)}`)
  const ran = asRun(h), single = new FirFilter(h), steps = noise.map(x => single.singleStep(x))
  good &&= far(got, [...ran, 0]) < 1e-12 && far(got, [...h, 0]) > 0.1 && far(new FirFilter(h).multiStep(noise), convolve(ran, noise)) < 1e-12 &&
    far(new FirFilter(h).simulate(noise), convolve(ran, noise)) < 1e-12 && far(steps, convolve(ran, noise)) < 1e-12
  // the response is that of the coefficients without the last
  for (const f of [0, 0.05, 0.2, 0.35]) {
    const point = filter.responsePoint({ Fs: 1, Fr: f }), cut = transform(h.slice(0, -1), f)
    good &&= Math.abs(point.magnitude - cut.magnitude) < 1e-9 && turn(point.phase, cut.phase) < 1e-6
  }
}

const square = [0, 1, 4, 9, 16, 25, 36], difference = new FirFilter([1, 0, -1]).multiStep(square)
console.log(`1, 0, -1 of the squares ${show(square)}: ${show(difference)}, for ${show(convolve([1, 0, -1], square))}`)
good &&= far(difference, square) < 1e-12
const four = Array(10).fill(4), level = new FirFilter([0.25, 0.25, 0.25, 0.25]).multiStep(four)
console.log(`mean of four, of a signal of 4: ${level[9]}; the response at 0: ${new FirFilter([0.25, 0.25, 0.25, 0.25]).responsePoint({ Fs: 1, Fr: 0 }).magnitude}`)
good &&= Math.abs(level[9] - 3) < 1e-12
// the response that is told and the filter that runs
const decay = [1, 0.5, 0.25, 0.125, 0.0625], told = new FirFilter(decay)
let apart = 0, off = 0
for (let f = 0.01; f < 0.5; f += 0.01) {
  const point = told.responsePoint({ Fs: 1, Fr: f })
  apart = Math.max(apart, turn(point.phase, transform(asRun(decay), f).phase))
  off = Math.max(off, transform(asRun(decay), f).magnitude / transform(decay, f).magnitude)
}
console.log(`${show(decay)}: phase of responsePoint() and of the filter that runs, up to ${apart.toFixed(2)} apart; gain up to ${off.toFixed(2)} times what it should be`)
good &&= apart > 0.5 && off > 1.2
// a quadrature filter, antisymmetric, makes a sine of a cosine
const hilbert = Array.from({ length: 31 }, (_, k) => (k - 15) % 2 ? 2 / Math.PI / (k - 15) * (0.54 - 0.46 * Math.cos(2 * Math.PI * k / 30)) : 0)
const wave = Array.from({ length: 200 }, (_, n) => Math.cos(0.25 * Math.PI * n)), quarter = new FirFilter(hilbert).multiStep(wave).slice(50)
const sine = wave.map((_, n) => Math.sin(0.25 * Math.PI * (n - 15))).slice(50), sum = convolve(hilbert, wave).slice(50)
console.log(`quadrature filter of a cosine: ${far(quarter, sine).toFixed(3)} from the sine, ${far(quarter, sine.map(v => -v)).toFixed(3)} from its negative;`,
  `the sum is ${far(sum, sine).toFixed(3)} from the sine`)
good &&= far(sum, sine) < 0.05 && far(quarter, sine) > 1.9 && far(quarter, sine.map(v => -v)) < 0.05
// symmetric, with ends of zero: right
const low = new FirCoeffs().lowpass({ order: 30, Fs: 1000, Fc: 110 }), lowRun = new FirFilter(low)
const zeros = [0, 1, 2, 1, 0], right = [far(lowRun.multiStep(noise), convolve(low, noise)), far(new FirFilter(zeros).multiStep(noise), convolve(zeros, noise))]
console.log(`low pass of FirCoeffs: off by ${right[0].toExponential(1)}, ends ${low[0].toExponential(1)};`,
  `coefficients ${show(zeros)}: off by ${right[1].toExponential(1)}`)
good &&= right[0] < 2e-3 && right[1] < 1e-12
process.exit(good ? 0 : 1)
J
node fir.cjs
