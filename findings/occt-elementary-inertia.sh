#!/bin/sh
# OpenCASCADE 7.6.3 (Debian 12; the formulas are the same in 7.8.1 of Debian 13): the mass properties that closed formulas give for elementary
# shapes, GProp_VelGProps (solids), GProp_SelGProps (surfaces) and GProp_CelGProps (circles, lines), are mostly wrong. Of a ball, a cylinder or a
# torus about z the matrix of inertia is 0: Perform() multiplies a vector by the matrix of the frame into itself, and math_Vector::Multiply() clears
# what it is to read; with other axes the matrix is not even symmetric, as of P D P' it was to be but D P'. The solids' centres are those of the
# surfaces, half a ball's at R/2 for 3/8 R, half a cylinder's at 2/pi R. The volume of a cone has the square of the length and the sine of the
# angle as factors: parts do not add up, and one that is all but a cylinder has next to no volume. A segment along x has a negative moment, as Izz
# has terms of Ixx. Areas and volumes of balls, cylinders and tori and the centres of whole ones are right, and they are what one looks at.
# BRepGProp, which integrates over faces, has code of its own and is right. The headers promise global properties and name no limits; nothing is said.
set -eu
version=7.6.3+dfsg1-7
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libocct-foundation-dev=$version" "libocct-foundation-7.6=$version" "libocct-modeling-data-dev=$version" \
  "libocct-modeling-data-7.6=$version" "libocct-modeling-algorithms-dev=$version" "libocct-modeling-algorithms-7.6=$version" \
  "libocct-visualization-dev=$version" 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$folder/root/usr/lib/x86_64-linux-gnu
