#!/bin/sh
# mlpack 4.6.0 (Debian 13): of the triangular kernel max(0, 1 - |x - y| / b) only the form that takes two points knows the bandwidth b. The one that
# takes their distance, TriangularKernel::Evaluate(double), has (1 - d) / b, so that the bandwidth is a mere factor and the width is always 1, in
# whatever unit; Gradient() likewise ends at 1. KDE, which calls the form with the distance throughout, for its bounds as well, thus gives for b =
# 0.5 densities too high by 2 and more and not 0 beyond 0.5; the same data in millimetres, with b = 500, give next to nothing: sums of a handful of
# pairs closer than 1 mm, each over 500. With b = 1, the default, all is right, and so are KernelPCA and FastMKS, which use two points. The other
# kernels agree with themselves (shown here: Epanechnikov, Gaussian, Laplacian, spherical). The documentation gives the formula above for all
# uses, with 'b' the bandwidth, and mlpack_kde offers 'triangular' with --bandwidth. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Debian 13's packages, whatever release this is; the sources are the machine's own with the name exchanged.
mkdir -p apt/parts apt/lists/partial apt/cache/archives/partial
for source in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
  [ -f "$source" ] && sed 's/bookworm/trixie/g' "$source" > "apt/parts/debian.${source##*.}"
done
from() {
  command=$1
  shift
  "apt-$command" -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$folder/apt/parts" -o "Dir::State::lists=$folder/apt/lists" \
    -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User=root -qq "$@"
}
from get update
from get download libmlpack-dev=4.6.0-1 libensmallen-dev=2.22.1-2 libarmadillo-dev=1:14.2.3+dfsg-1+b1 libcereal-dev=1.3.2+dfsg-5 \
  rapidjson-dev=1.1.0+dfsg2-7.4 libstb-dev=0.0~git20241109.5c20573+ds-1
for package in *.deb; do dpkg -x "$package" root; done
cat > kde.cpp <<'C'
#define ARMA_DONT_USE_WRAPPER
#define MLPACK_USE_SYSTEM_STB
#include <mlpack/core.hpp>
#include <mlpack/methods/kde.hpp>
#include <cmath>
#include <cstdio>
using namespace mlpack;
static bool as_described = true;
// The greatest difference between the two forms, for distances up to 3.
template <class Kernel>
static double difference(const Kernel& kernel) {
  double most = 0;
  for (int i = 0; i <= 60; ++i) {
    const arma::vec a{0.}, b{0.05 * i};
    most = std::max(most, std::abs(kernel.Evaluate(a, b) - kernel.Evaluate(0.05 * i)));
  }
  return most;
}
// Densities at three points, by KDE without tolerance and by the sum over all pairs with the form for two points.
template <class Kernel>
static void densities(const char* what, double unit, double bandwidth, const double (&seen)[3]) {
  Kernel kernel(bandwidth * unit);
  const arma::mat data = unit * arma::mat{{0, 0.1, 0.2, 0.3, 3}}, at = unit * arma::mat{{0.1, 0.9, 2}};
  arma::vec found;
  KDE<Kernel> kde(0.0, 0.0, kernel);
  kde.Train(data);
  kde.Evaluate(at, found);
  std::printf("%-12s b = %-4g unit 1/%-4g", what, bandwidth * unit, unit);
  for (arma::uword i = 0; i < 3; ++i) {
    double sum = 0;
    for (arma::uword j = 0; j < data.n_cols; ++j) sum += kernel.Evaluate(at.col(i), data.col(j));
    std::printf("  %.4f (pairs: %.4f)", found(i), sum / data.n_cols);
    as_described = as_described && std::abs(found(i) - seen[i]) < 5e-5;
    if (bandwidth == 1 || std::string(what) != "triangular") as_described = as_described && std::abs(found(i) - sum / data.n_cols) < 5e-5;
  }
  std::puts("");
}
int main() {
  std::printf("mlpack %d.%d.%d\n", MLPACK_VERSION_MAJOR, MLPACK_VERSION_MINOR, MLPACK_VERSION_PATCH);
  const TriangularKernel two(2.0);
  for (double d : {0., 0.5, 1., 1.5, 2.5}) {
    const arma::vec a{0.}, b{d};
    std::printf("triangular, b = 2, distance %.1f: two points %.2f, their distance %.2f\n", d, two.Evaluate(a, b), two.Evaluate(d));
    as_described = as_described && std::abs(two.Evaluate(a, b) - std::max(0., 1 - d / 2)) < 1e-12;
    as_described = as_described && std::abs(two.Evaluate(d) - std::max(0., (1 - d) / 2)) < 1e-12;
  }
  std::printf("greatest difference of the two forms, b = 2: triangular %.3f, Epanechnikov %.3f, Gaussian %.3f, Laplacian %.3f, spherical %.3f\n",
              difference(two), difference(EpanechnikovKernel(2.0)), difference(GaussianKernel(2.0)), difference(LaplacianKernel(2.0)),
              difference(SphericalKernel(2.0)));
  as_described = as_described && std::abs(difference(two) - 0.5) < 1e-12 && difference(EpanechnikovKernel(2.0)) < 1e-12 &&
                 difference(GaussianKernel(2.0)) < 1e-12 && difference(LaplacianKernel(2.0)) < 1e-12 && difference(SphericalKernel(2.0)) < 1e-12;
  std::puts("mean kernel value at three points (0.1, 0.9, 2) of five data");
  densities<TriangularKernel>("triangular", 1, 0.5, {1.44, 0.4, 0});
  densities<TriangularKernel>("triangular", 1000, 0.5, {0.0004, 0, 0});
  densities<TriangularKernel>("triangular", 1, 1, {0.72, 0.2, 0});
  densities<EpanechnikovKernel>("Epanechnikov", 1, 0.5, {0.752, 0, 0});
  densities<EpanechnikovKernel>("Epanechnikov", 1000, 0.5, {0.752, 0, 0});
  return !as_described;
}
C
c++ -std=c++17 -O1 -w -I root/usr/include -I root/usr/include/stb kde.cpp -o kde -Wl,--unresolved-symbols=ignore-all
./kde
