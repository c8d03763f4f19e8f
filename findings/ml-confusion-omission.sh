#!/bin/sh
# ml-confusion-matrix 2.0.0 (npm): getFalseOmissionRate() gives the miss rate. Of 1000 people, 10 ill, of whom a test finds 5 and alarms 20 of the healthy:
# the false omission rate, how many of those declared healthy are ill, is 5/975 = 0.005; the method says 0.5.
# Cause: it divides the false negatives by FN + TP, all that are truly positive, in place of FN + TN, all that were called negative. So it always equals
# getFalseNegativeRate(), and does not add to 1 with getNegativePredictiveValue(), of which it is the complement by definition. Its neighbour
# getFalseDiscoveryRate(), the complement of the positive predictive value, is right, and so are the other rates, F1, Matthews' coefficient, informedness
# and markedness, which are compared with counts here. Where FP = FN and both classes are as large, as in balanced examples, nothing shows. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --no-save --ignore-scripts ml-confusion-matrix@2.0.0
cat > matrix.cjs <<'J'
const { readFileSync } = require('fs')
const { ConfusionMatrix } = require('ml-confusion-matrix')
console.log('ml-confusion-matrix', JSON.parse(readFileSync('node_modules/ml-confusion-matrix/package.json')).version)
let good = true
const same = (a, b) => Math.abs(a - b) < 1e-12
function look(name, TP, FN, FP, TN, shows) {
  const actual = [], predicted = []
  const add = (n, a, p) => { for (let i = 0; i < n; ++i) { actual.push(a); predicted.push(p) } }
  add(TP, 'ill', 'ill'); add(FN, 'ill', 'well'); add(FP, 'well', 'ill'); add(TN, 'well', 'well')
  const matrix = ConfusionMatrix.fromLabels(actual, predicted)
  // counted again from the labels: of those called well, how many are ill
  const calledWell = actual.filter((_, i) => predicted[i] === 'well'), omission = calledWell.filter(a => a === 'ill').length / calledWell.length
  const got = matrix.getFalseOmissionRate('ill')
  console.log(`${name}: false omission rate ${got.toFixed(4)} for ${omission.toFixed(4)}; miss rate ${matrix.getFalseNegativeRate('ill').toFixed(4)},`,
    `1 - negative predictive value ${(1 - matrix.getNegativePredictiveValue('ill')).toFixed(4)}`)
  good &&= same(got, FN / (FN + TP)) && same(got, matrix.getFalseNegativeRate('ill')) && same(1 - matrix.getNegativePredictiveValue('ill'), omission)
  good &&= shows === !same(got, omission)
  // right ones
  const sensitivity = TP / (TP + FN), specificity = TN / (TN + FP), precision = TP / (TP + FP)
  good &&= same(matrix.getFalseDiscoveryRate('ill'), FP / (FP + TP)) && same(matrix.getPositivePredictiveValue('ill'), precision)
  good &&= same(matrix.getTruePositiveRate('ill'), sensitivity) && same(matrix.getTrueNegativeRate('ill'), specificity)
  good &&= same(matrix.getFalsePositiveRate('ill'), 1 - specificity) && same(matrix.getF1Score('ill'), 2 * precision * sensitivity / (precision + sensitivity))
  good &&= same(matrix.getInformedness('ill'), sensitivity + specificity - 1) && same(matrix.getMarkedness('ill'), precision + 1 - omission - 1)
  good &&= same(matrix.getMatthewsCorrelationCoefficient('ill'), (TP * TN - FP * FN) / Math.sqrt((TP + FP) * (TP + FN) * (TN + FP) * (TN + FN)))
}
look('screening, one in a hundred is ill', 5, 5, 20, 970, true)
look('most are ill', 880, 20, 10, 90, true)
look('balanced', 40, 10, 10, 40, false)
process.exit(good ? 0 : 1)
J
node matrix.cjs
