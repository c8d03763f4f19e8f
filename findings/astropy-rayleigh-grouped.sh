#!/bin/sh
# astropy 5.2.1 (Debian 12): the Rayleigh test of grouped angles, rayleightest(angles, weights=counts), takes the number of bins for the number of
# observations, as does vtest(). The help of both has it that with grouped data the weights sum up to the number of observations. The mean resultant
# length is formed with the weights; but n, by which its square is multiplied, is np.size(data). The events of a day in 24 hourly bins have the same
# p value whether they are 400 or 400000, if in like proportion: 400 that come up to five times as often in some hours as in others have 0.39
# where 1.2e-7 is right, while 60 uniform ones in 720 bins have less than 0.001 in half of all cases. circcorrcoef() uses its weights for the
# two means alone and leaves them out of the sums of which the correlation consists. circmean(), circvar() and circmoment() are right, so that
# the wrong p value comes with the right direction and spread. Without weights all are right. Nothing is said.
set -eu
astropy=5.2.1-2+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "python3-astropy=$astropy" python3-numpy=1:1.24.2-1+deb12u1 python3-scipy=1.10.1-2 python3-erfa python3-configobj python3-packaging \
  python3-ply python3-six python3-sortedcontainers python3-yaml python3-decorator liberfa1 libcfitsio10 libyaml-0-2 libcurl3-gnutls libbrotli1 \
  libnghttp2-14 libpsl5 librtmp1 libssh2-1 libldap-2.5-0 libsasl2-2 libblas3 liblapack3 libgfortran5 libquadmath0 liblbfgsb0 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
cat > rayleigh.py <<'P'
import sys
import numpy as np
import astropy
from astropy.stats import circcorrcoef, circmean, circvar, rayleightest, vtest

print("astropy", astropy.__version__)
as_described = True
hours = np.arange(24) * 2 * np.pi / 24
counts = np.array([20, 19, 22, 21, 20, 27, 22, 24, 21, 23, 15, 13, 15, 15, 14, 5, 11, 14, 9, 9, 9, 21, 15, 16])


def p_value(n, r):
    """Rayleigh's test: the p value for n observations with mean resultant length r, n >= 50."""
    return np.exp(-n * r * r)


print("events a day: angles of 24 hours with their counts, against each angle listed as often as it was counted")
got = []
for factor in (1, 3, 1000):
    w = counts * factor
    listed = np.repeat(hours, w)
    same = abs(circmean(hours, weights=w) - circmean(listed)) + abs(circvar(hours, weights=w) - circvar(listed))
    a, b = rayleightest(hours, weights=w), rayleightest(listed)
    c, d = vtest(hours, mu=1.2, weights=w), vtest(listed, mu=1.2)
    right = p_value(w.sum(), 1 - circvar(listed))
    print(f"{w.sum():6d} events: Rayleigh's p {a:.3f}, listed one by one {b:.2e}; V test {c:.3f}, listed {abs(d):.2e}; mean and variance agree: {same < 1e-9}")
    got.append((a, c))
    as_described &= same < 1e-9 and abs(b - right) <= 1e-9 * right and b < 1e-6 and abs(d) < 1e-6 and a > 0.3 and c > 0.05
as_described &= np.ptp([g[0] for g in got]) < 1e-9 and np.ptp([g[1] for g in got]) < 1e-9  # the number of events does not matter

rng = np.random.RandomState(1)
fine = np.arange(720) * 2 * np.pi / 720
trials = 300
grouped = listed = 0
for _ in range(trials):
    w = np.bincount(rng.randint(720, size=60), minlength=720)
    grouped += rayleightest(fine, weights=w) < 0.001
    listed += rayleightest(np.repeat(fine, w)) < 0.001
print(f"60 uniform events in 720 bins, p < 0.001: {grouped} of {trials} with weights, {listed} one by one")
as_described &= listed <= 3 and grouped > 0.2 * trials

t = np.random.RandomState(7)
alpha = t.uniform(0, 2 * np.pi, 6)
beta = alpha + t.normal(size=6)
w = np.array([9, 1, 1, 1, 1, 9])
weighted, plain = circcorrcoef(alpha, beta, weights_alpha=w, weights_beta=w), circcorrcoef(np.repeat(alpha, w), np.repeat(beta, w))
x, y = np.sin(alpha - circmean(alpha, weights=w)), np.sin(beta - circmean(beta, weights=w))
right = (w * x * y).sum() / np.sqrt((w * x * x).sum() * (w * y * y).sum())
print(f"circcorrcoef of 6 pairs with weights 9 1 1 1 1 9: {weighted:.3f}, listed as often: {plain:.3f}, weights in all sums: {right:.3f}")
as_described &= abs(plain - right) < 1e-9 and abs(weighted - plain) > 0.05
sys.exit(0 if as_described else 1)
P
export LD_LIBRARY_PATH="$folder/root/usr/lib/x86_64-linux-gnu:$folder/root/usr/lib/x86_64-linux-gnu/blas:$folder/root/usr/lib/x86_64-linux-gnu/lapack"
HOME=$folder OPENBLAS_NUM_THREADS=1 PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore rayleigh.py
