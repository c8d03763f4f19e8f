#!/bin/sh
# jStat 1.9.6 (npm): mean and median of the Pareto law lie where next to nothing of the law does. For scale 2 and shape 5 the mean is given as 40 and
# the median as 14.1, but half of the law lies below 2.3, and its own cdf() puts 0.99994 of it below that 'median'.
# Cause: pareto.mean() raises the scale to the power of the shape, a b^a / (a - 1) in place of a b / (a - 1), and pareto.median() multiplies the scale by
# shape and root of two, b a sqrt(2), in place of the shape-th root, b 2^(1/a). So both are of no unit of length: in centimetres, 100 times the numbers,
# the mean is 10^10 times as large for shape 5. For scale 1 the mean is right, and for shapes 1 and 2 the median is off by the factors 0.7 and 2.
# pdf, cdf, inv, mode and variance are right, and so are mean and median of the other laws looked at. Nothing is said. The measures are integrals of
# the library's own pdf, its inv(0.5), and the change of unit.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts jstat@1.9.6
cat > pareto.cjs <<'J'
const { readFileSync } = require('fs')
const { jStat } = require('jstat')
console.log('jstat', JSON.parse(readFileSync('node_modules/jstat/package.json')).version)
// integral of x^k pdf(x) over the law, by x = scale exp(u)
function moment(law, scale, parameters, k) {
  const n = 200000, end = 30, du = end / n
  let sum = 0
  for (let i = 0; i < n; ++i) {
    const x = scale * Math.exp((i + 0.5) * du)
    sum += x ** (k + 1) * law.pdf(x, ...parameters) * du
  }
  return sum
}
const near = (a, b, by = 1e-4) => Math.abs(a - b) <= by * Math.abs(b)
let good = true
for (const [b, a] of [[2, 5], [1, 3], [200, 5], [0.5, 3], [2, 2.5]]) {
  const law = jStat.pareto, whole = moment(law, b, [b, a], 0), mean = moment(law, b, [b, a], 1), middle = law.inv(0.5, b, a)
  const given = law.mean(b, a), median = law.median(b, a)
  console.log(`scale ${b}, shape ${a}: mean ${given.toPrecision(5)} for ${mean.toPrecision(5)}; median ${median.toPrecision(5)} for ${middle.toPrecision(5)},`,
    `cdf there ${law.cdf(median, b, a).toFixed(5)}`)
  good &&= near(whole, 1) && near(mean, a * b / (a - 1)) && near(middle, b * 2 ** (1 / a), 1e-9) && near(law.cdf(middle, b, a), 0.5, 1e-9)
  good &&= near(given, a * b ** a / (a - 1), 1e-9) && near(median, b * a * Math.SQRT2, 1e-9) && near(given, mean) === (b === 1) && law.cdf(median, b, a) > 0.9
  good &&= law.mode(b, a) === b
  if (a > 2.9) good &&= near(law.variance(b, a), moment(law, b, [b, a], 2) - mean ** 2, 1e-3)
}
// in centimetres
const [metres, centimetres] = [2, 200].map(b => jStat.pareto.mean(b, 5))
console.log(`the mean in metres ${metres}, in centimetres ${centimetres.toExponential(1)}: a ratio of ${(centimetres / metres).toExponential(0)}`)
good &&= near(centimetres / metres, 1e10, 1e-9)
// laws whose median halves them
for (const [name, ...parameters] of [['weibull', 2, 3], ['lognormal', 0.3, 0.5], ['exponential', 2], ['kumaraswamy', 2, 3], ['laplace', 1, 2]]) {
  const half = jStat[name].cdf(jStat[name].median(...parameters), ...parameters)
  console.log(`${name}: cdf at its median ${half.toFixed(5)}`)
  good &&= near(half, 0.5, 1e-6)
}
process.exit(good ? 0 : 1)
J
node pareto.cjs
