#!/bin/sh
# octave-mapping 1.4.2 (Debian 12): distance(), the great circle distance of two places, is short by up to 2 per cent along meridians, for places
# less than 0.4 rad (22.9 degrees) apart in latitude and in longitude. There the haversine formula is used, which takes the sine of half the
# difference of each coordinate. For longitude distance.m has sin (C / 2); for latitude it has sin (b - a) / 2, with the division outside the sine.
# So from the equator 20 degrees straight north are 19.69, 22.9 are 22.44, and 23, where the cosine formula takes over, are 23: two stages of a way
# along one meridian do not add up to the whole. From 22 N to 0 the loss is 45 km. The error grows with the square of the difference: 0.3 per cent
# at 10 degrees. It also makes the nearest of several places the wrong one. East-west distances, those beyond the limit, azimuths, reckon()
# and geodeticarc() are right. The help gives 30 degrees along a meridian as an example; the tests have tiny, large or east-west distances only. The
# haversine formula with half the difference in both places gives the right figures. Nothing is said.
set -eu
octave=7.3.0-2
mapping=1.4.2-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-mapping=$mapping" \
  libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 \
  libsundials-ida6 libsundials-sunlinsol3 libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 \
  libarpack2 libfftw3-double3 libfftw3-single3 libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 \
  libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 \
  libfontconfig1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > meridian.m <<'M'
addpath ("root/usr/share/octave/packages/mapping-1.4.2");
printf ("Octave %s, octave-mapping 1.4.2\n", version ());
ok = true;
% the angle between two unit vectors, in degrees
function d = angle_of (a, b, c, e)
  v = @(lat, lon) [cosd(lat) * cosd(lon), cosd(lat) * sind(lon), sind(lat)];
  p = v (a, b); q = v (c, e);
  d = atan2d (norm (cross (p, q)), dot (p, q));
endfunction
% the haversine formula, with half the difference of latitude or with half its sine
half = @(x) sind (x / 2);
out = @(x) sind (x) / 2;
haversine = @(f, a, b, c, e) 2 * asind (sqrt (f (c - a) ^ 2 + cosd (a) * cosd (c) * sind ((e - b) / 2) ^ 2));
printf ("straight north from the equator, and straight east along it, in degrees\n");
for d = [0.1 1 5 10 15 20 22.9 23 30 60]
  north = distance (0, 0, d, 0);
  east = distance (0, 0, 0, d);
  printf ("  %5.1f: north %9.5f (off by %8.1f km), east %9.5f\n", d, north, (north - d) * 6371 * pi / 180, east);
  ok &= abs (east - d) < 1e-6;
  if (d < 22.9183)
    ok &= abs (north - haversine (out, 0, 0, d, 0)) < 1e-9;
    ok &= abs (haversine (half, 0, 0, d, 0) - d) < 1e-9;
  else
    ok &= abs (north - d) < 1e-6;
  endif
endfor
ok &= distance (0, 0, 20, 0) < 19.7 && distance ([0 0], [20 0]) < 19.7 && distance (0, 0, pi / 9, 0, "radians") < 19.7 * pi / 180;
printf ("ways between places: distance, right; reckon from there and back gives the way that was put in\n");
ways = [60 10 42 12; 52 5 41 2; -10 100 8 118; 10 20 10 40; 0 0 40 10; 70 0 50 22];
for w = ways'
  got = distance (w(1), w(2), w(3), w(4));
  right = angle_of (w(1), w(2), w(3), w(4));
  [lat, lon] = reckon (w(1), w(2), right, azimuth (w(1), w(2), w(3), w(4)));
  arc = geodeticarc (w(1:2)', w(3:4)', [6371000 0]) / 6371000 * 180 / pi;
  near = abs (w(3) - w(1)) < 22.9 && abs (w(4) - w(2)) < 22.9;
  printf ("  (%g, %g) to (%g, %g): distance %.4f, right %.4f, %.1f km of difference, geodeticarc on a ball %.4f\n", w, got, right, ...
          (got - right) * 6371 * pi / 180, arc);
  ok &= abs (lat - w(3)) < 1e-6 && abs (lon - w(4)) < 1e-6 && abs (arc - right) < 1e-6;
  if (near)
    ok &= abs (got - haversine (out, w(1), w(2), w(3), w(4))) < 1e-9;
  else
    ok &= abs (got - right) < 1e-6;
  endif
  if (near && w(1) != w(3))
    ok &= got < right - 0.04;
  else
    ok &= abs (got - right) < 1e-6;
  endif
endfor
% a way of 40 degrees in two stages
stages = distance (0, 0, 20, 0) + distance (20, 0, 40, 0);
printf ("0 to 20 N and 20 to 40 N: %.4f together; 0 to 40 N at once: %.4f\n", stages, distance (0, 0, 40, 0));
ok &= stages < 39.4 && abs (distance (0, 0, 40, 0) - 40) < 1e-6;
% which of two places is nearer
n = [distance(0, 0, 22, 0), distance(0, 0, 0, 21.8)];
printf ("from (0, 0): to (22, 0) %.3f, to (0, 21.8) %.3f\n", n);
ok &= n(1) < n(2);
exit (! ok);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc meridian.m
