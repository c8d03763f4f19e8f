#!/bin/sh
# VIGRA 1.11.1 (Debian 12): gaussianDivergenceMultiArray() takes the step sizes of anisotropic data for the width of its filters only. A derivative
# along an axis is to be multiplied by 1/stepSize (documentation of ConvolutionOptions::stepSize()), for which gradient, Laplacian and
# Hessian scale their kernels (detail::scaleKernel); in the divergence that line is missing, and the three derivatives, per voxel, are added. At
# 0.5 x 1 x 2 mm a displacement that keeps the volume, (x, y, -2z), has divergence -2.5 instead of 0, a swelling loses its amount, and the
# divergence of the gradient is not the Laplacian. With equal steps other than 1 all is off by that factor; with steps of 1 nothing is. Nothing is
# said, and its own example is of anisotropic data.
set -eu
version=1.11.1+dfsg-11
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvigraimpex-dev=$version"
dpkg -x libvigraimpex-dev_*.deb root
cat > divergence.cpp <<'C'
#include <vigra/config_version.hxx>
#include <vigra/multi_array.hxx>
#include <vigra/multi_convolution.hxx>
#include <cmath>
#include <cstdio>
using namespace vigra;
using Vector = TinyVector<double, 3>;
static const Shape3 shape(40, 32, 24), middle(20, 16, 12);
// In the middle of the volume: the divergence of (a x, b y, c z), all in mm, with voxels of the given size.
double divergence(const Vector& size, const Vector& abc) {
  MultiArray<3, Vector> field(shape);
  for (int k = 0; k < shape[2]; ++k)
    for (int j = 0; j < shape[1]; ++j)
      for (int i = 0; i < shape[0]; ++i) field(i, j, k) = Vector(abc[0] * size[0] * i, abc[1] * size[1] * j, abc[2] * size[2] * k);
  MultiArray<3, double> result(shape);
  gaussianDivergenceMultiArray(field, result, 2 * size[0], ConvolutionOptions<3>().stepSize(size));
  return result[middle];
}
int main() {
  std::printf("VIGRA %s\n", VIGRA_VERSION);
  const Vector one(1, 1, 1), half(0.5, 0.5, 0.5), sizes(0.5, 1, 2), keeps(1, 1, -2), swells(0.1, 0.1, 0.1);
  const double keep1 = divergence(one, keeps), keep2 = divergence(half, keeps), keep3 = divergence(sizes, keeps);
  const double swell1 = divergence(one, swells), swell2 = divergence(half, swells), swell3 = divergence(sizes, swells);
  std::printf("voxels of 1 x 1 x 1, 0.5 x 0.5 x 0.5, 0.5 x 1 x 2 mm:\n");
  std::printf("  divergence of (x, y, -2z), 0:     %8.4f %8.4f %8.4f\n", keep1, keep2, keep3);
  std::printf("  divergence of 0.1 (x, y, z), 0.3: %8.4f %8.4f %8.4f\n", swell1, swell2, swell3);
  // The divergence of a gradient beside the Laplacian, of x^2 + y^2 + z^2 with the last voxels.
  MultiArray<3, double> f(shape), laplacian(shape), sum(shape);
  for (int k = 0; k < shape[2]; ++k)
    for (int j = 0; j < shape[1]; ++j)
      for (int i = 0; i < shape[0]; ++i)
        f(i, j, k) = std::pow(sizes[0] * (i - 20), 2) + std::pow(sizes[1] * (j - 16), 2) + std::pow(sizes[2] * (k - 12), 2);
  MultiArray<3, Vector> gradient(shape);
  const auto options = ConvolutionOptions<3>().stepSize(sizes);
  gaussianGradientMultiArray(f, gradient, 1.0, options);
  laplacianOfGaussianMultiArray(f, laplacian, 1.0, options);
  gaussianDivergenceMultiArray(gradient, sum, 1.0, options);
  const Vector g = gradient(22, 18, 13);
  std::printf("of x^2 + y^2 + z^2: gradient at (1, 2, 2): %.4f %.4f %.4f; Laplacian, 6: %.4f; divergence of the gradient: %.4f\n", g[0], g[1], g[2],
              laplacian[middle], sum[middle]);
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-4; };
  const bool right = near(keep1, 0) && near(swell1, 0.3) && near(g[0], 2) && near(g[1], 4) && near(g[2], 4) && near(laplacian[middle], 6);
  return !(right && near(keep2, 0) && near(keep3, -2.5) && near(swell2, 0.15) && near(swell3, 0.35) && near(sum[middle], 7));
}
C
c++ -std=c++14 -O1 -w -I root/usr/include divergence.cpp -o divergence
./divergence
