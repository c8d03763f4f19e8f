#!/bin/sh
# ITK 5.2.1 (Debian 12; 5.4.3 of Debian 13 gives the same) reads an NRRD whose space is left-anterior-superior half a turn about z from where
# it lies: into its own LPS it turns the x axis over, left and right, in place of y. Volumes in LPS and RAS are where they belong. Teem, on
# which the segmentations of 3D Slicer are read, has LAS right, so that there a scan and its .seg.nrrd of one header do not lie on each other.
set -eu
version=5.2.1-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libinsighttoolkit5-dev=$version" "libinsighttoolkit5.2=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libITKCommon-5.2.so.1')")

cat > las.cpp <<'C'
#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkNrrdImageIO.h>
#include <itkVersion.h>
#include <cstdio>
#include <fstream>
#include <string>
// Where ITK has the first voxel of a volume that begins at `origin` of `space`.
itk::Point<double, 3> place(const std::string& space, const std::string& origin) {
  std::ofstream("a.nrrd") << "NRRD0005\ntype: uint8\ndimension: 3\nspace: " << space << "\nsizes: 2 2 2\n"
                          << "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: " << origin << "\nencoding: raw\n\n12345678";
  auto reader = itk::ImageFileReader<itk::Image<unsigned char, 3>>::New();
  reader->SetImageIO(itk::NrrdImageIO::New());
  reader->SetFileName("a.nrrd");
  reader->Update();
  return reader->GetOutput()->GetOrigin();
}
int main() {
  std::printf("ITK %s, a point 10 to the left, 20 to the front and 30 up, which is (10,-20,30) in its LPS\n", itk::Version::GetITKVersion());
  const auto is = [](const itk::Point<double, 3>& p, double x, double y) { return p[0] == x && p[1] == y && p[2] == 30; };
  const auto lps = place("left-posterior-superior", "(10,-20,30)"), ras = place("right-anterior-superior", "(-10,20,30)"),
             las = place("left-anterior-superior", "(10,20,30)");
  std::printf("from LPS (%g,%g,%g), from RAS (%g,%g,%g), from LAS (%g,%g,%g)\n", lps[0], lps[1], lps[2], ras[0], ras[1], ras[2], las[0], las[1], las[2]);
  return !(is(lps, 10, -20) && is(ras, 10, -20) && is(las, -10, 20));
}
C
c++ -std=c++17 -w -I root/usr/include/ITK-5.2 las.cpp -o las -L "$lib" -lITKIONRRD-5.2 -lITKIOImageBase-5.2 -lITKCommon-5.2 -litksys-5.2 \
  -lITKNrrdIO-5.2 -litkvnl-5.2 -litkvnl_algo-5.2 -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH=$lib ./las
