#!/bin/sh
# VTK 9.1.0 (Debian 12): of an image with a direction matrix, as volumes of patients have, vtkMarchingCubes and vtkFlyingEdges3D put the
# surface where the image says; vtkContourFilter, which picks vtkSynchronizedTemplates3D for images, leaves the matrix out, so that the same
# surface comes out turned about the origin, with the right shape and volume and without a warning.
set -eu
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvtk9.1=$version" "libvtk9-dev=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libvtkCommonCore-9.1.so.1' | head -n 1)")
cat > turned.cpp <<'C'
#include <vtkContourFilter.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMarchingCubes.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <cmath>
#include <cstdio>
// Middle of the surface's bounding box.
template <class Filter>
void middle(const char* name, vtkImageData* image, double* x) {
  vtkNew<Filter> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 0.0);
  filter->Update();
  double box[6];
  filter->GetOutput()->GetBounds(box);
  for (int k = 0; k < 3; ++k) x[k] = 0.5 * (box[2 * k] + box[2 * k + 1]);
  std::printf("%-18s ball at %6.1f %6.1f %6.1f\n", name, x[0], x[1], x[2]);
}
int main() {
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 20, 20);
  image->SetOrigin(100, 0, 0);
  const double direction[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  image->SetDirectionMatrix(direction);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (int k = 0; k < 20; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i)
        image->SetScalarComponentFromDouble(i, j, k, 0, 4 - std::sqrt((i - 6) * (i - 6) + (j - 10) * (j - 10) + (k - 9) * (k - 9)));
  double exact[3], cubes[3], edges[3], contour[3];
  image->TransformContinuousIndexToPhysicalPoint(6, 10, 9, exact);
  std::printf("%-18s ball at %6.1f %6.1f %6.1f\n", "the image", exact[0], exact[1], exact[2]);
  middle<vtkMarchingCubes>("vtkMarchingCubes", image, cubes);
  middle<vtkFlyingEdges3D>("vtkFlyingEdges3D", image, edges);
  middle<vtkContourFilter>("vtkContourFilter", image, contour);
  const auto distance = [&](const double* x) { return std::hypot(std::hypot(x[0] - exact[0], x[1] - exact[1]), x[2] - exact[2]); };
  return !(distance(cubes) < 0.1 && distance(edges) < 0.1 && distance(contour) > 10);
}
C
names="FiltersCore CommonDataModel CommonCore CommonMisc CommonExecutionModel CommonMath CommonTransforms sys"
c++ -O0 -w -std=c++17 -I root/usr/include/vtk-9.1 turned.cpp -o turned $(for name in $names; do echo "$lib/libvtk$name-9.1.so.1"; done) -Wl,-rpath-link,"$lib"
LD_LIBRARY_PATH=$lib ./turned
