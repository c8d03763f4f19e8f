#!/bin/sh
# ml-levenberg-marquardt 5.1.0 (npm): fits with weights other than 1 go wrong without a word. The gradient is multiplied by the squares of the
# weights, but J'WJ (formed by ml-matrix's new mmulByTranspose) is divided by them, so that a step is off by the fourth power of the weight,
# and steps that make things worse are not taken back. A line through exact points, found in 2 iterations without weights, is not found with
# a weight of 2 for all points: after 100 iterations the initial values come back, as they do when one point of seven has weight 10. With 0.1
# for all it hardly leaves them. Weights that are all alike should not matter to the place of the minimum, and in 5.0.1 they do not. The
# README only says "Weighting vector". Nothing tells that a fit failed but parameterError and the number of iterations.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > line.mjs <<'C'
import { levenbergMarquardt } from 'ml-levenberg-marquardt';
// Points on y = 2 x - 2; the fit starts from y = x.
const x = [0, 1, 2, 3, 4, 5, 6], y = x.map((v) => 2 * v - 2);
const line = ([slope, shift]) => (v) => slope * v + shift;
for (const weights of [undefined, 1, 2, 10, 0.1, [10, 1, 1, 1, 1, 1, 1]]) {
  const fit = levenbergMarquardt({ x, y }, line, { initialValues: [1, 0], weights });
  console.log(`weights ${weights ?? 'none'}: ${fit.parameterValues.map((v) => (Math.round(v * 1000) / 1000).toFixed(3)).join(' ')}`);
}
C
for version in 5.0.1 5.1.0; do
  rm -rf node_modules package.json package-lock.json
  npm install --silent --no-fund --no-audit "ml-levenberg-marquardt@$version" ml-matrix@6.15.1 >/dev/null
  node line.mjs > "$version"
  echo "ml-levenberg-marquardt $version, slope and shift:"
  cat "$version"
done
cat > expected <<'E'
weights none: 2.000 -2.000
weights 1: 2.000 -2.000
weights 2: 1.000 0.000
weights 10: 1.000 0.000
weights 0.1: 1.010 -0.020
weights 10,1,1,1,1,1,1: 1.000 0.000
E
cmp 5.1.0 expected
[ "$(grep -c ': 2.000 -2.000$' 5.0.1)" = 6 ]
