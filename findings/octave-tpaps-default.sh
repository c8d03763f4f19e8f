#!/bin/sh
# octave-splines 1.3.4 (Debian 12; the file is the same in 1.3.5 of Debian 13): tpaps(x, y), thin-plate smoothing for which 'an intermediate amount
# of smoothing is chosen', roughens if the points are measured in a large unit. The amount is the mean of r^2 log r over pairs of points at most three
# apart in the list; log r is negative below r = 1, and so is the amount then (the p returned is above 1, while 0 to 1 are explained). Subtracted
# from the diagonal, where smoothing is added, it makes the matrix near singular or not as it happens. With 36 heights of a plane with noise of 0.1 on
# a square of 90 cm, in m, the surface runs up to 8.8 from the plane, in cm it stays within 0.05; squares of 1 cm to 1.2 m, in m, are 0.2 to 8.8 off.
# Each has greater residuals and more bending than the plane that p = 0 gives, so that no amount of smoothing could prefer it. Nothing is said; in
# the spline itself the unit of log r drops out, and a p that one gives is used as it should be.
set -eu
octave=7.3.0-2
splines=1.3.4-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-splines=$splines" libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 \
  libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 libsundials-ida6 libsundials-sunlinsol3 \
  libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libarpack2 libfftw3-double3 libfftw3-single3 \
  libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 \
  libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 libfontconfig1
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > smooth.m <<'M'
warning ("off", "all");
addpath ("root/usr/share/octave/packages/splines-1.3.4");
printf ("Octave %s, octave-splines 1.3.4\n", version ());
as_described = true;
[a, b] = meshgrid ((0:5) / 5);
x = [a(:) b(:)];                                   % the grid, its side 1
plane = @(x) 3 * x(:,1) + 2 * x(:,2);
randn ("twister", 1);
y = plane (x) + 0.1 * randn (36, 1);
[a, b] = meshgrid (0.05:0.1:0.95);
between = [a(:) b(:)];
rms = @(v) sqrt (mean (v .^ 2));
% bending of a thin-plate spline: the quadratic form of its coefficients with r^2 log r; per side^-2, so that it is the same in every unit
function e = bending (x, c, side)
  d = sqrt ((x(:,1) - x(:,1)') .^ 2 + (x(:,2) - x(:,2)') .^ 2);
  g = d .^ 2 .* log (d + (d == 0));
  e = c(1:rows (x))' * g * c(1:rows (x)) * side ^ 2;
end
flat = plane (between) - tpaps (x, y, 0, between);
flat_residual = rms (y - tpaps (x, y, 0, x));
printf ("plane of p = 0: rms residual %.3f, up to %.3f from the truth\n", flat_residual, max (abs (flat)));
interpolation = bending (x, tpaps (x, y, 1), 1);
printf ("side of the grid    p chosen   smoothing    rms residual   bending (interpolation 1)   farthest from the truth   with |smoothing|\n");
sides = [0.01 0.1 0.3 0.5 0.7 0.8 0.9 1 1.2 2 10 90 900];
for k = 1:numel (sides)
  s = sides(k);
  [c, p] = tpaps (s * x, y);
  at = tps_val (s * x, c, s * x);
  off = max (abs (tps_val (s * x, c, s * between) - plane (between)));
  amount = (1 - p) / p;
  given = max (abs (tpaps (s * x, y, 1 / (1 + abs (amount)), s * between) - plane (between)));
  e = bending (s * x, c, s) / interpolation;
  printf ("%16g    %8.4f   %9.2g    %12.3f   %25.3g   %23.3f   %16.3f\n", s, p, amount, rms (y - at), e, off, given);
  as_described &= given < 0.15;
  % the residuals are the amount times the coefficients of the radial functions, whatever its sign
  as_described &= max (abs (y - at - amount * c(1:36))) < 1e-6 * max (1, max (abs (at)));
  if (s < 1.3)
    as_described &= p > 1 && rms (y - at) > flat_residual && e > 0.1 && off > 0.2;   % the plane has less of both
  else
    as_described &= p > 0 && p < 1 && rms (y - at) < flat_residual && e < 1 && off < 0.15;
  end
  if (s == 0.9), as_described &= off > 5; end
end
% along a line as well: 21 points of a wave on 0 to 1
t = (0:0.05:1)';
w = sin (2 * pi * t) + 0.1 * randn (21, 1);
[f, p] = tpaps (t, w, [], t);
[g, q] = tpaps (100 * t, w, [], 100 * t);
printf ("21 points of a wave with noise of 0.1: on 0 to 1 p = %.4f, rms residual %.3f; on 0 to 100 p = %.4f, %.3f\n", p, rms (w - f), q, rms (w - g));
as_described &= p > 1 && q < 1 && q > 0;
exit (! as_described);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc smooth.m
