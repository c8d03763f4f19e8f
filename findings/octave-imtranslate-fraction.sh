#!/bin/sh
# octave-image 2.14.0 (Debian 12; the file is the same in 2.16.0 of Debian 13): imtranslate(image, x, y), which moves an image 'using Fourier
# interpolation', is right for whole pixels only. A shift by a multiplies the k-th of n frequencies by exp(-2 pi i a k / n), where k has to run from
# -n/2 to n/2; imtranslate() has it run from 0 to n-1. For whole a that is the same; for others each negative frequency is turned by 2 pi a too far,
# and of what comes back, which is complex then, the real part is taken. So every pattern along the axis fades with cos(pi a) and goes to another
# place: waves of 16 pixels moved by 0.1 go 0.7 the other way. Moved right by half a pixel an image has gone, but for the mean of each row, and
# twice 0.5 is not once 1. The help does not restrict x and y to whole numbers, for which Fourier interpolation is not needed, and nothing is said.
set -eu
octave=7.3.0-2
image=2.14.0-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-image=$image" libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 \
  libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 libsundials-ida6 libsundials-sunlinsol3 \
  libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libarpack2 libfftw3-double3 libfftw3-single3 \
  libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 \
  libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 libfontconfig1
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > move.m <<'M'
warning ("off", "all");
addpath ("root/usr/share/octave/packages/image-2.14.0");
printf ("Octave %s, octave-image 2.14.0\n", version ());
as_described = true;
% a smooth spot, whose shifted image is known: right by x, up by y
n = 64;
[c, r] = meshgrid (1:n, 1:n);
spot = @(x, y) exp (-((c - 30 - x) .^ 2 + (r - 34 + y) .^ 2) / 18);
% the same interpolation with the frequencies from -n/2 to n/2
function b = by_hand (a, x, y)
  k = ifftshift (-rows (a) / 2 : rows (a) / 2 - 1);
  b = real (ifft2 (fft2 (a) .* (exp (2i * pi * k' * y / rows (a)) * exp (-2i * pi * k * x / rows (a)))));
end
a = spot (0, 0);
printf ("a spot of height 1                 height   lowest   farthest from the spot moved   the same with frequencies from -n/2\n");
for s = [3 0.1 0.25 0.5 0.75 2.5 0.5 0; -2 0 0 0 0 0 0.5 0.3]
  b = imtranslate (a, s(1), s(2));
  off = max (abs (b - spot (s(1), s(2)))(:));
  ref = max (abs (by_hand (a, s(1), s(2)) - spot (s(1), s(2)))(:));
  printf ("right by %4.2f, up by %5.2f:        %6.3f   %6.3f   %28.4f   %35.1e\n", s, max (b(:)), min (b(:)), off, ref);
  whole = all (s == fix (s));
  as_described &= ref < 1e-6 && (off < 1e-6) == whole;
  if (s(1) - fix (s(1)) == 0.5 && s(2) == 0), as_described &= max (abs (b - mean (a, 2))(:)) < 1e-9; end
end
% a wave of 16 pixels: what is left of it, and where it goes
wave = ones (n, 1) * cos (2 * pi * (0:n-1) / 16);
printf ("a wave of height 1, 16 pixels long\n");
for s = [0.1 0.25 0.4 0.5 0.6 0.9 1]
  f = fft (imtranslate (wave, s, 0)(1,:))(5) * 2 / n;
  height = abs (f);
  moved = mod (-angle (f) * 16 / (2 * pi) + 8, 16) - 8;
  printf ("moved by %4.2f: height %.3f, cos (pi a) %6.3f; ", s, height, cos (pi * s));
  if (height > 1e-9), printf ("moved by %.2f\n", moved); else, printf ("nothing left\n"); end
  as_described &= abs (height - abs (cos (pi * s))) < 1e-9;
  if (s == 0.1), as_described &= abs (moved + 0.7) < 1e-6; end
end
twice = imtranslate (imtranslate (a, 0.5, 0), 0.5, 0);
off = max (abs (twice - imtranslate (a, 1, 0))(:));
printf ("twice by 0.5 and once by 1 differ by up to %.3f of 1\n", off);
as_described &= off > 0.5;
exit (! as_described);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc move.m
