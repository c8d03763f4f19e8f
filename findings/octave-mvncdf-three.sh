#!/bin/sh
# octave-statistics 1.5.3 (Debian 12): probabilities of the multivariate normal and t distributions are right for two variables, wrong for three and
# more. mvncdf(x, mu, sigma) makes correlations of sigma with sigma ./ (s * s'), meant for a column s of deviations; but s was made a row a few lines
# above, and s * s' is a single number, the sum of the variances. So of three variables of equal variance all correlations count a third, and the
# unit of one counts. From four variables on the upper limits are handed on for the lower ones as well, and the probability is 0, with a
# warning of 'zero distance' between limits nobody gave. mvtcdf() for three subtracts a row where its sum is meant, takes a second lower limit for
# the upper one, and returns 0 with an error of 0. For a correlation of 1/2 the orthant of three has 1/4, and gets 0.165 or 0; copulacdf() follows.
# The tests have sigma for two variables only. Without sigma (a product) or with variances alone it is right, and so are the density and the samples.
# Nothing is said for three, and bounds of 1e-8 come with the wrong figures. 1.7.3 (Debian 13) still has s * s'; the other two are mended there.
set -eu
octave=7.3.0-2
statistics=1.5.3-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-statistics=$statistics" \
  libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 \
  libsundials-ida6 libsundials-sunlinsol3 libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 \
  libarpack2 libfftw3-double3 libfftw3-single3 libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 \
  libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 \
  libfontconfig1
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > orthant.m <<'M'
addpath (genpath ("root/usr/share/octave/packages/statistics-1.5.3"));
printf ("Octave %s, octave-statistics 1.5.3\n", version ());
ok = true;
randn ("twister", 1); rand ("twister", 1);
% all below their means: 1/4 + asin(r)/(2 pi) for two variables, 1/8 + sum of asin(r)/(4 pi) for three; for t the same, whatever df
for r = [-0.4 -0.2 0.5 0.9]
  for d = 2:3
    R = r * ones (d);
    R(eye (d) == 1) = 1;
    right = (d == 2) * (1/4 + asin (r) / (2 * pi)) + (d == 3) * (1/8 + 3 * asin (r) / (4 * pi));
    x = zeros (1, d);
    seen = mean (all (randn (100000, d) * chol (R) < 0, 2));
    [p, err] = mvncdf (x, x, R);
    c = copulacdf ("gaussian", x + 1/2, R);
    printf ("%d variables, correlation %4.1f: mvncdf %.4f, error %.0e, copulacdf %.4f; right %.4f, share of 100000 samples %.4f", ...
            d, r, p, err, c, right, seen);
    ok &= abs (seen - right) < 0.006 && abs (c - p) < 1e-7;
    if (d == 2)
      ok &= abs (p - right) < 1e-9;
    else
      third = 1/8 + 3 * asin (r / 3) / (4 * pi);
      [t, err] = mvtcdf (x, R, 5);
      printf ("; mvtcdf %.4f, error %g", t, err);
      ok &= abs (p - third) < 1e-7 && abs (p - right) > 0.02 && t == 0 && err == 0;
    end
    printf ("\n");
  end
end
% t of two variables is right (a small probability, for which its sampling is quick)
R = [1 0.5; 0.5 1];
t = mvtcdf ([-1.5 -1.5], R, 5);
right = mean (all (randn (100000, 2) * chol (R) ./ sqrt (sum (randn (100000, 5) .^ 2, 2) / 5) < -1.5, 2));
printf ("2 variables, correlation  0.5, both below -1.5: mvtcdf %.4f, share of 100000 samples %.4f\n", t, right);
ok &= abs (t - right) < 3e-3 && right > 0.02;
% three variables that are not alike, the third in three units
R = [1 0.3 0.2; 0.3 1 -0.6; 0.2 -0.6 1];
right = 1/8 + (asin (0.3) + asin (0.2) + asin (-0.6)) / (4 * pi);
p = unit = [0.01 1 100];
for k = 1:3
  u = diag ([1 1 unit(k)]);
  p(k) = mvncdf ([10 20 30*unit(k)], [10 20 30*unit(k)], u * R * u);
  printf ("correlations 0.3, 0.2, -0.6, third variable times %6.2f: mvncdf %.4f, right %.4f\n", unit(k), p(k), right);
end
ok &= all (abs (p - right) > 0.005) && max (p) - min (p) > 0.01;
% within one deviation of the mean in each of the three variables
seen = mean (all (abs (randn (100000, 3) * chol (R)) < 1, 2));
p = mvncdf (-[1 1 1], [1 1 1], [0 0 0], R);
printf ("all three within one deviation: mvncdf %.4f, share of samples %.4f\n", p, seen);
ok &= abs (p - seen) > 0.03;
% four and more: 1/(d + 1) for correlation 1/2
for d = 4:6
  R = (eye (d) + 1) / 2;
  x = zeros (1, d);
  [p, err] = mvncdf (x, x, R);
  said = lastwarn ();
  c = copulacdf ("gaussian", x + 1/2, R);
  printf ("%d variables, correlation 1/2: mvncdf %.4f, error %g, copulacdf %.4f; right %.4f\n", d, p, err, c, 1/(d+1));
  ok &= p == 0 && err == 0 && c == 0 && ! isempty (strfind (said, "zero distance"));
end
if (ok), disp ("as described"); else disp ("changed"); end
exit (! ok);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc orthant.m
