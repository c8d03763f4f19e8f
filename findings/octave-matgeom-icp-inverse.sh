#!/bin/sh
# octave-matgeom 1.2.3 (Debian 12): registerICP() and registerPoints3dAffine() move the points away from the target. fitAffineTransform2d() and
# fitAffineTransform3d() take (REF, SRC) and give what brings SRC onto REF; the two registrations call them with (points, nearest points of the
# target), get the inverse of the step they want, and apply it to the points. An outline 3 degrees beside its target is 6 degrees beside it
# after one iteration and 12 after two; a shift is doubled by each, until the nearest points are the wrong ones and the shape is sheared, squashed
# or thrown out of all bounds in the ten iterations that are the default. Both promise the transformation that maps the points onto the target; with
# the two arguments exchanged the same loop finds it at once. Points that already lie on the target stay, no residual is returned and nothing
# is said. The calls stand so in matGeom, from which the package is made, up to 2023 at least.
set -eu
octave=7.3.0-2
matgeom=1.2.3-3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-matgeom=$matgeom" libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 \
  libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 libsundials-ida6 libsundials-sunlinsol3 \
  libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libarpack2 libfftw3-double3 libfftw3-single3 \
  libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 \
  libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 libfontconfig1
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > register.m <<'M'
warning ("off", "all");
addpath (genpath ("root/usr/share/octave/packages/matgeom-1.2.3"));
printf ("Octave %s, octave-matgeom 1.2.3\n", version ());
% the same loop, with the arguments in the order that the fits document
function p = by_hand (p, q, fit, move)
  for i = 1:10
    p = move (p, fit (q(findClosestPoint (p, q), :), p));
  end
end
off = @(p, q) sqrt (mean (sum ((p - q) .^ 2, 2)));
as_described = true;
% in the plane: 12 points of an ellipse, the outline turned by 3 degrees
t = (0:11)' * pi / 6;
target = [4*cos(t) 2*sin(t)];
outline = transformPoint (target, createRotation (3 * pi / 180));
printf ("outline turned by 3 degrees: %.4f off\n", off (outline, target));
for n = [1 2 10]
  [trans, moved] = registerICP (outline, target, n);
  printf ("  registerICP, %2d iterations: %.4f off, transformation [%.3f %.3f; %.3f %.3f]", n, off (moved, target), trans(1:2,1:2)');
  if (n < 3)
    turned = atan2 (trans(2,1), trans(1,1)) * 180 / pi;
    printf (", turned by %.2f degrees where -3 is right", turned);
    as_described &= abs (turned - [3 9](n)) < 1e-6;
  end
  printf ("\n");
end
as_described &= off (moved, target) > off (outline, target);
again = off (by_hand (outline, target, @fitAffineTransform2d, @transformPoint), target);
printf ("  with the arguments exchanged: %.1e off\n", again);
as_described &= again < 1e-10;
% in space: a curve, shifted
s = (-2:0.5:2)';
target = [s s.^2 s.^3/4];
curve = target + 0.05;
printf ("curve in space shifted by 0.05, 0.05, 0.05: %.4f off\n", off (curve, target));
for n = [1 2 10]
  [trans, moved] = registerPoints3dAffine (curve, target, n);
  printf ("  registerPoints3dAffine, %2d iterations: %.4g off, shift %.4g where -0.05 is right\n", n, off (moved, target), trans(1,4));
  if (n < 3), as_described &= abs (trans(1,4) - [0.05 0.15](n)) < 1e-6; end
end
as_described &= off (moved, target) > 5;
again = off (by_hand (curve, target, @fitAffineTransform3d, @transformPoint3d), target);
printf ("  with the arguments exchanged: %.1e off\n", again);
as_described &= again < 1e-10;
exit (! as_described);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc register.m
