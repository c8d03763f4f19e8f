#!/bin/sh
# octave-nan 3.7.0 (Debian 12, the NaN toolbox): partcorrcoef(x, y, z) in its default mode depends on where the scales of x, y and z have their zero.
# It takes out what z explains with x - z*(z\x), a line through the origin: without an intercept the residuals keep much of z whenever the means are
# not 0, and the correlation taken of them afterwards centres them and hides it. Here a length x goes with the size z of a shape and a length y with
# neither; the partial correlation of x and y is -0.06. With means of 100, 40 and 50 one gets 0.50 with p = 5e-5, with x centred -0.54, with z
# centred 0.97. The help has the usual formula, which knows no zero, and says of the default that it is ideally the same as 'Pearson', but in
# practice more accurate. 'Pearson' is right, and so is the default for centred columns, such as a test draws with randn(). Nothing is said.
set -eu
octave=7.3.0-2
nan=3.7.0-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-nan=$nan" libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 \
  libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 libsundials-ida6 libsundials-sunlinsol3 \
  libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libarpack2 libfftw3-double3 libfftw3-single3 \
  libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 \
  libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 libfontconfig1
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > partial.m <<'M'
warning ("off", "all");
addpath (genpath ("root/usr/share/octave/packages/nan-3.7.0"));
for d = glob ("root/usr/lib/*/octave/packages/nan-3.7.0")', addpath (genpath (d{1})); end
printf ("Octave %s, octave-nan 3.7.0\n", version ());
randn ("twister", 7);
n = 60;
size_of = randn (n, 1);
x0 = size_of + randn (n, 1);               % one length goes with the size
y0 = randn (n, 1);                         % the other does not
% the formula of the help, and the correlation of residuals of lines with an intercept, both with plain arithmetic
cc = @(a, b) (a - mean (a))' * (b - mean (b)) / sqrt (sum ((a - mean (a)) .^ 2) * sum ((b - mean (b)) .^ 2));
formula = @(x, y, z) (cc (x, y) - cc (x, z) * cc (y, z)) / sqrt ((1 - cc (x, z) ^ 2) * (1 - cc (y, z) ^ 2));
left = @(a, z) a - [ones(n, 1) z] * ([ones(n, 1) z] \ a);
as_described = true;
got = [];
for zero = {[0 0 0], [100 40 50], [0 40 50], [100 0 50], [100 40 0], [1000 400 500]}
  x = x0 + zero{1}(1); y = y0 + zero{1}(2); z = size_of + zero{1}(3);
  [r, p] = partcorrcoef (x, y, z);
  pearson = partcorrcoef (x, y, z, "Pearson");
  centred = partcorrcoef (x - sum (x) / n, y - sum (y) / n, z - sum (z) / n);
  right = formula (x, y, z);
  printf ("means %4d, %4d, %4d: default %7.3f (p = %7.1e), 'Pearson' %.3f, default of centred columns %.3f, right %.3f\n", zero{1}, r, p, ...
          pearson, centred, right);
  as_described &= abs (pearson - right) < 1e-9 && abs (centred - right) < 1e-9 && abs (right - cc (left (x, z), left (y, z))) < 1e-9;
  got(end+1) = r; limit(numel (got)) = p;
end
as_described &= abs (got(1) - right) < 0.01 && abs (got(2) - 0.5) < 0.05 && abs (got(3) + 0.54) < 0.05 && got(5) > 0.9 && limit(2) < 1e-3;
exit (! as_described);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc partial.m
