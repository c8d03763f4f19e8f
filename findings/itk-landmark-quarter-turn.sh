#!/bin/sh
# ITK 5.2.1 (Debian 12; the code is the same in 5.4.3 of Debian 13): LandmarkBasedTransformInitializer in the plane turns by -90 degrees whenever
# the sum of the dot products of the centred landmarks is below 5e-5 (s_dot in InternalInitializeTransform(Rigid2DTransform)): that is taken for a
# quarter turn, and the cross products, which are at hand, are not asked for its sign. So landmarks turned by exactly +90 degrees, as pixels of a
# turned image are, are turned by -90, half a turn from where they belong, while 89, 91 and -90 are right. Nor has the bound a unit: of landmarks
# within 5 mm that are given in metres, every rotation is found as -90, even none at all. Euler2DTransform and Similarity2DTransform go the same way;
# in 3D (VersorRigid3DTransform) the same landmarks are right. Nothing is said, and the documentation promises the best fit in the least squares
# sense.
set -eu
version=5.2.1-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libinsighttoolkit5-dev=$version" "libinsighttoolkit5.2=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libITKCommon-5.2.so.1')")
cat > landmarks.cpp <<'C'
#include <itkEuler2DTransform.h>
#include <itkLandmarkBasedTransformInitializer.h>
#include <itkRigid2DTransform.h>
#include <itkVersion.h>
#include <itkVersorRigid3DTransform.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
const double corners[5][2] = {{0, 0}, {40, 0}, {40, 30}, {0, 30}, {17, 22}};
struct Found {
  double degrees, error; // the rotation, and the greatest distance of a landmark from where it belongs, in the unit given
};
// Turns the landmarks by so many degrees about z, moves them, and has the way there found again.
template <class Transform>
Found find(double degrees, double unit) {
  constexpr unsigned int dimension = Transform::InputSpaceDimension;
  using Initializer = itk::LandmarkBasedTransformInitializer<itk::Transform<double, dimension, dimension>>;
  typename Initializer::LandmarkPointContainer from, to;
  const double c = std::cos(degrees * itk::Math::pi / 180), s = std::sin(degrees * itk::Math::pi / 180);
  for (const auto& corner : corners) {
    typename Initializer::LandmarkPointType p, q;
    p.Fill(0);
    q.Fill(0);
    p[0] = corner[0] * unit;
    p[1] = corner[1] * unit;
    q[0] = c * p[0] - s * p[1] + 3 * unit;
    q[1] = s * p[0] + c * p[1] - unit;
    from.push_back(p);
    to.push_back(q);
  }
  auto transform = Transform::New();
  auto initializer = Initializer::New();
  initializer->SetTransform(transform);
  initializer->SetFixedLandmarks(from);
  initializer->SetMovingLandmarks(to);
  initializer->InitializeTransform();
  const auto matrix = transform->GetMatrix();
  Found found{std::atan2(matrix[1][0], matrix[0][0]) * 180 / itk::Math::pi, 0};
  for (size_t i = 0; i < from.size(); ++i)
    found.error = std::max(found.error, transform->TransformPoint(from[i]).EuclideanDistanceTo(to[i]) / unit);
  return found;
}
int main() {
  std::printf("ITK %s, five landmarks of a field of 40 x 30; rotation found, and greatest error of a landmark:\n", itk::Version::GetITKVersion());
  std::printf("%8s %8s %22s %22s %22s\n", "turned", "unit", "Rigid2D", "Euler2D", "VersorRigid3D");
  bool as_described = true;
  for (const double unit : {1.0, 1e-4})
    for (const double degrees : {0.0, 30.0, 89.0, 90.0, 91.0, -90.0, 150.0}) {
      const Found r = find<itk::Rigid2DTransform<double>>(degrees, unit), e = find<itk::Euler2DTransform<double>>(degrees, unit);
      const Found v = find<itk::VersorRigid3DTransform<double>>(degrees, unit);
      std::printf("%8g %8g", degrees, unit);
      for (const Found& f : {r, e, v}) std::printf("     %7.2f (%7.2f)", f.degrees, f.error);
      std::printf("\n");
      const bool turned_back = (unit < 1 || degrees == 90) && degrees != -90;
      for (const Found& f : {r, e})
        as_described &= turned_back ? std::abs(f.degrees + 90) < 1e-6 && f.error > 30 : std::abs(f.degrees - degrees) < 1e-6 && f.error < 1e-6;
      as_described &= std::abs(v.degrees - degrees) < 1e-6 && v.error < 1e-6;
    }
  return !as_described;
}
C
c++ -std=c++17 -O0 -w -I root/usr/include/ITK-5.2 landmarks.cpp -o landmarks -L "$lib" -lITKTransform-5.2 -lITKCommon-5.2 -litksys-5.2 -litkvnl-5.2 \
  -litkvnl_algo-5.2 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./landmarks
