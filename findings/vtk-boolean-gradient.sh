#!/bin/sh
# VTK 9.1.0 (Debian 12): vtkImplicitBoolean has the right values and wrong gradients. In EvaluateGradient() an 'else' is missing before 'union of
# magnitudes', so that what was found for a union or an intersection is written over by what follows for a difference; and there the sign of the
# first function is turned, which is right for those taken away only. So every union and intersection has the gradient of 'the first without the
# others', and that points inward for the first: a union of one sphere has the opposite of the sphere's gradient, and beside the second of two
# spheres it is minus that of the first. A step of Newton's method leads away from the surface, and the normals of vtkSampleFunction,
# which it makes by default, look the other way for a union than for its parts. Contours, clips and insides, which need values alone, are right,
# and so are filters that make normals from the sampled values. Nothing is said. vtkImplicitSum, with the same test, is right.
set -eu
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvtk9.1=$version" "libvtk9-dev=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libvtkCommonCore-9.1.so.1' | head -n 1)")
cat > boolean.cpp <<'C'
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImplicitBoolean.h>
#include <vtkImplicitSum.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSampleFunction.h>
#include <vtkSphere.h>
#include <vtkVersion.h>
#include <cmath>
#include <cstdio>
// Cosine between the gradient that the function gives and that of its values (differences over 2e-5), at a point near where |f| = 1/2.
double cosine(vtkImplicitFunction* f, const double at[3]) {
  double given[3], real[3], dot = 0, a = 0, b = 0;
  f->FunctionGradient(at, given);
  for (int k = 0; k < 3; ++k) {
    double more[3] = {at[0], at[1], at[2]}, less[3] = {at[0], at[1], at[2]};
    more[k] += 1e-5;
    less[k] -= 1e-5;
    real[k] = (f->FunctionValue(more) - f->FunctionValue(less)) / 2e-5;
    dot += given[k] * real[k];
    a += given[k] * given[k];
    b += real[k] * real[k];
  }
  return dot / std::sqrt(a * b);
}
// Mean cosine between vtkSampleFunction's normals and the outward direction, in a shell about the unit sphere at the origin.
double outward(vtkImplicitFunction* f) {
  vtkNew<vtkSampleFunction> sample;
  sample->SetImplicitFunction(f);
  sample->SetModelBounds(-2, 2, -2, 2, -2, 2);
  sample->SetSampleDimensions(21, 21, 21);
  sample->Update();
  vtkImageData* image = sample->GetOutput();
  vtkDataArray* normals = image->GetPointData()->GetNormals();
  double sum = 0;
  int count = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i) {
    double x[3], n[3];
    image->GetPoint(i, x);
    normals->GetTuple(i, n);
    const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    if (std::abs(r - 1) > 0.2) continue;
    sum += (x[0] * n[0] + x[1] * n[1] + x[2] * n[2]) / r;
    ++count;
  }
  return sum / count;
}
int main() {
  std::printf("VTK %s\n", vtkVersion::GetVTKVersion());
  vtkNew<vtkSphere> first, second;
  first->SetRadius(1);
  second->SetRadius(1);
  second->SetCenter(1.5, 0, 0);
  // Beside the first sphere, beside the second, and within both, nearer to the surface of the first.
  const double points[3][3] = {{-0.9, 0.3, 0.5}, {1.9, 0.9, 0.3}, {0.85, 0.1, 0.2}};
  bool as_described = true;
  vtkNew<vtkImplicitSum> sum;
  sum->AddFunction(first, 2);
  sum->AddFunction(second, -0.5);
  std::printf("cosine of the gradient given and the real one, beside the first, beside the second, in both:\n  sum:         ");
  for (const auto& p : points) std::printf(" %7.3f", cosine(sum, p)), as_described &= cosine(sum, p) > 0.999;
  const char* names[] = {"union", "intersection", "difference"};
  for (int operation = 0; operation < 3; ++operation) {
    vtkNew<vtkImplicitBoolean> both;
    both->AddFunction(first);
    both->AddFunction(second);
    both->SetOperationType(operation);
    std::printf("\n  %-13s", names[operation]);
    double c[3];
    for (int i = 0; i < 3; ++i) std::printf(" %7.3f", c[i] = cosine(both, points[i]));
    // Values are those of the smaller, of the larger, and of the larger of the first and minus the second.
    for (const auto& p : points) {
      const double f = first->FunctionValue(p), s = second->FunctionValue(p);
      as_described &= both->FunctionValue(p) == (operation == 0 ? std::fmin(f, s) : operation == 1 ? std::fmax(f, s) : std::fmax(f, -s));
    }
    if (operation == 0) as_described &= c[0] < -0.999 && std::abs(c[1]) < 0.95;
    if (operation == 1) as_described &= std::abs(c[0]) < 0.95 && c[1] < -0.999;
    if (operation == 2) as_described &= c[0] < -0.999 && c[2] > 0.999; // only where the second is taken away is it right
  }
  vtkNew<vtkImplicitBoolean> alone;
  alone->AddFunction(first);
  alone->SetOperationTypeToUnion();
  const double x[3] = {1.2, 0, 0};
  double g[3];
  alone->FunctionGradient(x, g);
  const double step = -alone->FunctionValue(x) / g[0];
  std::printf("\na union of the first alone, Newton's step from x = 1.2 to the surface at 1: to %.3f\n", x[0] + step);
  const double of_sphere = outward(first), of_union = outward(alone);
  std::printf("normals of vtkSampleFunction, cosine with the outward direction: %.3f for the sphere, %.3f for the union of it alone\n", of_sphere,
              of_union);
  as_described &= x[0] + step > 1.35 && std::abs(of_sphere + 1) < 1e-3 && std::abs(of_union - 1) < 1e-3;
  return !as_described;
}
C
inc=$(dirname "$(find root -name vtkImplicitBoolean.h | head -n 1)")
names="ImagingHybrid ImagingCore CommonExecutionModel CommonDataModel CommonTransforms CommonMisc CommonSystem CommonMath CommonCore sys"
c++ -std=c++17 -O0 -w -I "$inc" boolean.cpp -o boolean $(for name in $names; do echo "$lib/libvtk$name-9.1.so.1"; done) -Wl,-rpath-link,"$lib" \
  -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./boolean
