#!/bin/sh
# GTSAM 4.2.0 (Debian 13): derivatives of Chebyshev series are right on intervals of length 2 only. DerivativeWeights(N, x, a, b) of Chebyshev1Basis
# and of Chebyshev2Basis map x from [a, b] to [-1, 1], take the derivative there and leave it at that: it is by the mapped x, and lacks the factor
# 2 / (b - a). Values are right, on every interval. A motion fitted exactly over 10 s with EvaluationFactor (a = 0, b = 10) has, by
# DerivativeFunctor, 5 times its speed, in milliseconds 5000 times, and half of it where the 10 s are the unit: it depends on the unit of time.
# Positions and speeds of one motion, both exact, contradict each other in one graph (EvaluationFactor, DerivativeFactor): the fit is up to 24 m
# off from positions that the same polynomial meets without the speeds. The pseudo-spectral basis, Chebyshev2, has the factor; on the default
# interval [-1, 1], on which the tests are made, there is none to miss. The header has 'evaluate Chebyshev derivative at x' with 'lower limit' and
# 'upper limit of polynomial', and no other variable. Nothing is said.
set -eu
version=4.2.0+dfsg-1+b4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Debian 13's packages, whatever release this is; the sources are the machine's own with the name exchanged.
mkdir -p apt/parts apt/lists/partial apt/cache/archives/partial
for source in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
  [ -f "$source" ] && sed 's/bookworm/trixie/g' "$source" > "apt/parts/debian.${source##*.}"
done
from() {
  command=$1
  shift
  "apt-$command" -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$folder/apt/parts" -o "Dir::State::lists=$folder/apt/lists" \
    -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User=root -qq "$@"
}
from get update
from get download "libgtsam4=$version" "libgtsam-dev=$version" libboost1.83-dev libboost-serialization1.83.0 libboost-filesystem1.83.0 \
  libboost-timer1.83.0 libtbb12 libtbb-dev libtbbmalloc2 libccolamd3 libsuitesparseconfig7 libmetis5 libgomp1 libeigen3-dev libc6 libstdc++6 libgcc-s1
for package in *.deb; do dpkg -x "$package" root; done
cat > series.cpp <<'C'
#include <gtsam/basis/BasisFactors.h>
#include <gtsam/basis/Chebyshev.h>
#include <gtsam/basis/Chebyshev2.h>
#include <gtsam/linear/GaussianFactorGraph.h>
#include <gtsam/linear/VectorValues.h>
#include <gtsam/nonlinear/NonlinearFactorGraph.h>
#include <cmath>
#include <cstdio>
using namespace gtsam;
static bool as_described = true;
static void expect(bool holds) { as_described = as_described && holds; }
static bool near(double a, double b) { return std::abs(a - b) < 1e-6 * std::fmax(1, std::abs(b)); }
static const size_t n = 4;
static const auto unit = noiseModel::Unit::Create(1);
// A motion with constant acceleration, in metres; seconds is the length of the unit of time.
static double position(double t) { return 3 + 2 * t + 0.5 * t * t; }
static double speed(double t) { return 2 + t; }
template <class Basis>
static NonlinearFactorGraph positions(double a, double b, double seconds) {
  NonlinearFactorGraph graph;
  for (int i = 0; i <= 10; ++i) {
    const double t = a + (b - a) * i / 10;
    graph.emplace_shared<EvaluationFactor<Basis>>(0, position(t * seconds), unit, n, t, a, b);
  }
  return graph;
}
static Vector solve(const NonlinearFactorGraph& graph) {
  Values zero;
  zero.insert<Vector>(0, Vector::Zero(n));
  return graph.linearize(zero)->optimize().at(0);
}
template <class Basis>
static void show(const char* name, double a, double b, double seconds, bool right) {
  const Vector c = solve(positions<Basis>(a, b, seconds));
  const double t = a + 0.3 * (b - a), h = 1e-4 * (b - a);
  const double value = typename Basis::EvaluationFunctor(n, t, a, b)(c), slope = typename Basis::DerivativeFunctor(n, t, a, b)(c) / seconds;
  const double difference = (typename Basis::EvaluationFunctor(n, t + h, a, b)(c) - typename Basis::EvaluationFunctor(n, t - h, a, b)(c)) / (2 * h);
  std::printf("%-16s from %g to %g, unit %g s, at %g s: position %.4f (right %.4f), speed %.4f (right %.4f, by differences %.4f)\n", name, a, b, seconds,
              t * seconds, value, position(t * seconds), slope, speed(t * seconds), difference / seconds);
  expect(near(value, position(t * seconds)) && near(difference / seconds, speed(t * seconds)));
  expect(near(slope, speed(t * seconds) * (right ? 1 : (b - a) / 2)));
}
template <class Basis>
static void both(const char* name, double b, bool right) {
  NonlinearFactorGraph graph = positions<Basis>(0, b, 1);
  for (int i = 1; i <= 9; ++i) graph.emplace_shared<DerivativeFactor<Basis>>(0, speed(b * i / 10), unit, n, b * i / 10, 0., b);
  const Vector c = solve(graph);
  Values found;
  found.insert<Vector>(0, c);
  double off = 0;
  for (int i = 0; i <= 10; ++i) off = std::fmax(off, std::abs(typename Basis::EvaluationFunctor(n, b * i / 10, 0, b)(c) - position(b * i / 10)));
  std::printf("%-16s positions and speeds from 0 to %g: error of the graph %.3g, up to %.3g m from the positions\n", name, b, graph.error(found), off);
  expect(right ? off < 1e-6 && graph.error(found) < 1e-9 : off > 5 && graph.error(found) > 10);
}
int main() {
  show<Chebyshev1Basis>("Chebyshev1Basis", -1, 1, 1, true);
  show<Chebyshev1Basis>("Chebyshev1Basis", 4, 6, 1, true);
  show<Chebyshev1Basis>("Chebyshev1Basis", 0, 10, 1, false);
  show<Chebyshev1Basis>("Chebyshev1Basis", 0, 1, 10, false);
  show<Chebyshev1Basis>("Chebyshev1Basis", 0, 10000, 1e-3, false);
  show<Chebyshev2Basis>("Chebyshev2Basis", -1, 1, 1, true);
  show<Chebyshev2Basis>("Chebyshev2Basis", 0, 10, 1, false);
  show<Chebyshev2>("Chebyshev2", -1, 1, 1, true);
  show<Chebyshev2>("Chebyshev2", 0, 10, 1, true);
  show<Chebyshev2>("Chebyshev2", 0, 10000, 1e-3, true);
  both<Chebyshev1Basis>("Chebyshev1Basis", 2, true);
  both<Chebyshev1Basis>("Chebyshev1Basis", 10, false);
  both<Chebyshev2Basis>("Chebyshev2Basis", 10, false);
  both<Chebyshev2>("Chebyshev2", 10, true);
  return !as_described;
}
C
lib=$(dirname "$(find root -name 'libgtsam.so.4')")
loader=$(find root -name 'ld-linux*' -type f | head -n 1)
c++ -std=c++17 -O0 -w -I root/usr/include -I root/usr/include/eigen3 series.cpp -o series "$lib/libgtsam.so.4" "$lib/libboost_serialization.so.1.83.0" \
  "$lib/libtbb.so.12" "$lib/libtbbmalloc.so.2" -Wl,--allow-shlib-undefined -Wl,-rpath-link,"$lib"
echo "GTSAM $version"
"$loader" --library-path "$lib" ./series
