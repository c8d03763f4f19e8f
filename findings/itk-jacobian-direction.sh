#!/bin/sh
# ITK 5.2.1 (Debian 12): DisplacementFieldJacobianDeterminantFilter reckons with the spacing of the field, but not with its direction. The vectors
# of a displacement field are in physical space, the differences are along the axes of the index (EvaluateAtNeighborhood), and the matrix that
# turns the one into the other is left out. With the direction -1,-1,1, which fields from NIfTI files in RAS order have, a swelling by 10 % along
# each axis, volume 1.331, has determinant 0.891, as if it shrank, and a field that turns the body over (-1) has 3, so that a fold looks sound. In
# a field with sagittal slices a swelling by 10, 20 and 30 % has 1.006 in place of 1.716, and there DisplacementFieldTransform, by which one may
# check, has 1.006 too. Nothing is said. The field of the same motion with direction 1,1,1 is right in both. The filter was mended in 2025.
set -eu
version=5.2.1-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libinsighttoolkit5-dev=$version" "libinsighttoolkit5.2=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libITKCommon-5.2.so.1')")
cat > swell.cpp <<'C'
#include <itkDisplacementFieldJacobianDeterminantFilter.h>
#include <itkDisplacementFieldTransform.h>
#include <itkImageRegionIteratorWithIndex.h>
#include <itkVersion.h>
#include <cmath>
#include <cstdio>
using Field = itk::Image<itk::Vector<double, 3>, 3>;
using Transform = itk::DisplacementFieldTransform<double, 3>;
// Prints the determinants of x -> x + s x, whose is (1 + sx)(1 + sy)(1 + sz), on a grid of the given direction; compares what is found.
bool is_found(const char* name, const Field::DirectionType& direction, double sx, double sy, double sz, double by_filter, double by_transform) {
  auto field = Field::New();
  field->SetRegions(Field::SizeType{{7, 7, 7}});
  const double spacing[3] = {1, 2, 3};
  field->SetSpacing(spacing);
  field->SetDirection(direction);
  field->Allocate();
  for (itk::ImageRegionIteratorWithIndex<Field> it(field, field->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it) {
    Field::PointType x;
    field->TransformIndexToPhysicalPoint(it.GetIndex(), x);
    it.Value()[0] = sx * x[0], it.Value()[1] = sy * x[1], it.Value()[2] = sz * x[2];
  }
  const Field::IndexType middle{{3, 3, 3}};
  auto filter = itk::DisplacementFieldJacobianDeterminantFilter<Field, double>::New();
  filter->SetInput(field);
  filter->Update();
  const double found = filter->GetOutput()->GetPixel(middle);
  auto transform = Transform::New();
  transform->SetDisplacementField(field);
  Field::PointType x;
  field->TransformIndexToPhysicalPoint(middle, x);
  Transform::JacobianPositionType jacobian;
  transform->ComputeJacobianWithRespectToPosition(x, jacobian);
  std::printf("%-28s stretched by %g %g %g: right %.3f, DisplacementFieldTransform %.3f, the filter %.3f\n", name, 1 + sx, 1 + sy, 1 + sz,
              (1 + sx) * (1 + sy) * (1 + sz), vnl_determinant(jacobian), found);
  return std::abs(found - by_filter) < 1e-6 && std::abs(vnl_determinant(jacobian) - by_transform) < 1e-6;
}
int main() {
  std::printf("ITK %s\n", itk::Version::GetITKVersion());
  Field::DirectionType identity, ras, sagittal;
  identity.SetIdentity(), ras.SetIdentity();
  ras[0][0] = ras[1][1] = -1;
  sagittal.Fill(0);
  sagittal[1][0] = sagittal[2][1] = sagittal[0][2] = 1;
  bool as_described = is_found("direction 1 1 1,", identity, 0.1, 0.1, 0.1, 1.331, 1.331);
  as_described &= is_found("direction -1 -1 1,", ras, 0.1, 0.1, 0.1, 0.891, 1.331);
  as_described &= is_found("direction -1 -1 1,", ras, -2, 0, 0, 3, -1);
  as_described &= is_found("sagittal slices,", sagittal, 0.1, 0.2, 0.3, 1.006, 1.006);
  return !as_described;
}
C
c++ -std=c++17 -w -I root/usr/include/ITK-5.2 swell.cpp -o swell -L "$lib" -lITKTransform-5.2 -lITKCommon-5.2 -litksys-5.2 -litkvnl-5.2 -litkvnl_algo-5.2 \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./swell
