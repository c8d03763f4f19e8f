#!/bin/sh
# octave-statistics 1.5.3 (Debian 12): the matrices that iwishrnd(Tau, df) draws are not inverse Wishart(Tau, df) unless Tau is diagonal. wishrnd()
# wants the lower Cholesky factor D of Sigma = inv(Tau), with D D' = Sigma; iwishrnd() gives it the upper one, with D' D = Sigma, and so samples
# for inv(D D') in place of Tau. The two have the same eigenvalues: determinant, trace and the lengths of the axes are right, and only where the
# axes point is wrong. For Tau with its long axis at 30 degrees the mean of the samples, which by the help approaches Tau / (df - p - 1), has it at
# 49, and for 150 at 131. wishrnd() is right, and with the factor that iwishrnd() returns beside the samples (which is the lower one) gives the
# right inverses; handed back to iwishrnd() as DI, it is turned over again. Tau = eye(p) and other diagonal ones do not show it, the package's
# tests look at sizes only, and nothing is said. Later source has the same lines. As a prior for covariances or tensors it favours wrong directions.
set -eu
octave=7.3.0-2
statistics=1.5.3-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "octave=$octave" "octave-common=$octave" "octave-statistics=$statistics" libqrupdate1 libglpk40 libgraphicsmagick++-q16-12 \
  libgraphicsmagick-q16-3 libwmflite-0.2-7 libportaudio2 libjack-jackd2-0 libsamplerate0 libsundials-ida6 libsundials-sunlinsol3 \
  libsundials-sunmatrix4 libfltk1.3 libfltk-gl1.3 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libarpack2 libfftw3-double3 libfftw3-single3 \
  libhdf5-103-1 libaec0 libsz2 libamd2 libcamd2 libccolamd2 libcholmod3 libcolamd2 libcxsparse3 libmetis5 libumfpack5 libspqr2 libsuitesparseconfig5 \
  libgl2ps1.4 libglu1-mesa libgl1 libglvnd0 libglx0 libopengl0 libpng16-16 libfreetype6 libfontconfig1
for package in *.deb; do dpkg -x "$package" root; done
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > tensors.m <<'M'
warning ("off", "all");
addpath (genpath ("root/usr/share/octave/packages/statistics-1.5.3"));
printf ("Octave %s, octave-statistics 1.5.3\n", version ());
randn ("twister", 7); randg ("twister", 7);
n = 10000; p = 2;
function a = axis_of (A)                  % where the long axis points, in degrees, and the two eigenvalues
  [v, e] = eig ((A + A') / 2);
  a = [mod(atan2(v(2,2), v(1,2)) * 180 / pi, 180), e(2,2), e(1,1)];
end
as_described = true;
for turn = [30 150 0]
  c = cos (turn * pi / 180); s = sin (turn * pi / 180);
  Tau = [c -s; s c] * diag ([4 1]) * [c s; -s c];
  printf ("Tau: long axis at %d degrees, eigenvalues 4 and 1\n", turn);
  upper = chol (inv (Tau));
  other = axis_of (inv (upper * upper'));
  for df = [12 12.5]
    [W, DI] = iwishrnd (Tau, df, [], n);
    got = axis_of (mean (W, 3) * (df - p - 1));
    % the same from wishrnd(), with the factor that the function returned
    V = wishrnd ([], df, DI, n);
    for i = 1:n, V(:,:,i) = inv (V(:,:,i)); end
    right = axis_of (mean (V, 3) * (df - p - 1));
    printf ("  df = %4.1f, mean times (df - p - 1): iwishrnd %.1f degrees, %.2f, %.2f; with the lower factor %.1f degrees, %.2f, %.2f\n", df, got, right);
    near = @(a, b) abs (mod (a - b + 90, 180) - 90) < 2.5;
    as_described &= near (got(1), other(1)) && near (right(1), turn) && abs (got(2) - 4) < 0.15 && abs (got(3) - 1) < 0.1;
  end
  printf ("  predicted from D D': %.1f degrees, %.2f, %.2f\n", other);
  if (turn > 0), as_described &= abs (other(1) - turn) > 10; end
end
exit (! as_described);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc tensors.m
