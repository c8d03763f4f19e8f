#!/bin/sh
# GSL 2.7.1 (Debian 12): gsl_filter_gaussian() with GSL_FILTER_END_TRUNCATE smooths the end of a signal with the wrong weights. For the
# last H = K / 2 samples, whose window is cut short on the right, gaussian_get() takes the kernel's first entries, as it rightly does for
# the first samples, where the left is cut: the weights slide off their sample, and the last result has the greatest weight H samples back and
# the least on the last sample itself. So a signal read from the other end has another result: a pulse on the first sample is smoothed to 0.240,
# one on the last to 0.003, and a curve comes out late at its end. The window is 'centered on the i-th sample' and 'simply truncated', says
# the manual. Zeros in place of the missing samples (PADZERO) leave the same sum, and there both ends are right. With order 1 the slope of
# a constant has the same sign at both ends. Constant signals hide it in order 0 (both ends fall to 0.62, as the weights left are not brought to 1
# again), signals that are 0 at the end do as well, and GSL's own test takes the same entries. Nothing is said.
set -eu
gsl=2.7.1+dfsg-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libgsl-dev=$gsl" "libgsl27=$gsl" "libgslcblas0=$gsl"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libgsl.so.27')")
cat > ends.c <<'C'
#include <gsl/gsl_filter.h>
#include <gsl/gsl_vector.h>
#include <gsl/gsl_version.h>
#include <math.h>
#include <stdio.h>
enum { n = 30, K = 11, H = K / 2 };
static gsl_vector *x, *kernel;
static gsl_filter_gaussian_workspace* work;
// The sum over the samples there are, with the weights about sample i (the kernel is turned round, as in any convolution).
static double right(int i) {
  double sum = 0;
  for (int j = 0; j < n; ++j)
    if (j >= i - H && j <= i + H) sum += gsl_vector_get(kernel, H + i - j) * gsl_vector_get(x, j);
  return sum;
}
// The same sum, but with the kernel's first entries, turned round, for the samples of the window in their order.
static double slid(int i) {
  const int from = i < H ? 0 : i - H, to = i + H < n ? i + H : n - 1;
  double sum = 0;
  for (int j = from; j <= to; ++j) sum += gsl_vector_get(kernel, to - j) * gsl_vector_get(x, j);
  return sum;
}
static int close(double a, double b) { return fabs(a - b) < 1e-9 * (1 + fabs(b)); }
int main(void) {
  int good = 1;
  x = gsl_vector_alloc(n), kernel = gsl_vector_alloc(K), work = gsl_filter_gaussian_alloc(K);
  gsl_vector *cut = gsl_vector_alloc(n), *zeros = gsl_vector_alloc(n), *turned = gsl_vector_alloc(n), *sums = gsl_vector_alloc(n);
  const char* names[] = {"1 everywhere", "1 on the first and the last sample", "0, 1, 2, .. 29"};
  printf("GSL %s, %d samples, kernel of %d, alpha 3\n", gsl_version, n, K);
  for (int order = 0; order < 2; ++order) for (int s = 0; s < 3; ++s) {
    gsl_filter_gaussian_kernel(3, order, 1, kernel);
    for (int i = 0; i < n; ++i) gsl_vector_set(x, i, s == 0 ? 1 : s == 1 ? i == 0 || i == n - 1 : i);
    gsl_filter_gaussian(GSL_FILTER_END_PADZERO, 3, order, x, zeros, work);
    gsl_filter_gaussian(GSL_FILTER_END_TRUNCATE, 3, order, x, cut, work);
    gsl_vector_reverse(x);
    gsl_filter_gaussian(GSL_FILTER_END_TRUNCATE, 3, order, x, turned, work);
    gsl_vector_reverse(x), gsl_vector_reverse(turned);
    const int end = n - 1, sign = order ? -1 : 1;
    double off = 0;
    for (int i = 0; i < n; ++i) {
      const double given = gsl_vector_get(cut, i);
      off = fmax(off, fabs(given - sign * gsl_vector_get(turned, i)));
      good &= close(gsl_vector_get(zeros, i), right(i)) && close(given, i + H < n ? right(i) : slid(i));
    }
    printf("order %d, %s: first %.3f (right %.3f), last four", order, names[s], gsl_vector_get(cut, 0), right(0));
    for (int i = n - 4; i < n; ++i) printf(" %.3f", gsl_vector_get(cut, i));
    printf(" (right");
    for (int i = n - 4; i < n; ++i) printf(" %.3f", right(i));
    printf("); read from the other end, up to %.3f off\n", off);
    if (order == 0) good &= s == 0 ? off < 1e-12 : s == 1 ? close(off, right(0) - gsl_vector_get(kernel, 0)) : off > 2;
    if (order == 0 && s == 0) for (int i = 0; i < n; ++i) gsl_vector_set(sums, i, gsl_vector_get(cut, i));
    if (order == 0 && s == 2) {
      const double first = gsl_vector_get(cut, 0) / gsl_vector_get(sums, 0), last = gsl_vector_get(cut, end) / gsl_vector_get(sums, end);
      printf("  divided by what 1 everywhere gives, first %.2f and last %.2f (right %.2f)\n", first, last, right(end) / gsl_vector_get(sums, end));
      good &= fabs(first - 1.04) < 0.005 && fabs(last - 25.04) < 0.005 && fabs(right(end) / gsl_vector_get(sums, end) - 27.96) < 0.005;
    }
    if (order == 0 && s == 1) good &= fabs(gsl_vector_get(cut, 0) - 0.240) < 5e-4 && fabs(gsl_vector_get(cut, end) - 0.003) < 5e-4;
    if (order == 1 && s == 0) good &= gsl_vector_get(cut, 0) > 0.2 && gsl_vector_get(cut, end) > 0.2 && right(end) < -0.2;
  }
  return !good;
}
C
cc -std=gnu99 -O1 -w -I root/usr/include ends.c -o ends -L "$lib" -lgsl -lgslcblas -lm
LD_LIBRARY_PATH=$lib ./ends
