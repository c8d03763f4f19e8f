#!/bin/sh
# GLM 0.9.9.8 (Debian 12; Debian 13 has it too): pow(q, y) of a quaternion whose w is below -cos(1/2) = -0.8776 is wrong: pow(q, 1) is not q, but the
# rotation the other way, pow(q, 2) is not q * q, and sqrt(q) squared not q. Where |w| is near 1 the half angle is taken from the length of the
# vector part by asin(), for precision, and what that gives for w < 0 (pi minus the half angle) is used as it stands. angle() does the same, so that
# angleAxis(angle(q), axis(q)) undoes what q does. Such quaternions are turns by more than 303 degrees, and minus those by less than 57, as which
# differences of small rotations come when quat_cast() changes its sign on the way: from 260 to 280 degrees in steps of pow(b * inverse(a), t) * a
# one ends at 240. exp(y * log(q)) of GLM is right, and so is pow() for all other quaternions. Nothing is said in the header. Upstream has since
# mended angle(), but not pow().
set -eu
version=0.9.9.8+ds-6
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libglm-dev=$version"
dpkg -x ./*.deb root
cat > power.cpp <<'C'
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>
#include <cmath>
#include <cstdio>
using glm::dquat;
using glm::dvec3;
// Degrees between two rotations; q and -q are the same one.
double apart(const dquat& a, const dquat& b) {
  const dquat d = b * glm::inverse(a);
  return glm::degrees(2 * std::atan2(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), std::abs(d.w)));
}
int main() {
  std::printf("GLM %d.%d.%d.%d; degrees between what is given and what is right:\n", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH,
              GLM_VERSION_REVISION);
  std::printf("%6s %8s %10s %10s %10s %12s %14s\n", "turn", "w", "pow(q,1)", "pow(q,2)", "sqrt(q)^2", "angle, axis", "exp(2 log(q))");
  bool as_described = true;
  const dvec3 axis = glm::normalize(dvec3(1, 2, 2));
  const double turns[] = {20, 90, 200, 300, 302, 304, 320, 340, -20, 420, 380};
  for (const double turn : turns) {
    const dquat q = glm::angleAxis(glm::radians(turn), axis);
    const double one = apart(glm::pow(q, 1.0), q), two = apart(glm::pow(q, 2.0), q * q), root = apart(glm::sqrt(q) * glm::sqrt(q), q);
    const double both = apart(glm::angleAxis(glm::angle(q), glm::axis(q)), q), logarithm = apart(glm::exp(2.0 * glm::log(q)), q * q);
    std::printf("%6g %8.4f %10.2f %10.2f %10.2f %12.2f %14.2f\n", turn, q.w, one, two, root, both, logarithm);
    as_described &= logarithm < 1e-5;
    const double beyond = std::fmin(std::abs(turn - 360), 60) * 2; // between a turn and that turn the other way
    if (q.w < -std::cos(0.5))
      as_described &= std::abs(one - beyond) < 1e-5 && std::abs(root - beyond) < 1e-5 && std::abs(both - beyond) < 1e-5 && two > 70;
    else
      as_described &= one < 1e-5 && two < 1e-5 && root < 1e-5 && both < 1e-5;
  }
  // Two orientations, given as matrices, and the way from one to the other.
  const dvec3 z(0, 0, 1);
  const dquat a = glm::quat_cast(glm::mat3_cast(glm::angleAxis(glm::radians(260.0), z)));
  const dquat b = glm::quat_cast(glm::mat3_cast(glm::angleAxis(glm::radians(280.0), z)));
  const dquat difference = b * glm::inverse(a), end = glm::pow(difference, 1.0) * a;
  const dvec3 x = end * dvec3(1, 0, 0);
  double degrees = glm::degrees(std::atan2(x.y, x.x));
  if (degrees < 0) degrees += 360;
  std::printf("from 260 to 280 degrees about z: difference has w = %.4f, pow(difference, 1) * a is at %.1f degrees, difference * a is %.1f off b\n",
              difference.w, degrees, apart(difference * a, b));
  as_described &= difference.w < -0.98 && std::abs(degrees - 240) < 1e-5 && apart(difference * a, b) < 1e-5;
  return !as_described;
}
C
c++ -std=c++17 -O1 -w -I root/usr/include power.cpp -o power
./power
