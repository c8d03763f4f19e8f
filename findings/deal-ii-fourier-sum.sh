#!/bin/sh
# deal.II 9.4.1 (Debian 12; the lines are the same in 9.6.2 of Debian 13): the derivatives of FourierSineSum and FourierCosineSum are those of another
# function. value() is the sum of w sin(k x), while gradient() and laplacian() leave out the weights w that the constructor asks for. With all
# weights 1 they are right; with others their sum, difference and size are lost: weights of 0 count in full, and a function in millimetres has
# the gradient that it has in metres. As exact solution of a test, with laplacian() as right-hand side and value() on the boundary, a Poisson
# solver that is right appears wrong: its solution is another one, at every resolution. In the same file JumpFunction, -atan of a steepness s times a
# coordinate x, has a gradient multiplied by 1 + (s x)^2 instead of divided by it, greatest far from the jump where the function is flat, with one
# component's sign wrong; gradient_list() has yet another argument, x turned the other way, and so differs from gradient(). Its laplacian() is
# right, as are the derivatives of the single FourierSineFunction and FourierCosineFunction. The header has the formula with the
# weights, and 'together with the function, its derivatives and Laplacian are defined' for the jump. Nothing is said.
set -eu
version=9.4.1-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# The library with all that it is linked to (about 200 MB), and the headers that its own include.
mkdir -p debs/partial root
apt-get install --download-only -qq -y --no-install-recommends -o Dir::State::status=/dev/null -o "Dir::Cache::archives=$folder/debs" \
  -o Debug::NoLocking=1 -o APT::Sandbox::User=root "libdeal.ii-9.4.1=$version" > /dev/null 2>&1
cd debs
apt-get download -qq -o APT::Sandbox::User=root "libdeal.ii-dev=$version" libopenmpi-dev libtbb-dev libboost1.74-dev libadolc-dev \
  libtrilinos-teuchos-dev libtrilinos-kokkos-dev libtrilinos-sacado-dev libtrilinos-epetra-dev
