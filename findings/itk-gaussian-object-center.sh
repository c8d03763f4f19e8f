#!/bin/sh
# ITK 5.2.1 (Debian 12; the code is the same in 5.4.3 of Debian 13): a GaussianSpatialObject with a centre of its own has its bell elsewhere.
# SetCenterInObjectSpace() moves its bounding box, what counts as inside, and the sphere of GetEllipsoid(); but SquaredZScoreInObjectSpace(), of which
# ValueAt...() takes the exponential, measures from the origin and does not know the centre. A blob of sigma 1 and radius 3 about (4, 0) has 0.0003
# in its centre in place of the maximum 1, 0.59 at its side toward the origin, three sigma away, and 0.0000 on the other side; about (40, 0) it
# is 0 all over, while IsInside is still true. Drawn by SpatialObjectToImageFilter it is a sickle with an eighth of its mass and its centre
# of gravity at 1.62. With the centre left at 0, as by default, and the object moved by its transformation, all is right, and so might a first
# test be. The header gives the formula about 0 and says that the maximum is the value at the origin of the object's coordinates, and nothing of
# the centre that one can set; the one of EllipseSpatialObject, by the same name, is the centre. Nothing is said.
set -eu
version=5.2.1-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libinsighttoolkit5-dev=$version" "libinsighttoolkit5.2=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libITKCommon-5.2.so.1')")
cat > blob.cpp <<'C'
#include <itkGaussianSpatialObject.h>
#include <itkImage.h>
#include <itkImageRegionConstIteratorWithIndex.h>
#include <itkSpatialObjectToImageFilter.h>
#include <itkVersion.h>
#include <cmath>
#include <cstdio>
using Blob = itk::GaussianSpatialObject<2>;
using Image = itk::Image<double, 2>;
// A blob of maximum 1, sigma 1 and radius 3 about (x, 0), put there by its centre or by its transformation.
Blob::Pointer blob(double x, bool by_center) {
  auto b = Blob::New();
  b->SetMaximum(1), b->SetSigmaInObjectSpace(1), b->SetRadiusInObjectSpace(3);
  Blob::PointType center;
  center[0] = x, center[1] = 0;
  if (by_center) b->SetCenterInObjectSpace(center);
  else {
    auto move = Blob::TransformType::New();
    move->SetOffset(center.GetVectorFromOrigin());
    b->SetObjectToParentTransform(move);
  }
  b->Update();
  return b;
}
double value(Blob* b, double x) {
  Blob::PointType p;
  p[0] = x, p[1] = 0;
  double v = 0;
  b->ValueAtInWorldSpace(p, v);
  return v;
}
bool inside(Blob* b, double x) {
  Blob::PointType p;
  p[0] = x, p[1] = 0;
  return b->IsInsideInWorldSpace(p);
}
// Mass and centre of gravity of the blob drawn into an image.
void drawn(Blob* b, double x, double& mass, double& middle) {
  auto filter = itk::SpatialObjectToImageFilter<Blob, Image>::New();
  Image::SizeType size = {{161, 161}};
  const double spacing[] = {0.05, 0.05}, origin[] = {x - 4, -4};
  filter->SetInput(b), filter->SetSize(size), filter->SetSpacing(spacing), filter->SetOrigin(origin);
  filter->SetUseObjectValue(true), filter->SetOutsideValue(0);
  filter->Update();
  mass = middle = 0;
  itk::ImageRegionConstIteratorWithIndex<Image> it(filter->GetOutput(), filter->GetOutput()->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it) {
    Image::PointType p;
    filter->GetOutput()->TransformIndexToPhysicalPoint(it.GetIndex(), p);
    mass += it.Get() * 0.0025, middle += it.Get() * 0.0025 * p[0];
  }
  middle /= mass;
}
int main() {
  std::printf("ITK %s\n", itk::Version::GetITKVersion());
  bool good = true;
  const double full = 2 * std::acos(-1.) * (1 - std::exp(-4.5)); // of a bell of sigma 1 up to 3 sigma
  for (const double x : {0., 4., 40.}) for (const bool by_center : {true, false}) {
    auto b = blob(x, by_center);
    std::printf("centre %g by %s: values at -3 .. 3 sigma beside it", x, by_center ? "SetCenterInObjectSpace()" : "the transformation");
    for (int k = -3; k <= 3; ++k) {
      const double given = value(b, x + 0.99 * k), from = by_center ? x + 0.99 * k : 0.99 * k;
      std::printf(" %.4f", given);
      good &= std::abs(given - std::exp(-from * from / 2)) < 1e-9 && inside(b, x + 0.99 * k);
    }
    good &= !inside(b, x + 3.1) && std::abs(b->GetEllipsoid()->GetCenterInObjectSpace()[0] - (by_center ? x : 0)) < 1e-9;
    double mass, middle;
    drawn(b, x, mass, middle);
    std::printf("; drawn: mass %.3g (right %.3f), centre of gravity at %.2f\n", mass, full, middle);
    const bool right = x == 0 || !by_center;
    good &= right ? std::abs(mass - full) < 0.05 && std::abs(middle - x) < 0.01
                  : x == 4 ? std::abs(mass - 0.784) < 0.01 && std::abs(middle - 1.62) < 0.01 : mass < 1e-200;
  }
  return !good;
}
C
c++ -std=c++17 -O0 -w -I root/usr/include/ITK-5.2 blob.cpp -o blob -L "$lib" -lITKSpatialObjects-5.2 -lITKTransform-5.2 -lITKCommon-5.2 \
  -litksys-5.2 -litkvnl-5.2 -litkvnl_algo-5.2 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./blob
