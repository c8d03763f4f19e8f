#!/bin/sh
# Boost.QVM of Boost 1.81 (Debian 12; 1.74 has the same code): a rotation about an axis takes an axis of any length as a quaternion, but not as a
# matrix. rot_quat(axis, angle), set_rot() and rotate() of a quaternion divide by the length of the axis; rot_mat(axis, angle), set_rot() and
# rotate() of a matrix put it into Rodrigues' formula as it stands. About (1,1,1) a quarter turn makes a cube nine times as large, a half turn about
# (0,0,2) seven times, and one about (0.1,0.2,0.2) mirrors. rot_mat() does reckon the length, but only to throw zero_magnitude_error if it is 0, as
# rot_quat() does too; the manual has the same words for both ('performs a rotation around the axis at angle radians') and no other exception.
# For axes of length 1, as in most tests, both agree. Half turns keep what is across the axis, so that only part of a body looks wrong.
set -eu
version=1.81.0-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libboost1.81-dev=$version"
dpkg -x ./*.deb root
cat > axis.cpp <<'C'
#include <boost/qvm.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
namespace q = boost::qvm;
using Mat = q::mat<double, 3, 3>;
using Vec = q::vec<double, 3>;
using Quat = q::quat<double>;
double apart(const Mat& a, const Mat& b) {
  double d = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) d = std::fmax(d, std::abs(a.a[i][j] - b.a[i][j]));
  return d;
}
template <class F> bool throws(F f) {
  try {
    f();
  } catch (const q::zero_magnitude_error&) {
    return true;
  }
  return false;
}
struct Seen {
  double matrix, quaternion, set, turned, volume, axis; // differences from the rotation; determinant; length of the mapped axis by its length
};
Seen look(const Vec& axis, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  const Vec u = q::normalized(axis);
  const Mat right = q::rot_mat<3>(u, angle), of_matrix = q::rot_mat<3>(axis, angle);
  const Quat quaternion = q::rot_quat(axis, angle);
  const Mat of_quaternion = q::convert_to<Mat>(quaternion);
  Mat set, turned = q::identity_mat<double, 3>();
  q::set_rot(set, axis, angle);
  q::rotate(turned, axis, angle);
  const Vec mapped = of_matrix * axis;
  const Seen s{apart(of_matrix, right), apart(of_quaternion, right), apart(set, right), apart(turned, right), q::determinant(of_matrix),
               q::mag(mapped) / q::mag(axis)};
  std::printf("(%g, %g, %g), length %.3f, %g degrees: off by %.3f as a matrix (set_rot %.3f, rotate %.3f), by %.3f as a quaternion; ", axis.a[0],
              axis.a[1], axis.a[2], q::mag(axis), degrees, s.matrix, s.set, s.turned, s.quaternion);
  std::printf("determinant %.3f, axis times %.3f\n", s.volume, s.axis);
  return s;
}
int main() {
  std::printf("Boost.QVM of Boost %d.%d\n", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000);
  bool as_described = true;
  const double pi = std::acos(-1.0);
  const Vec axes[] = {{{1, 1, 1}}, {{0, 0, 2}}, {{1, 2, 3}}, {{0.1, 0.2, 0.2}}, {{0.6, 0, 0.8}}, {{0, 1, 0}}};
  for (const Vec& axis : axes)
    for (const double degrees : {90.0, 180.0}) {
      const Seen s = look(axis, degrees);
      const double n2 = q::mag_sqr(axis), c = std::cos(degrees * pi / 180), sine = std::sin(degrees * pi / 180);
      // Along the axis the formula scales by n^2 + (1 - n^2) c, across it turns and scales by the length of (c, n s).
      const double along = n2 + (1 - n2) * c;
      as_described &= s.quaternion < 1e-12 && s.set == s.matrix && std::abs(s.turned - s.matrix) < 1e-12;
      as_described &= std::abs(s.axis - std::abs(along)) < 1e-9 && std::abs(s.volume - along * (c * c + n2 * sine * sine)) < 1e-9;
      if (std::abs(n2 - 1) < 1e-9)
        as_described &= s.matrix < 1e-12;
      else
        as_described &= s.matrix > 0.2;
    }
  const Vec zero{{0, 0, 0}};
  const bool matrix = throws([&] { Mat m = q::rot_mat<3>(zero, 1.0); }), quaternion = throws([&] { Quat r = q::rot_quat(zero, 1.0); });
  std::printf("axis of length 0: rot_mat %s, rot_quat %s\n", matrix ? "throws" : "does not throw", quaternion ? "throws" : "does not throw");
  return !(as_described && matrix && quaternion);
}
C
c++ -std=c++14 -O0 -w -I root/usr/include axis.cpp -o axis
./axis
