#!/bin/sh
# Eigen 3.4.0 (Debian 12), unsupported module EulerAngles: inverse() is not the inverse. It negates the three angles and leaves their order, so that a
# rotation times its inverse() is a turn by 24 degrees for (0.3, 0.5, -0.7), and by up to 180. The comment in the header says that the inverse is the
# same as the negative; it is (-gamma, -beta, -alpha) in a system with the axes in reverse order. For ZXZ and the like that is the same system,
# so that nothing hinders the right result; for XYZ and the like the angles are to be computed anew. EulerAngles is a RotationBase as
# AngleAxis, Quaternion and Rotation2D are, whose inverse() is right, and code for all of them goes wrong with this one only. It does not show
# if only one angle is not 0, and little if the angles are small. The way over the quaternion or the transposed matrix is right. Nothing is said.
set -eu
version=3.4.0-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libeigen3-dev=$version"
dpkg -x ./*.deb root
cat > inverse.cpp <<'C'
#include <Eigen/Geometry>
#include <unsupported/Eigen/EulerAngles>
#include <cmath>
#include <cstdio>
using namespace Eigen;
const double degree = std::acos(-1.0) / 180;
// As generic code has it: there and back, for any rotation of Eigen.
template <class R> double there_and_back(const RotationBase<R, 3>& rotation, const Vector3d& v) {
  const Vector3d there = rotation.derived() * v;
  return (rotation.derived().inverse() * there - v).norm();
}
double turn(const Matrix3d& m) { return std::abs(AngleAxisd(m).angle()) / degree; }
template <class System> bool look(const char* name, double a, double b, double c, double least, double most) {
  const EulerAngles<double, System> e(a, b, c);
  const Matrix3d m = e.toRotationMatrix();
  const EulerAngles<double, System> over_matrix(Matrix3d(m.transpose()));
  const EulerAngles<double, System> over_quaternion(Quaterniond(e).inverse());
  const Vector3d v(1, 2, 3);
  const double off = turn(m * e.inverse().toRotationMatrix()), back = there_and_back(e, v);
  const double matrix = (m * over_matrix.toRotationMatrix() - Matrix3d::Identity()).norm();
  const double quaternion = (m * over_quaternion.toRotationMatrix() - Matrix3d::Identity()).norm();
  const double others = there_and_back(Quaterniond(e), v) + there_and_back(AngleAxisd(m), v);
  std::printf("%s (%g, %g, %g): e * e.inverse() turns by %.2f degrees, (1,2,3) there and back is off by %.3f (quaternion and axis %.0e);", name, a,
              b, c, off, back, others);
  std::printf(" over the matrix or the quaternion %.0e\n", matrix + quaternion);
  return off >= least && off <= most && matrix + quaternion + others < 1e-12 && (back > 0.01) == (least > 0) &&
         e.inverse().angles() == -e.angles();
}
int main() {
  std::printf("Eigen %d.%d.%d\n", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  bool as_described = look<EulerSystemXYZ>("XYZ", 0.3, 0.5, -0.7, 23, 25);
  as_described &= look<EulerSystemZYX>("ZYX", 0.3, 0.5, -0.7, 23, 25) && look<EulerSystemZXZ>("ZXZ", 0.3, 0.5, -0.7, 27, 28);
  as_described &= look<EulerSystemXYZ>("XYZ", 90 * degree, 90 * degree, 0, 100, 181);
  as_described &= look<EulerSystemZXZ>("ZXZ", 90 * degree, 90 * degree, 0, 100, 181);
  as_described &= look<EulerSystemZXZ>("ZXZ", 180 * degree, 90 * degree, 0, 179, 181);
  as_described &= look<EulerSystemXYZ>("XYZ", 0, 0.5, 0, 0, 1e-9) && look<EulerSystemZXZ>("ZXZ", 0, 0.5, 0, 0, 1e-9);
  const EulerAnglesZXZd e(0.3, 0.5, -0.7), right(0.7, -0.5, -0.3);
  const double off = (e.toRotationMatrix() * right.toRotationMatrix() - Matrix3d::Identity()).norm();
  std::printf("ZXZ, negated and in reverse order: off by %.0e\n", off);
  return !(as_described && off < 1e-12);
}
C
c++ -std=c++14 -O0 -w -I root/usr/include/eigen3 inverse.cpp -o inverse
./inverse