cd ..
for package in debs/*.deb; do
  dpkg --fsys-tarfile "$package" | tar x -C root --exclude='*.g.so*' --exclude='./usr/share/*'
  rm "$package"
done
cat > sums.cpp <<'C'
#include <deal.II/base/function_lib.h>
#include <deal.II/base/quadrature_lib.h>
#include <cmath>
#include <cstdio>
#include <vector>
using namespace dealii;
static bool as_described = true;
static void expect(bool holds) { as_described = as_described && holds; }
static bool near(double a, double b, double tolerance = 1e-4) { return std::abs(a - b) <= tolerance * std::fmax(1, std::abs(b)); }
// The gradient along the way from a to b, integrated, against the difference of the values; the Laplacian against differences.
static void show(const char* what, const Function<2>& f, bool gradient_right, bool laplacian_right) {
  const Point<2> a(0.3, 0.2), b(0.9, 0.5);
  const QGauss<1> gauss(20);
  double way = 0;
  for (unsigned i = 0; i < gauss.size(); ++i) way += gauss.weight(i) * (f.gradient(Point<2>(a + gauss.point(i)[0] * (b - a))) * (b - a));
  const double h = 1e-4;
  double laplacian = 0;
  Tensor<1, 2> differences;
  for (int i = 0; i < 2; ++i) {
    Point<2> less = a, more = a;
    less[i] -= h;
    more[i] += h;
    differences[i] = (f.value(more) - f.value(less)) / (2 * h);
    laplacian += (f.value(more) - 2 * f.value(a) + f.value(less)) / (h * h);
  }
  const Tensor<1, 2> g = f.gradient(a);
  std::printf("%-34s gradient (%.3f, %.3f), by differences (%.3f, %.3f); on the way %.3f, values differ by %.3f; Laplacian %.3f, by differences %.3f\n", what,
              g[0], g[1], differences[0], differences[1], way, f.value(b) - f.value(a), f.laplacian(a), laplacian);
  expect(gradient_right == near(way, f.value(b) - f.value(a)) && gradient_right == near((g - differences).norm(), 0, 1e-4 * (1 + g.norm())));
  expect(laplacian_right == near(f.laplacian(a), laplacian, 1e-3));
}
// u'' = Laplacian on 0 to 1 by differences, with the values of f at the ends: how far the solution is from f.
static double poisson(const Function<1>& f, int n) {
  const double h = 1. / n;
  std::vector<double> c(n + 1), u(n + 1);
  u[0] = f.value(Point<1>(0));
  const double end = f.value(Point<1>(1));
  for (int i = 1; i < n; ++i) {
    const double right = h * h * f.laplacian(Point<1>(i * h)) - (i == n - 1 ? end : 0), pivot = -2 - c[i - 1];
    c[i] = 1 / pivot;
    u[i] = (right - u[i - 1]) / pivot;
  }
  u[n] = end;
  double off = 0;
  for (int i = n - 1; i > 0; --i) {
    if (i < n - 1) u[i] -= c[i] * u[i + 1];
    off = std::fmax(off, std::abs(u[i] - f.value(Point<1>(i * h))));
  }
  return off;
}
int main() {
  std::printf("deal.II %s\n", DEAL_II_PACKAGE_VERSION);
  const std::vector<Point<2>> k{Point<2>(1, 2), Point<2>(3, -1)};
  const struct {
    std::vector<double> weights;
    bool right;
  } cases[] = {{{1, 1}, true}, {{2, 0.1}, false}, {{1, 0}, false}, {{1, -1}, false}, {{1000, 1000}, false}};
  for (const auto& c : cases) {
    char name[60];
    std::snprintf(name, 60, "sum of sines, weights %g and %g:", c.weights[0], c.weights[1]);
    const Functions::FourierSineSum<2> sine(k, c.weights);
    show(name, sine, c.right, c.right);
    std::snprintf(name, 60, "sum of cosines, weights %g and %g:", c.weights[0], c.weights[1]);
    const Functions::FourierCosineSum<2> cosine(k, c.weights);
    show(name, cosine, c.right, c.right);
    // What they are: those with all weights 1.
    const Functions::FourierSineSum<2> ones(k, {1, 1});
    const Point<2> p(0.4, 0.7);
    expect((sine.gradient(p) - ones.gradient(p)).norm() < 1e-12 && sine.laplacian(p) == ones.laplacian(p));
  }
  show("one sine:", Functions::FourierSineFunction<2>(k[0]), true, true);
  show("one cosine:", Functions::FourierCosineFunction<2>(k[0]), true, true);
  const std::vector<Point<1>> waves{Point<1>(numbers::PI), Point<1>(3 * numbers::PI)};
  for (const bool ones : {true, false}) {
    const Functions::FourierSineSum<1> f(waves, ones ? std::vector<double>{1, 1} : std::vector<double>{2, 0.1});
    const double coarse = poisson(f, 50), middle = poisson(f, 100), fine = poisson(f, 200);
    std::printf("Poisson's equation on a line, weights %s, 50, 100 and 200 cells: error %.5f, %.5f, %.5f\n", ones ? "1 and 1" : "2 and 0.1", coarse, middle, fine);
    if (ones) expect(coarse < 0.02 && near(coarse / middle, 4, 0.02) && near(middle / fine, 4, 0.02));
    else expect(coarse > 1 && near(coarse / fine, 1, 0.01));
  }
  for (double steepness : {1., 10.}) {
    char name[60];
    std::snprintf(name, 60, "jump, direction (1, 2), steepness %g:", steepness);
    const Functions::JumpFunction<2> jump(Point<2>(1, 2), steepness);
    show(name, jump, false, true);
    const std::vector<Point<2>> points(1, Point<2>(0.3, 0.2));
    std::vector<Tensor<1, 2>> list(1);
    jump.gradient_list(points, list);
    const Tensor<1, 2> g = jump.gradient(points[0]);
    const double c = 2 / std::sqrt(5.), s = 1 / std::sqrt(5.), x = steepness * (-c * 0.3 + s * 0.2), y = steepness * (c * 0.3 + s * 0.2);
    std::printf("  right (%.3f, %.3f); gradient() (%.3f, %.3f), gradient_list() (%.3f, %.3f)\n", steepness * c / (1 + x * x), -steepness * s / (1 + x * x),
                g[0], g[1], list[0][0], list[0][1]);
    expect(near(jump.value(points[0]), -std::atan(x)) && near(g[0], -steepness * c * (1 + x * x)) && near(g[1], -steepness * s * (1 + x * x)));
    expect(near(list[0][0], -steepness * c * (1 + y * y)) && near(list[0][1], -steepness * s * (1 + y * y)));
  }
  return !as_described;
}
C
lib=$(dirname "$(find root -name 'libdeal.ii.so')")
loader=$(find root -name 'ld-linux*' | head -n 1)
libs=$(find "$folder/root" -name '*.so*' -exec dirname {} \; | sort -u | tr '\n' ':')
c++ -std=c++17 -O0 -w -I root/usr/include -I root/usr/include/trilinos -I "$lib/openmpi/include" sums.cpp -o sums "$lib/libdeal.ii.so" \
  "$lib"/libtrilinos_teuchos*.so.13.2 "$lib"/libtrilinos_epetra.so.13.2 "$lib/libtbb.so.12" "$lib/libmpi.so.40" "$lib/libmpi_cxx.so.40" \
  "$lib/libboost_serialization.so.1.74.0" "$lib/libadolc.so.2" -Wl,--allow-shlib-undefined
"$loader" --library-path "$libs" ./sums
