#!/bin/sh
# OMPL 1.6.0 (Debian 13): on SphereStateSpace distance() is that of the great circle, but interpolate() is not its own; it is inherited from
# CompoundStateSpace and goes straight in the two angles, longitude and colatitude. So a motion is not the arc whose length is counted: opposite
# points 10 degrees from the pole are 20 degrees apart, the way goes round along the parallel, 31 degrees, and its middle is 14 degrees from both
# ends. PathGeometric::length(), which planners minimise, gives 0.349 for it and 0.546 as soon as interpolate() has put points in between, which
# leaves the way itself as it was; by these numbers nothing is gained over the pole. Towards the pole it is pi/2 times longer; along meridians and
# the equator it is right. sanityChecks() passes, since it tests only that the halves are not too short. Moreover the samplers take distances for
# angles: at radius 10, sampleUniformNear(.., 1) yields states 7 off on average, up to 12.7, and sampleGaussian() 10 times the deviation asked for;
# about a pole they leave all but a wedge of longitudes empty, and half of the samples are the pole itself, as colatitudes below 0 are cut off.
# Nothing is said: the header says nothing of it, and the change that brought the space in speaks of the correct interpolation and metric.
set -eu
version=1.6.0+ds1-5
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
from get download "libompl17=$version" "libompl-dev=$version" libode8t64 libccd2 libboost-serialization1.83.0 libboost-filesystem1.83.0 \
  libboost1.83-dev libeigen3-dev libc6 libstdc++6 libgcc-s1
for package in *.deb; do dpkg -x "$package" root; done
cat > sphere.cpp <<'C'
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/special/SphereStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <cmath>
#include <cstdio>
namespace base = ompl::base;
using Space = base::SphereStateSpace;
using State = Space::StateType;
static const double degree = std::acos(-1.) / 180;
static bool as_described = true;
static bool near(double a, double b, double tolerance = 1e-4) { return std::abs(a - b) < tolerance; }
static void expect(bool holds) { as_described = as_described && holds; }
int main() {
  ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
  ompl::RNG::setSeed(1);
  for (double radius : {1., 10.}) {
    auto space = std::make_shared<Space>(radius);
    auto information = std::make_shared<base::SpaceInformation>(space);
    information->setStateValidityChecker([](const base::State*) { return true; });
    information->setup();
    if (radius == 1) space->sanityChecks();
    State *a = space->allocState()->as<State>(), *b = space->allocState()->as<State>(), *m = space->allocState()->as<State>();
    const struct {
      const char* what;
      double theta1, phi1, theta2, phi2;
      bool right;
    } cases[] = {{"along the equator", 0, 90, 90, 90, true},
                 {"along a meridian", 0, 30, 0, 120, true},
                 {"opposite, 10 degrees from the pole", 0, 10, 179.999, 10, false},
                 {"opposite, 30 degrees from the pole", 0, 30, 179.999, 30, false},
                 {"a third round, 45 degrees from the pole", 0, 45, 120, 45, false}};
    for (const auto& c : cases) {
      a->setThetaPhi(c.theta1 * degree, c.phi1 * degree);
      b->setThetaPhi(c.theta2 * degree, c.phi2 * degree);
      space->interpolate(a, b, 0.5, m);
      const double all = space->distance(a, b), half = space->distance(a, m), other = space->distance(m, b);
      const double closed = radius * std::acos(std::cos(c.phi1 * degree) * std::cos(c.phi2 * degree) + std::sin(c.phi1 * degree) *
                                               std::sin(c.phi2 * degree) * std::cos((c.theta2 - c.theta1) * degree));
      ompl::geometric::PathGeometric path(information, a, b);
      const double before = path.length();
      path.interpolate(200);
      const double after = path.length();
      double in_space = 0;
      for (unsigned i = 1; i < path.getStateCount(); ++i)
        in_space += (space->toVector(path.getState(i)) - space->toVector(path.getState(i - 1))).norm();
      std::printf("radius %g, %s: distance %.4f; the middle is %.4f and %.4f from the ends; length of the path %.4f, with more points on it %.4f, "
                  "in space %.4f\n", radius, c.what, all, half, other, before, after, in_space);
      expect(near(all, closed, 1e-3 * radius) && near(before, all) && near(after, in_space, 2e-3 * radius));
      // What it should be, and what it is: the arc of the parallel.
      const double parallel = radius * std::sin(c.phi1 * degree) * (c.theta2 - c.theta1) * degree;
      if (c.right) expect(near(half, all / 2, 1e-3 * radius) && near(other, all / 2, 1e-3 * radius) && near(after, before, 2e-3 * radius));
      else expect(half > 0.54 * all && near(after, parallel, 2e-3 * radius) && after > 1.1 * before);
    }
    // Over the pole it is as long as the distance says.
    a->setThetaPhi(0, 10 * degree);
    m->setThetaPhi(0, 0);
    ompl::geometric::PathGeometric path(information, a, m);
    m->setThetaPhi(179.999 * degree, 0);
    path.append(m);
    b->setThetaPhi(179.999 * degree, 10 * degree);
    path.append(b);
    path.interpolate(300);
    std::printf("radius %g, over the pole: length of the path %.4f\n", radius, path.length());
    expect(near(path.length(), 20 * degree * radius, 2e-3 * radius));
    // The samplers, about a state of the equator.
    auto sampler = space->allocDefaultStateSampler();
    const int n = 10000;
    double mean = 0, farthest = 0, square = 0;
    a->setThetaPhi(0, 90 * degree);
    for (int i = 0; i < n; ++i) {
      sampler->sampleUniformNear(m, a, 1);
      mean += space->distance(a, m) / n;
      farthest = std::fmax(farthest, space->distance(a, m));
      sampler->sampleGaussian(m, a, 0.1);
      square += std::pow(space->distance(a, m), 2) / (2 * n);
    }
    std::printf("radius %g, near, within 1: %.2f off on average, %.2f at most; Gaussian of 0.1: %.3f in each direction\n", radius, mean, farthest,
                std::sqrt(square));
    expect(radius == 1 ? farthest < 1.5 && near(std::sqrt(square), 0.1, 0.01) : mean > 6 && farthest > 10 && near(std::sqrt(square), 1, 0.1));
    if (radius != 1) continue;
    int pole = 0, behind = 0;
    a->setThetaPhi(0, 0);
    for (int i = 0; i < n; ++i) {
      sampler->sampleUniformNear(m, a, 0.5);
      pole += m->getPhi() == 0;
      behind += m->getPhi() > 0 && std::abs(m->getTheta()) > 0.51;
    }
    std::printf("radius 1, near the pole, within 0.5: %.0f %% are the pole itself, %d beyond 29 degrees of longitude, evenly spread 84 %%\n",
                100. * pole / n, behind);
    expect(pole > 0.45 * n && behind == 0);
  }
  return !as_described;
}
C
lib=$(dirname "$(find root -name 'libompl.so.17')")
loader=$(find root -name 'ld-linux*' | head -n 1)
c++ -std=c++17 -O1 -w -I root/usr/include -I root/usr/include/ompl-1.6 -I root/usr/include/eigen3 sphere.cpp -o sphere "$lib/libompl.so.17" \
  -Wl,--allow-shlib-undefined
echo "OMPL $version"
"$loader" --library-path "$lib" ./sphere
