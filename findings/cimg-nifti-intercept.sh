#!/bin/sh
# CImg 3.2.1 (Debian 12): of a NIfTI file CImg multiplies the stored values by scl_slope but does not add scl_inter, where NIfTI-1 says 'y =
# scl_slope x + scl_inter' (nifti1.h, DATA SCALING). Its documentation has 'Load image from an ANALYZE7.5/NIFTI file' and no more. nibabel
# chooses slope and intercept itself when floating values go to an integer type: the signed distances to a sphere of radius 8 that it stores
# as int16 come back from CImg 2.392 too low, so that 4680 voxels are inside in place of 2176, with no warning. A file with a slope alone is
# read well, so a look at the slope does not show it.
set -eu
cimg=3.2.1+dfsg-1
nibabel=5.0.0-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "cimg-dev=$cimg" "python3-nibabel=$nibabel" python3-numpy=1:1.24.2-1+deb12u1 python3-packaging=23.0-1 libblas3 liblapack3 \
  libgfortran5 libquadmath0
for package in *.deb; do dpkg -x "$package" root; done
cat > ball.py <<'P'
import nibabel as nib
import numpy as np

i = np.arange(24)[:, None, None] - 11.5
distance = np.sqrt(i**2 + i.reshape(1, -1, 1) ** 2 + i.reshape(1, 1, -1) ** 2) - 8
image = nib.Nifti1Image(distance, np.eye(4))
image.set_data_dtype(np.int16)
nib.save(image, "ball.nii")
read = nib.load("ball.nii")
back = read.get_fdata()
print(f"slope {read.dataobj.slope:.6f}, intercept {read.dataobj.inter:.3f}")
print(f"nibabel {nib.__version__}: {back.min():.3f} to {back.max():.3f}, {(back < 0).sum()} voxels inside")
P
lib=root/usr/lib/x86_64-linux-gnu
LD_LIBRARY_PATH=$lib:$lib/blas:$lib/lapack PYTHONPATH=root/usr/lib/python3/dist-packages /usr/bin/python3 ball.py | tee seen
cat > ball.cpp <<'C'
#define cimg_display 0
#include <CImg.h>
#include <cstdio>
int main() {
  const cimg_library::CImg<float> image("ball.nii");
  int inside = 0;
  cimg_for(image, value, float) inside += *value < 0;
  std::printf("CImg %d: %.3f to %.3f, %d voxels inside\n", cimg_version, image.min(), image.max(), inside);
}
C
c++ -O0 -w -I root/usr/include ball.cpp -o ball -lpthread
./ball | tee -a seen
grep -q 'nibabel 5.0.0: -7.134 to 11.919, 2176 voxels' seen && grep -q 'CImg 321: -9.526 to 9.526, 4680 voxels' seen
