#!/bin/sh
# octave-lssa 0.1.4 (Debian 12): the Lomb periodogram of lombcoeff(t, x, omega) and lombnormcoeff() depends on the zero and on the unit of time.
# Lomb's method takes a delay tau from tan(2 omega tau) and sums over cos(omega (t - tau)) and sin(omega (t - tau)). With it the two are orthogonal,
# and the coefficient is the sum of squares that the best fitting wave of frequency omega explains. Both functions work out tau, and take it from
# omega t as it is: cos(omega t - tau), without the factor omega. So they are right for omega = 1 only. Else the two waves are not orthogonal, and
# what they share counts twice or not at all. A pure wave of frequency 3 at 16 uneven moments, with a sum of squares of 6.56, has a coefficient
# of 7.59, more than there is; with the clock set on by 0.8 it is 5.24, by 1.2 it is 8.54. In a unit of time in which omega is 1 it is 6.56.
# The normalized one exceeds its largest possible value, (n - 1) / 2. The series of the package's own tests has three waves; by lombcoeff the slowest
# of the three frequencies is the strongest (1342 of a sum of 1370), where by least squares it is the weakest (989). The tests hold these figures as
# expected values. Many evenly spaced moments over whole periods hide it. Nothing is said.
set -eu
octave=7.3.0-2
lssa=0.1.4-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-lssa=$lssa" \
  libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 \
  libsundials-ida6 libsundials-sunlinsol3 libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 \
  libarpack2 libfftw3-double3 libfftw3-single3 libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 \
  libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 \
  libfontconfig1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > delay.m <<'M'
addpath (genpath ("root/usr/share/octave/packages/lssa-0.1.4"));
printf ("Octave %s, octave-lssa 0.1.4\n", version ());
ok = true;
% the sum of squares that the best a cos(omega t) + b sin(omega t) explains
function p = least (t, x, omega)
  a = [cos(omega * t(:)), sin(omega * t(:))];
  p = sumsq (a * (a \ x(:)));
endfunction
% Lomb's formula, with the phase that is taken off omega t
function p = lomb (t, x, omega, right)
  tau = atan2 (sum (sin (2 * omega * t)), sum (cos (2 * omega * t))) / (2 * omega);
  if (right)
    tau *= omega;
  endif
  c = cos (omega * t - tau);
  s = sin (omega * t - tau);
  p = sum (x .* c) ^ 2 / sumsq (c) + sum (x .* s) ^ 2 / sumsq (s);
endfunction
t = [0 0.3 0.4 1.1 1.3 2.2 2.5 3.1 3.3 4.4 5.2 5.3 6.2 7.1 7.2 8.3];
n = numel (t);
later = 0.2:0.2:3;
printf ("a pure wave at %d uneven moments; the same with the clock set on by 0.2 to 3, and in a unit of time in which omega is 1\n", n);
for omega = [0.5 1 2 3 5 7]
  x = sin (omega * t + 0.4);
  got = lombcoeff (t, x, omega);
  shifted = arrayfun (@(d) lombcoeff (t + d, x, omega), later);
  unit = lombcoeff (t * omega, x, 1);
  normed = lombnormcoeff (t, x, omega);
  centred = x - mean (x);
  printf ("  omega %g: sum of squares %.3f, lombcoeff %.3f, set on %.3f to %.3f, other unit %.3f; lombnormcoeff %.3f, right %.3f, largest %.1f\n", ...
          omega, sumsq (x), got, min (shifted), max (shifted), unit, normed, least (t, centred, omega) / (2 * var (x)), (n - 1) / 2);
  % least squares and Lomb's formula agree, wherever the clock is set
  ok &= abs (least (t, x, omega) - sumsq (x)) < 1e-9;
  ok &= abs (lomb (t, x, omega, true) - sumsq (x)) < 1e-9 && abs (lomb (t + 0.8, x, omega, true) - sumsq (x)) < 1e-9;
  ok &= abs (got - lomb (t, x, omega, false)) < 1e-9 && abs (unit - sumsq (x)) < 1e-9;
  ok &= abs (normed - lomb (t, centred, omega, false) / (2 * var (x))) < 1e-9;
  if (omega == 1)
    ok &= max (abs ([got shifted] - sumsq (x))) < 1e-9;
  else
    ok &= max (abs ([got shifted] - sumsq (x))) > 0.04 * sumsq (x) && max (shifted) > sumsq (x) * 1.03;
  endif
  if (omega == 3)
    ok &= normed > (n - 1) / 2;
  endif
endfor
% the series of the package's tests
w = 4 / (2 * pi);
t = linspace (0, 8);
x = 2 * sin (w * t) + 3 * sin (0.75 * w * t) - 0.5 * sin (0.25 * w * t) - 0.2 * cos (w * t) + cos (0.25 * w * t);
omega = [1 0.75 0.25] * w;
got = arrayfun (@(o) lombcoeff (t, x, o), omega);
right = arrayfun (@(o) least (t, x, o), omega);
unit = arrayfun (@(o) lombcoeff (t * o, x, 1), omega);
printf ("series of the package's tests, sum of squares %.1f\n", sumsq (x));
printf ("  omega %.4f: lombcoeff %.1f, least squares %.1f, in a unit in which omega is 1 %.1f\n", [omega; got; right; unit]);
[~, strongest] = max (got);
[~, weakest] = min (right);
ok &= strongest == 3 && weakest == 3 && max (abs (unit - right)) < 1e-8 && max (abs (got - [1076.77574 1226.53573 1341.63962])) < 1e-4;
% 500 even moments over whole periods
t = (0:499) / 500 * 2 * pi;
x = 2 * sin (3 * t) + cos (3 * t) + sin (8 * t);
got = arrayfun (@(d) lombcoeff (t + d, x, 3), later);
printf ("500 even moments over whole periods: lombcoeff %.3f to %.3f, right %.3f\n", min (got), max (got), least (t, x, 3));
ok &= max (abs (got - 1250)) < 1e-6 && abs (least (t, x, 3) - 1250) < 1e-6;
exit (! ok);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc delay.m
