#!/bin/sh
# fili 2.0.3 (npm, digital filters): simulate(), stepResponse() and impulseResponse() of an IirFilter show another filter than the one that runs. They take the
# last section of the cascade as many times as there are sections. A Butterworth low pass of two sections overshoots a step by 11%; stepResponse() has
# 0.04%, and of four sections 16.5% against nothing. A high pass followed by a low pass lets no constant through; simulate() of it gives the constant back.
# Cause: the inner reinit(), which makes fresh sections for these three, copies from s, a variable that the constructor's loop leaves at the last section, and
# not from the section of its own loop. The documentation has it that simulate() runs the filter without a change of its state.
# With one section all is right, and so are multiStep(), singleStep() and responsePoint() always, which are compared here with the recursion and with the
# squares of Butterworth's formula. Nothing is said. FirFilter's simulate() is not concerned.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts fili@2.0.3
cat > cascade.cjs <<'J'
const { CalcCascades, IirFilter } = require('fili')
console.log('fili', require('fili/package.json').version)
const design = new CalcCascades(), Fs = 1000
const low = (order, Fc, characteristic = 'butterworth') => design.lowpass({ order, characteristic, Fs, Fc })
const high = (order, Fc) => design.highpass({ order, characteristic: 'butterworth', Fs, Fc })
// one section after the other, by the difference equation
function recursion(sections, input) {
  let x = input
  for (const { k, a, b } of sections) {
    const y = []
    x.forEach((v, n) => y.push(k * (b[0] * v + b[1] * (x[n - 1] || 0) + b[2] * (x[n - 2] || 0)) - a[0] * (y[n - 1] || 0) - a[1] * (y[n - 2] || 0)))
    x = y
  }
  return x
}
const far = (a, b) => Math.max(...a.map((v, i) => Math.abs(v - b[i])))
const lastOnly = sections => sections.map(() => sections[sections.length - 1])
const step = Array(600).fill(1), impulse = [1, ...Array(599).fill(0)]
let good = true
const cases = [
  ['Butterworth, 1 section', low(1, 50)], ['Butterworth, 2 sections', low(2, 50)], ['Butterworth, 3 sections', low(3, 50)], ['Butterworth, 4 sections', low(4, 50)],
  ['Bessel, 1 section', low(1, 50, 'bessel')], ['Bessel, 3 sections', low(3, 50, 'bessel')], ['high pass 10, then low pass 100', [...high(1, 10), ...low(1, 100)]],
  ['low pass 100, then high pass 10', [...low(1, 100), ...high(1, 10)]]]
for (const [name, sections] of cases) {
  const filter = new IirFilter(sections), told = filter.stepResponse(600), runs = filter.multiStep(step), right = recursion(sections, step)
  const simulated = filter.simulate(step), answer = filter.impulseResponse(600).out, least = recursion(lastOnly(sections), step)
  const runImpulse = new IirFilter(sections).multiStep(impulse), single = sections.length < 2
  console.log(`${name}: step to ${Math.max(...told.out).toFixed(4)} at the most by stepResponse(), ${Math.max(...runs).toFixed(4)} by multiStep(); at the end`,
    `${Math.abs(told.out[599]).toFixed(4)} and ${Math.abs(runs[599]).toFixed(4)}; impulse up to ${far(answer, runImpulse).toFixed(3)} apart`)
  good &&= far(runs, right) < 1e-9 && far(runImpulse, recursion(sections, impulse)) < 1e-9 && far(told.out, least) < 1e-9 && far(simulated, least) < 1e-9 &&
    far(answer, recursion(lastOnly(sections), impulse)) < 1e-9 && (single ? far(told.out, right) < 1e-12 : far(told.out, right) > 0.03)
}
const overshoot = [2, 4].map(order => {
  const filter = new IirFilter(low(order, 50))
  return [filter.stepResponse(600).max.value, Math.max(...filter.multiStep(step))].map(v => 100 * (v - 1))
})
console.log('overshoot of Butterworth by stepResponse().max and by multiStep():', overshoot.map(p => p.map(v => v.toFixed(2) + '%').join(' and ')).join('; '))
good &&= overshoot.every(([told, runs]) => told < 0.1 && runs > 10)

// a sine at the corner frequency: Butterworth's gain there is 1 / sqrt(2), whatever the order
const sine = Array.from({ length: 2000 }, (_, n) => Math.sin(2 * Math.PI * 50 * n / Fs))
const peak = a => Math.sqrt(2 * a.slice(1500, 1900).reduce((s, v) => s + v * v, 0) / 400)
for (const order of [1, 2, 4, 6]) {
  const filter = new IirFilter(low(order, 50)), simulated = peak(filter.simulate(sine)), runs = peak(filter.multiStep(sine))
  const point = filter.responsePoint({ Fs, Fr: 50 }).magnitude
  console.log(`sine at the corner, sections: ${order}; height ${simulated.toFixed(4)} by simulate(), ${runs.toFixed(4)} by multiStep(),`,
    `${point.toFixed(4)} by responsePoint()`)
  good &&= Math.abs(runs - Math.SQRT1_2) < 1e-4 && Math.abs(point - Math.SQRT1_2) < 1e-9 && (order < 2 ? Math.abs(simulated - runs) < 1e-9 : simulated < 0.32)
  // the response at other frequencies by the formula, with the bilinear map's frequencies
  for (const Fr of [10, 80, 200]) {
    const w = Math.tan(Math.PI * Fr / Fs) / Math.tan(Math.PI * 50 / Fs)
    good &&= Math.abs(filter.responsePoint({ Fs, Fr }).magnitude * Math.sqrt(1 + w ** (4 * order)) - 1) < 1e-6
  }
}
// the promise that holds: the state is left as it was
const kept = new IirFilter(low(2, 50)), other = new IirFilter(low(2, 50))
kept.multiStep(sine.slice(0, 100))
other.multiStep(sine.slice(0, 100))
kept.simulate(step)
good &&= far(kept.multiStep(sine), other.multiStep(sine)) === 0
process.exit(good ? 0 : 1)
J
node cascade.cjs
