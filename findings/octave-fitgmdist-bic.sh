#!/bin/sh
# octave-statistics 1.5.3 (Debian 12): AIC and BIC of fitgmdist() are right for numbers, and too low for points in the plane and beyond. A mixture
# of k normal distributions in d dimensions has k d means; fitgmdist.m counts 2*rows(mu)-1 for means and weights together, which is k + k - 1, as
# if each mean were one number. Each further component costs d - 1 parameters too few, half of them or nearly so if the covariances are
# diagonal, so that the criteria, made to tell how many clusters there are, find too many: 200 points from one normal distribution in 10
# dimensions are three clusters by AIC. The fit itself and its likelihood are right, and nothing is said; in one dimension, as one
# may try first, the counts agree.
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
cat > count.m <<'M'
warning ("off", "all");
addpath (genpath ("root/usr/share/octave/packages/statistics-1.5.3"));
printf ("Octave %s, octave-statistics 1.5.3\n", version ());
as_described = true;
randn ("twister", 7); rand ("twister", 7);
n = 200;
for d = [1 2 10]
  X = randn (n, d);                                # one cluster
  aic = right = zeros (1, 3);
  for k = 1:3
    g = fitgmdist (X, k, "CovarianceType", "diagonal", "Replicates", 5, "RegularizationValue", 1e-3);
    % the likelihood once more, by hand
    p = zeros (n, 1);
    for c = 1:k
      s = reshape (g.Sigma(:,:,c), 1, []);
      p += g.ComponentProportion(c) * prod (exp (-(X - g.mu(c,:)) .^ 2 ./ (2 * s)) ./ sqrt (2 * pi * s), 2);
    end
    l = sum (log (p));
    parameters = numel (g.mu) + numel (g.Sigma) + k - 1;
    aic(k) = g.AIC; right(k) = -2 * l + 2 * parameters;
    printf ("d = %2d, k = %d: AIC %.2f, right %.2f; BIC %.2f, right %.2f; counted %g parameters of %d\n", d, k, g.AIC, right(k), ...
            g.BIC, -2 * l + parameters * log (n), (g.AIC + 2 * l) / 2, parameters);
    as_described &= abs (right(k) - g.AIC - 2 * k * (d - 1)) < 0.5;
  end
  [~, found] = min (aic); [~, best] = min (right);
  printf ("        clusters by AIC: %d, with all parameters counted: %d\n", found, best);
  if (d == 10), as_described &= best == 1 && found > 1; end
end
exit (! as_described);
M
OCTAVE_HOME=$folder/root/usr LD_LIBRARY_PATH=$libs root/usr/bin/octave-cli --no-history --quiet --norc count.m
