#!/bin/sh
# PySPH 1.0b1 (Debian 12), smoothed particle hydrodynamics: of its kernels one has a derivative with the wrong sign. gradient_h(), the derivative by
# the smoothing length h, of SuperGaussian is the negative of what it should be, in one, two and three dimensions and everywhere. The polynomial in
# it has the sign of the derivative already, and the result is turned once more (-fac * h1 * val), as is right for Gaussian, whose terms are set up
# the other way. The kernel, its gradient in space and dwdq() are right, as is all of it in the other nine kernels, so that with a fixed h nothing
# shows. As GHI, GHJ and GHIJ it goes into the schemes with a variable h (gas dynamics): at the edge of a body, where the density falls as h grows,
# it rises according to gradient_h(). In the middle of even rows both signs are near 0. Nothing is said.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq python3-pysph=1.0~b1-5+b1 python3-numpy=1:1.24.2-1+deb12u1 libblas3 liblapack3 libgfortran5 libquadmath0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > kernels.py <<'P'
import sys
import numpy as np
from pysph.base import kernels

print("PySPH 1.0b1")
as_described = True
H, STEP = 0.7, 1e-6
NAMES = ("CubicSpline", "WendlandQuinticC2_1D", "WendlandQuintic", "WendlandQuinticC4_1D", "WendlandQuinticC4", "WendlandQuinticC6_1D", "WendlandQuinticC6",
         "Gaussian", "SuperGaussian", "QuinticSpline")
for name in NAMES:
    for dim in (1, 2, 3):
        try:
            k = getattr(kernels, name)(dim=dim)
        except ValueError:
            continue  # made for other dimensions
        got, right, space = [], [], 0
        for r in (0.0, 0.2, 0.5, 0.9):
            got.append(k.gradient_h([r, 0, 0], r, H))
            right.append((k.kernel([r, 0, 0], r, H + STEP) - k.kernel([r, 0, 0], r, H - STEP)) / (2 * STEP))
            if r > 0:
                g = [0.0, 0.0, 0.0]
                k.gradient([r, 0, 0], r, H, g)
                d = (k.kernel([r, 0, 0], r + STEP, H) - k.kernel([r, 0, 0], r - STEP, H)) / (2 * STEP)
                space = max(space, abs(g[0] - d), abs(k.dwdq(r, H) - d * H))
        got, right = np.array(got), np.array(right)
        sign = -1 if name == "SuperGaussian" else 1
        as_described &= abs(got - sign * right).max() < 1e-6 and abs(right).max() > 0.1 and space < 1e-6
        if name in ("Gaussian", "SuperGaussian"):
            print(f"{name}, {dim} dimensions, r = 0, 0.2, 0.5, 0.9, h = {H}: gradient_h {got.round(4)}, by differences {right.round(4)}; gradient in space off by {space:.0e}")

x = np.arange(0, 40) * 0.5  # particles of mass 0.5 every 0.5: density 1, half of it at the end
for name in ("Gaussian", "SuperGaussian"):
    k = getattr(kernels, name)(dim=1)

    def density(h, at):
        return sum(0.5 * k.kernel([d, 0, 0], abs(d), h) for d in x - at)

    for at, where in ((0.0, "last particle"), (10.0, "in the middle")):
        h = 0.7
        got = sum(0.5 * k.gradient_h([d, 0, 0], abs(d), h) for d in x - at)
        right = (density(h + STEP, at) - density(h - STEP, at)) / (2 * STEP)
        print(f"{name}, row of particles, {where}: density {density(h, at):.4f}, d density / dh by gradient_h {got:.4f}, by differences {right:.4f}")
        as_described &= abs(got - (-right if name == "SuperGaussian" else right)) < 1e-6 and (at != 0 or right < -0.1)
sys.exit(0 if as_described else 1)
P
LD_LIBRARY_PATH=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':') OPENBLAS_NUM_THREADS=1 \
  PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore kernels.py
