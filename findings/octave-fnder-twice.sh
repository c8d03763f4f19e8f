#!/bin/sh
# octave-splines 1.3.4 (Debian 12): fnder(pp, 2) is not the second derivative of a spline. fnder(pp) is the first one, and is right. For a higher
# order fnder.m goes through a loop, and each round is to multiply the coefficients by their powers and to drop the last one. But the number of
# columns is read once, before the loop. So the second round takes the powers of the first again, and drops nothing. For a x^3 + b x^2 + c x + d the
# second round should give 6 a x + 2 b; it gives 9 a x^2 + 4 b x + c. At a knot one gets the slope c there in place of 2 b. For x^2 one gets 4 x from
# the left end of the piece, in place of 2 throughout, and for a straight line its slope, in place of 0. The third order gives 27 a x^2 + 8 b x + c in
# place of 6 a. The curvature of a spline through 24 points of a circle of radius 2 comes out as 0 at the points and up to 0.13 between them, where 0.5
# is right; fnder(fnder(pp)) gives 0.5, and so does ppder(pp, 2) of Octave itself. The result is a valid spline, and nothing is said. The package has
# no test of fnder().
set -eu
octave=7.3.0-2
splines=1.3.4-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-splines=$splines" \
  libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 \
  libsundials-ida6 libsundials-sunlinsol3 libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 \
  libarpack2 libfftw3-double3 libfftw3-single3 libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 \
  libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 \
  libfontconfig1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > derivatives.m <<'M'
addpath (genpath ("root/usr/share/octave/packages/splines-1.3.4"));
printf ("Octave %s, octave-splines 1.3.4\n", version ());
ok = true;
% polynomials of one piece, from 0 to 2
u = [0 0.5 1 1.5 2];
names = {"x^3 + 2 x^2 + 3 x + 4", "x^2", "5 x + 1", "x^4"};
coefficients = {[1 2 3 4], [1 0 0], [5 1], [1 0 0 0 0]};
for k = 1:4
  p = coefficients{k};
  pp = mkpp ([0 2], p);
  printf ("%s, at %s\n", names{k}, sprintf ("%g ", u));
  for order = 1:3
    right = p;
    for i = 1:order
      right = polyder (right);
    endfor
    right = polyval (right, u);
    got = ppval (fnder (pp, order), u);
    own = ppval (ppder (pp, order), u);
    % what comes of the powers of the first round in all rounds
    q = p;
    m = numel (p);
    for i = 1:order
      q = q(1:m-1) .* (m-1:-1:1);
    endfor
    printf ("  order %d: fnder %s; right %s\n", order, sprintf ("%g ", got), sprintf ("%g ", right));
    ok &= max (abs (own - right)) < 1e-9 && max (abs (got - polyval (q, u))) < 1e-9;
    if (m > order)
      again = pp;
      for i = 1:order
        again = fnder (again);
      endfor
      ok &= max (abs (ppval (again, u) - right)) < 1e-9;
    endif
    ok &= (order == 1) == (max (abs (got - right)) < 1e-9);
  endfor
endfor
% the curvature of a closed spline (by Octave itself) through 24 points of a circle of radius 2
a = linspace (0, 2 * pi, 25);
x = spline (a, [0 2*cos(a) 0]);
y = spline (a, [2 2*sin(a) 2]);
t = linspace (0, 2 * pi, 721)(1:end-1);
function k = curvature (dx, dy, ddx, ddy, t)
  dx = ppval (dx, t); dy = ppval (dy, t); ddx = ppval (ddx, t); ddy = ppval (ddy, t);
  k = abs (dx .* ddy - dy .* ddx) ./ hypot (dx, dy) .^ 3;
endfunction
two = curvature (fnder (x), fnder (y), fnder (x, 2), fnder (y, 2), t);
twice = curvature (fnder (x), fnder (y), fnder (fnder (x)), fnder (fnder (y)), t);
own = curvature (fnder (x), fnder (y), ppder (x, 2), ppder (y, 2), t);
off = max (abs (hypot (ppval (x, t), ppval (y, t)) - 2));
printf ("spline through a circle of radius 2, off it by %.0e at most; its curvature, right 0.5 throughout:\n", off);
printf ("  with fnder(pp, 2) %.3f to %.3f; with fnder(fnder(pp)) %.3f to %.3f; with ppder(pp, 2) %.3f to %.3f\n", ...
        min (two), max (two), min (twice), max (twice), min (own), max (own));
ok &= off < 1e-3 && max (abs (twice - 0.5)) < 0.01 && max (abs (own - twice)) < 1e-9 && max (two) < 0.2 && min (two) < 1e-9;
% at a knot the second derivative is the slope
knots = a(1:end-1);
slope = ppval (fnder (x), knots);
printf ("  at the knots fnder(pp, 2) of x is the slope of x to %.0e; it should be -x, and is off by up to %.2f\n", ...
        max (abs (ppval (fnder (x, 2), knots) - slope)), max (abs (ppval (fnder (x, 2), knots) + 2 * cos (knots))));
ok &= max (abs (ppval (fnder (x, 2), knots) - slope)) < 1e-9;
exit (! ok);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc derivatives.m
