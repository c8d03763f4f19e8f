#!/bin/sh
# @geoda/regression 0.0.22 (npm, GeoDa's regressions for the browser): spatialError() does not fit the spatial error model. It calls the compiled
# spatialLag(), not spatialError(), and names what comes back as if it had: 'Lag coefficient (Lambda)' is the slope of the last x, which stands where
# lambda would. For y = 3 + 2 x + u with u = 0.6 W u + e that 'lambda' is 1.88, which no lambda can be, in place of 0.54, and 1882 with x in another
# unit, x / 1000. Likelihood, AIC, R2, sigma and tests are those of the lag model, the very one to compare with, so that neither fits better.
# Besides, both tables of coefficients, with errors and probabilities, have their first two names exchanged: CONSTANT stands at rho and W_y at the
# constant. The README promises lambda by maximum likelihood, and nothing is said: `type` is 'spatialError', and only the title says lag.
# All other figures of spatialLagRegression(), its rho included, and OLS with its diagnostics are right.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts @geoda/regression@0.0.22
cat > error.cjs <<'J'
const { readFileSync } = require('fs')
// the package looks for its own compiled half at a web address: it is in the package
const compiled = readFileSync('node_modules/@geoda/regression/wasm/geoda-regression.wasm')
globalThis.navigator ??= { hardwareConcurrency: 1 }
globalThis.fetch = async () => new Response(compiled, { headers: { 'content-type': 'application/wasm' } })
const { spatialError, spatialLagRegression } = require('@geoda/regression')
console.log('@geoda/regression', JSON.parse(readFileSync('node_modules/@geoda/regression/package.json')).version)
const side = 12, n = side * side
const neighbours = Array.from({ length: n }, (_, i) => [[i >= side, i - side], [i % side > 0, i - 1], [i % side < side - 1, i + 1],
  [i < n - side, i + side]].filter(p => p[0]).map(p => p[1]))
let seed = 3
const random = () => (seed = seed * 16807 % 2147483647) / 2147483647
const normal = () => Math.sqrt(-2 * Math.log(random())) * Math.cos(2 * Math.PI * random())
const W = v => neighbours.map(l => l.reduce((s, j) => s + v[j], 0) / l.length)
const x = Array.from({ length: n }, normal), e = Array.from({ length: n }, normal), one = Array(n).fill(1)
let u = e
for (let k = 0; k < 200; ++k) u = W(u).map((v, i) => 0.6 * v + e[i])
const y = x.map((v, i) => 3 + 2 * v + u[i])
// by hand: the logarithm of the likelihood for a given lambda or rho, and its highest place
function logDeterminant(r) {
  const a = neighbours.map((l, i) => { const row = new Float64Array(n); row[i] = 1; for (const j of l) row[j] = -r / l.length; return row })
  let sum = 0
  for (let c = 0; c < n; ++c) { // diagonally dominant: no pivots
    sum += Math.log(a[c][c])
    for (let i = c + 1; i < n; ++i) if (a[i][c] !== 0) { const f = a[i][c] / a[c][c]; for (let j = c; j < n; ++j) a[i][j] -= f * a[c][j] }
  }
  return sum
}
const dot = (a, b) => a.reduce((s, v, i) => s + v * b[i], 0), less = (v, r) => { const w = W(v); return v.map((a, i) => a - r * w[i]) }
function fit(r, error) {
  const p = error ? less(one, r) : one, q = error ? less(x, r) : x, z = less(y, r)
  const d = dot(p, p) * dot(q, q) - dot(p, q) ** 2
  const constant = (dot(p, z) * dot(q, q) - dot(p, q) * dot(q, z)) / d, slope = (dot(p, p) * dot(q, z) - dot(p, q) * dot(p, z)) / d
  const squares = z.reduce((s, v, i) => s + (v - constant * p[i] - slope * q[i]) ** 2, 0)
  return { r, constant, slope, likelihood: -n / 2 * (Math.log(2 * Math.PI * squares / n) + 1) + logDeterminant(r) }
}
function best(error) {
  let low = -0.9, high = 0.95
  while (high - low > 1e-5) {
    const a = low + (high - low) * 0.382, b = low + (high - low) * 0.618
    if (fit(a, error).likelihood > fit(b, error).likelihood) high = b; else low = a
  }
  return fit((low + high) / 2, error)
}
const show = o => `constant ${o.constant.toFixed(3)}, slope ${o.slope.toFixed(3)}, coefficient of W ${o.r.toFixed(3)}, log likelihood ${o.likelihood.toFixed(2)}`
const near = (a, b, by) => Math.abs(a - b) <= by
;(async () => {
  const options = { x: [x], y, xNames: ['x'], yName: 'y', datasetName: 'made', weightsId: 'rook', weights: neighbours,
    weightsValues: neighbours.map(l => l.map(() => 1)) }
  const error = await spatialError(options), lag = await spatialLagRegression(options)
  const unit = await spatialError({ ...options, x: [x.map(v => v / 1000)] })
  const table = r => r['Variable Coefficients'].map(v => `${v.Variable} ${v.Coefficient.toFixed(3)}`).join(', ')
  const lambda = error['Lag coefficient (Lambda)'], rho = lag['Lag coefficient (Rho)'], handError = best(true), handLag = best(false)
  console.log('error model by hand:', show(handError), '\nlag model by hand:', show(handLag))
  console.log(`spatialError(): type ${error.type}, lambda ${lambda.toFixed(3)} (x in another unit: ${unit['Lag coefficient (Lambda)'].toFixed(1)}),`,
    `log likelihood ${error['Log Likelihood'].toFixed(2)}; table: ${table(error)}`)
  console.log(`spatialLagRegression(): rho ${rho.toFixed(3)}, log likelihood ${lag['Log Likelihood'].toFixed(2)}; table: ${table(lag)}`)
  const [first, second, third] = error['Variable Coefficients']
  process.exit(error.type === 'spatialError' && near(handError.r, 0.6, 0.15) && near(handError.constant, 3, 0.5) && near(handError.slope, 2, 0.2) &&
    near(lambda, handLag.slope, 1e-3) && near(unit['Lag coefficient (Lambda)'], 1000 * handLag.slope, 1) &&
    near(error['Log Likelihood'], handLag.likelihood, 1e-3) && handError.likelihood > handLag.likelihood + 2 &&
    near(lag['Log Likelihood'], handLag.likelihood, 1e-3) && near(rho, handLag.r, 1e-3) &&
    first.Variable === 'CONSTANT' && near(first.Coefficient, handLag.r, 1e-3) && second.Variable === 'W_y' &&
    near(second.Coefficient, handLag.constant, 5e-3) && near(third.Coefficient, handLag.slope, 1e-3) ? 0 : 1)
})()
J
node error.cjs