cat > props.cpp <<'C'
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GProp_CelGProps.hxx>
#include <GProp_SelGProps.hxx>
#include <GProp_VelGProps.hxx>
#include <Standard_Version.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Sphere.hxx>
#include <cmath>
#include <cstdio>
static bool as_described = true;
// A figure, what is seen for it now, and what it should be.
static void see(const char* what, double found, double seen, double right) {
  std::printf("  %-58s %9.4f, should be %9.4f\n", what, found, right);
  as_described = as_described && std::abs(found - seen) < 1e-3;
}
static GProp_GProps measured(const TopoDS_Shape& shape) {
  GProp_GProps p;
  BRepGProp::VolumeProperties(shape, p);
  return p;
}
int main() {
  const double pi = M_PI;
  const gp_Pnt o(0, 0, 0);
  const gp_Ax3 z(o, gp_Dir(0, 0, 1)), x(o, gp_Dir(1, 0, 0));
  std::printf("OpenCASCADE %s\n", OCC_VERSION_COMPLETE);

  std::puts("ball of radius 1");
  const GProp_VelGProps ball(gp_Sphere(z, 1), 0, 2 * pi, -pi / 2, pi / 2, o);
  const GProp_GProps ball_measured = measured(BRepPrimAPI_MakeSphere(1.).Shape());
  see("volume", ball.Mass(), 4 * pi / 3, 4 * pi / 3);
  see("moment about the axis z", ball.MomentOfInertia(gp_Ax1(o, gp_Dir(0, 0, 1))), 0, 8 * pi / 15);
  see("moment by BRepGProp", ball_measured.MomentOfInertia(gp_Ax1(o, gp_Dir(0, 0, 1))), 8 * pi / 15, 8 * pi / 15);

  std::puts("upper half of it");
  see("volume", GProp_VelGProps(gp_Sphere(z, 1), 0, 2 * pi, 0, pi / 2, o).Mass(), 2 * pi / 3, 2 * pi / 3);
  see("height of the centre", GProp_VelGProps(gp_Sphere(z, 1), 0, 2 * pi, 0, pi / 2, o).CentreOfMass().Z(), 0.5, 0.375);
  see("height of the centre by BRepGProp", measured(BRepPrimAPI_MakeSphere(1., 0., pi / 2).Shape()).CentreOfMass().Z(), 0.375, 0.375);
  see("height of the centre of its curved surface", GProp_SelGProps(gp_Sphere(z, 1), 0, 2 * pi, 0, pi / 2, o).CentreOfMass().Z(), 0.5, 0.5);

  std::puts("half of a cylinder, radius 2, height 6");
  const GProp_VelGProps half(gp_Cylinder(z, 2), 0, pi, -3, 3, o);
  see("volume", half.Mass(), 12 * pi, 12 * pi);
  see("distance of the centre from the axis", half.CentreOfMass().Y(), 4 / pi, 8 / (3 * pi));
  see("distance by BRepGProp", measured(BRepPrimAPI_MakeCylinder(2., 6., pi).Shape()).CentreOfMass().Y(), 8 / (3 * pi), 8 / (3 * pi));

  std::puts("whole cylinder, radius 2, height 6, along x");
  const GProp_VelGProps along(gp_Cylinder(x, 2), 0, 2 * pi, -3, 3, o);
  see("volume", along.Mass(), 24 * pi, 24 * pi);
  see("moment about its axis, x", along.MatrixOfInertia()(1, 1), 0, 48 * pi);
  see("matrix, row 3, column 1", along.MatrixOfInertia()(3, 1), 96 * pi, 0);
  see("matrix, row 1, column 3", along.MatrixOfInertia()(1, 3), 0, 0);
  see("matrix, row 3, column 3", along.MatrixOfInertia()(3, 3), 96 * pi, 96 * pi);

  std::puts("cone cut off, radii 1 and 2, height 2");
  const double angle = std::atan(0.5), slant = std::sqrt(5.);
  auto cone = [&](double from, double to) { return GProp_VelGProps(gp_Cone(z, angle, 1), 0, 2 * pi, from, to, o).Mass(); };
  see("volume", cone(0, slant), 6 * pi, 14 * pi / 3);
  see("volume by BRepGProp", measured(BRepPrimAPI_MakeCone(1., 2., 2.).Shape()).Mass(), 14 * pi / 3, 14 * pi / 3);
  see("its lower and upper halves added", cone(0, slant / 2) + cone(slant / 2, slant), 3 * pi, 14 * pi / 3);
  see("area of the curved surface", GProp_SelGProps(gp_Cone(z, angle, 1), 0, 2 * pi, 0, slant, o).Mass(), 6 * pi, 3 * pi * slant);
  std::puts("radii 1 and 1.03, height 3, all but a cylinder");
  see("volume", GProp_VelGProps(gp_Cone(z, std::atan(0.01), 1), 0, 2 * pi, 0, 3, o).Mass(), 0.5739, pi * (1 + 1.03 + 1.03 * 1.03));

  std::puts("circle of radius 2 about x");
  const gp_Mat circle = GProp_CelGProps(gp_Circ(gp_Ax2(o, gp_Dir(1, 0, 0)), 2), 0, 2 * pi, o).MatrixOfInertia();
  see("matrix, row 1, column 1", circle(1, 1), 16 * pi, 16 * pi);
  see("matrix, row 2, column 2", circle(2, 2), 0, 8 * pi);
  see("matrix, row 1, column 3", circle(1, 3), 16 * pi, 0);

  std::puts("segment from (1,0,0) to (3,0,0), about its middle");
  const gp_Mat line = GProp_CelGProps(gp_Lin(gp_Pnt(1, 0, 0), gp_Dir(1, 0, 0)), 0, 2, o).MatrixOfInertia();
  see("moment about y", line(2, 2), 2. / 3, 2. / 3);
  see("moment about z", line(3, 3), -16. / 3, 2. / 3);
  return !as_described;
}
C
c++ -std=c++14 -O1 -w -I root/usr/include/opencascade props.cpp -o props -L "$lib" -lTKPrim -lTKTopAlgo -lTKBRep -lTKG3d -lTKGeomBase -lTKMath \
  -lTKernel -Wl,-rpath-link,"$lib" -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./props
