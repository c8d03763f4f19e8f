#!/bin/sh
# NLopt 2.7.1 (Debian 12), LD_TNEWTON on Rosenbrock's function: half of the calls of the objective are no iterates. The truncated Newton
# method of its Luksan codes takes Hessian-vector products from differences, for which it evaluates the gradient at points 3.2e-8 beside an
# iterate, through the same callback and without a word. Whoever takes calls with falling values for steps counts these: a stop rule of one's
# own then sees steps of no length. luksan/pnet.c does the probing.
set -eu
version=2.7.1-5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libnlopt0=$version" "libnlopt-dev=$version"
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'libnlopt.so.0' | head -n 1)")

cat > probes.c <<'C'
#include <math.h>
#include <nlopt.h>
#include <stdio.h>
static double last[2] = {1e9, 1e9};
static int calls, probes;
static double rosenbrock(unsigned n, const double* x, double* g, void* data) {
  (void)n, (void)data;
  const double a = x[1] - x[0] * x[0], b = 1 - x[0], d = hypot(x[0] - last[0], x[1] - last[1]);
  ++calls;
  if (d > 0 && d < 1e-6) ++probes;
  else last[0] = x[0], last[1] = x[1];
  if (g) g[0] = -400 * a * x[0] - 2 * b, g[1] = 200 * a;
  return 100 * a * a + b * b;
}
int main(void) {
  double x[2] = {-1.2, 1}, f;
  nlopt_opt opt = nlopt_create(NLOPT_LD_TNEWTON, 2);
  nlopt_set_min_objective(opt, rosenbrock, 0);
  nlopt_set_ftol_rel(opt, 1e-12);
  nlopt_set_maxeval(opt, 1000);
  nlopt_optimize(opt, x, &f);
  printf("calls %d, of which %d within 1e-6 of the point before; minimum %.1e\n", calls, probes, f);
  return !(probes > calls / 4 && f < 1e-8);
}
C
cc -Wall -I root/usr/include probes.c -o probes -L "$lib" -lnlopt -lm
LD_LIBRARY_PATH=$lib ./probes
