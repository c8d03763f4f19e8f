#!/bin/sh
# VTK 9.1.0 (Debian 12): vtkVoxelGrid thins a cloud of points, one mean point for each occupied bin, and its point data do not belong to its points.
# RequestData() computes the means of all arrays with the kernel one can set, and then adds the arrays of the input to the output, which replaces
# those of the same names: the n points of the result have the values of the first n points of the input, in the input's order. The arrays are as
# long as those of the input, which one does not see who asks for the value of a point by its index. Of a scan, line by line, colours,
# normals and intensities are then those of its first lines, smooth and plausible. Nothing is said. The points themselves are right, and a field
# linear in x, y, z should have at a mean point the mean of its values.
set -eu
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvtk9.1=$version" "libvtk9-dev=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libvtkCommonCore-9.1.so.1' | head -n 1)")
cat > thin.cpp <<'C'
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkVersion.h>
#include <vtkVoxelGrid.h>
#include <cmath>
#include <cstdio>
int main() {
  std::printf("VTK %s\n", vtkVersion::GetVTKVersion());
  // A scan of 60 lines of 60 points on a slope; with each point its height once more as a value.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> height;
  height->SetName("height");
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 60; ++i) {
      const double z = 0.2 * i + 0.5 * j;
      points->InsertNextPoint(i, j, z);
      height->InsertNextValue(z);
    }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetScalars(height);
  bool as_described = true;
  for (int style = 0; style < 3; ++style) {
    vtkNew<vtkVoxelGrid> grid;
    grid->SetInputData(cloud);
    if (style == 0) grid->SetConfigurationStyleToAutomatic();
    if (style == 1) grid->SetConfigurationStyleToLeafSize(), grid->SetLeafSize(5, 5, 50);
    if (style == 2) grid->SetConfigurationStyleToManual(), grid->SetDivisions(10, 10, 1);
    grid->Update();
    vtkPolyData* thinned = grid->GetOutput();
    vtkDataArray* values = thinned->GetPointData()->GetArray("height");
    const vtkIdType n = thinned->GetNumberOfPoints();
    double off = 0, plane = 0, first = 0;
    for (vtkIdType i = 0; i < n; ++i) {
      double x[3];
      thinned->GetPoint(i, x);
      plane = std::fmax(plane, std::abs(x[2] - 0.2 * x[0] - 0.5 * x[1]));
      off += std::abs(values->GetTuple1(i) - x[2]) / n;
      first = std::fmax(first, std::abs(values->GetTuple1(i) - height->GetValue(i)));
    }
    std::printf("%s: %d points, off the slope by %.1e; %d values, off the height of their points by %.2f on average, off those of the input by %g\n",
                style == 0 ? "automatic" : style == 1 ? "leaf size" : "manual", (int)n, plane, (int)values->GetNumberOfTuples(), off, first);
    as_described = as_described && n > 20 && n < 1800 && plane < 1e-9 && off > 5 && first == 0 && values->GetNumberOfTuples() == 3600;
  }
  return !as_described;
}
C
inc=$(dirname "$(find root -name vtkVoxelGrid.h | head -n 1)")
names="FiltersPoints FiltersModeling CommonExecutionModel CommonDataModel CommonTransforms CommonMisc CommonSystem CommonMath CommonCore sys"
c++ -std=c++17 -O0 -w -I "$inc" thin.cpp -o thin $(for name in $names; do echo "$lib/libvtk$name-9.1.so.1"; done) -Wl,-rpath-link,"$lib" \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./thin
