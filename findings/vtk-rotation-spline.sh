#!/bin/sh
# VTK 9.1.0 (Debian 12): vtkTransformInterpolator, with its default of splines, loses the rotations of three and more transforms between the first
# and the last. vtkQuaternionInterpolator ends its SQUAD with NormalizeWithAngleInDegrees(), which multiplies w by 180/pi, as if w were the angle
# and not a cosine; so a turn by a becomes one by about 2 tan(a/2) degrees, 30 becomes 0.54. Not even the given transforms are met: one asks for
# the time of the second and gets hardly a turn, and at the last the body jumps to 120 degrees. The quaternion has a norm up to 57 in place of 1.
# The positions are right, two transforms are (they are interpolated linearly), and so is SetInterpolationTypeToLinear(). Nothing is said.
set -eu
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvtk9.1=$version" "libvtk9-dev=$version" libtbb12=2021.8.0-2+deb12u1
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libvtkCommonCore-9.1.so.1' | head -n 1)")
cat > turn.cpp <<'C'
#include <vtkNew.h>
#include <vtkQuaternion.h>
#include <vtkQuaternionInterpolator.h>
#include <vtkTransform.h>
#include <vtkTransformInterpolator.h>
#include <vtkVersion.h>
#include <cmath>
#include <cstdio>
// A body turned by 30 degrees about z and moved by 1 along x from each of `count` times to the next; the most that its turn is off at those times.
double worst(int count, bool linear) {
  vtkNew<vtkTransformInterpolator> interpolator;
  if (linear) interpolator->SetInterpolationTypeToLinear();
  for (int k = 0; k < count; ++k) {
    vtkNew<vtkTransform> given;
    given->Translate(k, 0, 0);
    given->RotateZ(30 * k);
    interpolator->AddTransform(k, given);
  }
  std::printf("%d transforms, %s, place and turn at times 0, 1/2, 1 ...:", count, linear ? "linear" : "default");
  double most = 0;
  for (int i = 0; i <= 2 * (count - 1); ++i) {
    vtkNew<vtkTransform> found;
    interpolator->InterpolateTransform(0.5 * i, found);
    const double turn = found->GetOrientation()[2];
    std::printf(" %.1f %.2f,", found->GetPosition()[0], turn);
    if (i % 2 == 0) most = std::fmax(most, std::abs(turn - 15 * i));
    if (i % 2 == 0 && std::abs(found->GetPosition()[0] - 0.5 * i) > 1e-9) return -1; // not so: at the times given the place is right
  }
  std::puts("");
  return most;
}
int main() {
  std::printf("VTK %s\n", vtkVersion::GetVTKVersion());
  const double two = worst(2, false), linear = worst(5, true), spline = worst(5, false);
  vtkNew<vtkQuaternionInterpolator> quaternions;
  for (int k = 0; k < 4; ++k) quaternions->AddQuaternion(k, vtkQuaterniond(std::cos(0.25 * k), 0, 0, std::sin(0.25 * k)));
  vtkQuaterniond q;
  quaternions->InterpolateQuaternion(1, q);
  std::printf("quaternion given for time 1: %.4f 0 0 %.4f; interpolated there: %.4f %g %g %.4f, of norm %.2f\n", std::cos(0.25), std::sin(0.25), q.GetW(),
              q.GetX(), q.GetY(), q.GetZ(), q.Norm());
  const bool as_described = two >= 0 && two < 1e-9 && linear >= 0 && linear < 1e-9 && spline > 80 &&
    std::abs(q.GetW() - std::cos(0.25) * 180 / std::acos(-1.0)) < 1e-9;
  return !as_described;
}
C
inc=$(dirname "$(find root -name vtkTransformInterpolator.h | head -n 1)")
c++ -std=c++17 -w -I "$inc" turn.cpp -o turn -L "$lib" -l:libvtkRenderingCore-9.1.so.1 -l:libvtkCommonTransforms-9.1.so.1 -l:libvtkCommonMath-9.1.so.1 \
  -l:libvtkCommonCore-9.1.so.1 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./turn
