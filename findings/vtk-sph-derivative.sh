#!/bin/sh
# VTK 9.1.0 (Debian 12): to ask vtkSPHInterpolator for a derivative changes everything else it interpolates. With AddDerivativeArray() the weights of
# all arrays come from vtkSPHKernel::ComputeDerivWeights(), which takes the kernel's own volume (step^3) for each particle, where ComputeWeights()
# takes mass / density if the two arrays are named. With the step 1.5 times the particles' spacing, an ordinary choice, a density of 1000
# becomes 3375 and all else is 3.375 times what it was, for no other reason than that call. What it is for, the array 'X_deriv', is no derivative
# along anything: the kernel's slope is summed without the direction to the particle, and without 1/step, so that one number is left that
# goes with the values and not with their changes. A constant 1 has -7.7, x (slope 1) has 0 where x is 0 and the other sign on the other side, and
# to add a constant changes it. The help has 'arrays whose derivative is to be taken'. Nothing is said. Where step^3 happens to be each
# particle's volume the other arrays are right; without the call, all are.
set -eu
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvtk9.1=$version" "libvtk9-dev=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libvtkCommonCore-9.1.so.1' | head -n 1)")
cat > fluid.cpp <<'C'
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSPHInterpolator.h>
#include <vtkSPHQuinticKernel.h>
#include <vtkVersion.h>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
const char* fields[] = {"density", "one", "x", "x + 5"};
using Values = std::map<std::string, double>;
// A block of particles 0.1 apart, each of mass 1 and density 1000; the values interpolated at (x, 0.11, -0.17).
Values at(double x, double step, bool derivatives) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> arrays[5];
  for (int k = 0; k < 4; ++k) arrays[k]->SetName(fields[k]);
  arrays[4]->SetName("mass");
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j)
      for (int k = -10; k <= 10; ++k) {
        points->InsertNextPoint(0.1 * i, 0.1 * j, 0.1 * k);
        const double value[] = {1000, 1, 0.1 * i, 0.1 * i + 5, 1};
        for (int a = 0; a < 5; ++a) arrays[a]->InsertNextValue(value[a]);
      }
  vtkNew<vtkPolyData> particles, probe;
  particles->SetPoints(points);
  for (auto& a : arrays) particles->GetPointData()->AddArray(a);
  vtkNew<vtkPoints> where;
  where->SetDataTypeToDouble();
  where->InsertNextPoint(x, 0.11, -0.17);
  probe->SetPoints(where);
  vtkNew<vtkSPHQuinticKernel> kernel;
  kernel->SetSpatialStep(step);
  vtkNew<vtkSPHInterpolator> sph;
  sph->SetInputData(probe);
  sph->SetSourceData(particles);
  sph->SetKernel(kernel);
  sph->SetDensityArrayName("density");
  sph->SetMassArrayName("mass");
  if (derivatives)
    for (int k = 1; k < 4; ++k) sph->AddDerivativeArray(fields[k]);
  sph->Update();
  Values v;
  vtkPointData* out = sph->GetOutput()->GetPointData();
  for (int a = 0; a < out->GetNumberOfArrays(); ++a) v[out->GetArrayName(a)] = out->GetArray(a)->GetTuple1(0);
  return v;
}
bool near(double a, double b, double by) { return std::abs(a - b) <= by; }
int main() {
  std::printf("VTK %s\n", vtkVersion::GetVTKVersion());
  bool good = true;
  for (const double step : {0.1, 0.15, 0.2}) {
    const double factor = std::pow(step / 0.1, 3);
    Values before = at(0.23, step, false), after = at(0.23, step, true);
    std::printf("step %g, particles 0.1 apart, at x = 0.23\n  without derivatives:", step);
    for (const char* f : fields) std::printf(" %s %.3f", f, before[f]);
    std::printf("\n  with AddDerivativeArray():");
    for (const char* f : fields) {
      std::printf(" %s %.3f", f, after[f]);
      good &= near(after[f], factor * before[f], 1e-6 * std::abs(after[f]));
    }
    good &= near(before["density"], 1000, 0.1) && near(before["one"], 1, 1e-4) && near(before["x"], 0.23, 1e-3) && near(before["x + 5"], 5.23, 1e-3);
    std::printf("\n");
  }
  for (const double x : {-0.23, 0., 0.23}) {
    const double h = 1e-4, step = 0.15;
    Values v = at(x, step, true), more = at(x + h, step, false), less = at(x - h, step, false);
    std::printf("step %g, x = %g:", step, x);
    for (int k = 1; k < 4; ++k) {
      const std::string f = fields[k];
      const double slope = (more[f] - less[f]) / (2 * h);
      std::printf(" %s_deriv %.3f (slope along x %.3f)", f.c_str(), v[f + "_deriv"], slope);
      good &= near(slope, k == 1 ? 0 : 1, 0.01);
    }
    std::printf("\n");
    good &= near(v["one_deriv"], -7.68, 0.1) && near(v["x + 5_deriv"], v["x_deriv"] + 5 * v["one_deriv"], 1e-9);
    good &= x == 0 ? near(v["x_deriv"], 0, 1e-9) : v["x_deriv"] * x < -0.3;
  }
  return !good;
}
C
inc=$(dirname "$(find root -name vtkSPHInterpolator.h | head -n 1)")
names="FiltersPoints FiltersModeling CommonExecutionModel CommonDataModel CommonTransforms CommonMisc CommonSystem CommonMath CommonCore sys"
c++ -std=c++17 -O0 -w -I "$inc" fluid.cpp -o fluid $(for name in $names; do echo "$lib/libvtk$name-9.1.so.1"; done) -Wl,-rpath-link,"$lib" \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./fluid
