#!/bin/sh
# VTK 9.1.0 (Debian 12): vtkImageEuclideanDistance takes the voxels' spacing into account along z only, though ConsiderAnisotropy, 'whether
# Spacing should be used', is on by default. It goes over the image once for each axis and asks the image it writes to for the spacing; in the
# passes over x and y that is an intermediate image of vtkImageIterateFilter, which has spacing 1. At 0.5 x 0.5 x 5 mm a voxel 2 mm to the
# side of the body is 4 away, while one 20 mm above it is 20 away. Below a spacing of about 0.7 along z a cast to int overflows besides, and (on
# x86-64) a voxel above the body keeps MaximumDistance, 2147483647. Nothing is said. With spacing 1, or 1 in the slice and thicker slices, all
# is right.
set -eu
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvtk9.1=$version" "libvtk9-dev=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libvtkCommonCore-9.1.so.1' | head -n 1)")
cat > distance.cpp <<'C'
#include <vtkImageData.h>
#include <vtkImageEuclideanDistance.h>
#include <vtkNew.h>
#include <vtkVersion.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
const int n = 13, first = 5, last = 7; // the body, with value 0, is 3 x 3 x 3 voxels amid 13 x 13 x 13
double along_z; // the last one printed
double right(const double* spacing, const int* p) { // squared distance to the nearest voxel of a box of voxels
  double sum = 0;
  for (int a = 0; a < 3; ++a) sum += std::pow(spacing[a] * std::max({0, first - p[a], p[a] - last}), 2);
  return sum;
}
// Prints distances 4 voxels beside the body along each axis; how many voxels of all are wrong.
int wrong(double sx, double sy, double sz) {
  const double spacing[3] = {sx, sy, sz};
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  image->SetSpacing(spacing);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  int p[3], bad = 0;
  for (p[2] = 0; p[2] < n; ++p[2]) for (p[1] = 0; p[1] < n; ++p[1]) for (p[0] = 0; p[0] < n; ++p[0])
    image->SetScalarComponentFromDouble(p[0], p[1], p[2], 0, right(spacing, p) > 0);
  vtkNew<vtkImageEuclideanDistance> filter;
  filter->SetInputData(image);
  filter->Update();
  const auto at = [&](int x, int y, int z) { return filter->GetOutput()->GetScalarComponentAsDouble(x, y, z, 0); };
  for (p[2] = 0; p[2] < n; ++p[2]) for (p[1] = 0; p[1] < n; ++p[1]) for (p[0] = 0; p[0] < n; ++p[0])
    bad += std::abs(at(p[0], p[1], p[2]) - right(spacing, p)) > 1e-9;
  along_z = at(6, 6, 11);
  std::printf("spacing %g %g %g: four voxels beside the body the squared distances are %.10g %.10g %.10g for %g %g %g; wrong in %d of %d voxels\n", sx, sy, sz,
              at(11, 6, 6), at(6, 11, 6), along_z, 16 * sx * sx, 16 * sy * sy, 16 * sz * sz, bad, n * n * n);
  return bad;
}
int main() {
  std::printf("VTK %s\n", vtkVersion::GetVTKVersion());
  const int unit = wrong(1, 1, 1), thick = wrong(1, 1, 5), slices = wrong(0.5, 0.5, 5), x = wrong(2, 1, 1), fine = wrong(0.5, 0.5, 0.5);
  // only voxels with no distance along the axes whose spacing is left out can be right
  bool as_described = unit == 0 && thick == 0 && slices == n * n * n - 9 * n && x == n * n * n - 3 * n * n && fine > 0;
#ifdef __x86_64__
  as_described = as_described && along_z == 2147483647;
#endif
  return !as_described;
}
C
inc=$(dirname "$(find root -name vtkImageData.h | head -n 1)")
c++ -std=c++17 -w -I "$inc" distance.cpp -o distance -L "$lib" -l:libvtkImagingGeneral-9.1.so.1 -l:libvtkImagingCore-9.1.so.1 \
  -l:libvtkCommonExecutionModel-9.1.so.1 -l:libvtkCommonDataModel-9.1.so.1 -l:libvtkCommonCore-9.1.so.1 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./distance
