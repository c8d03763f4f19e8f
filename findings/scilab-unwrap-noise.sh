#!/bin/sh
# Scilab 6.1.1 (Debian 12): unwrap() puts jumps of 2 pi into phases that need no unwrapping. The help says that a wrap is where the slopes on both
# sides are almost equal, much smaller than the step and opposite to it. unwrap.sci works out a test that asks for slopes of one sign on both sides,
# and overwrites the result in the next line by: the step is over five times the mean of the steps before and after it. The step is not compared with
# the jump, its direction not looked at; where the curve turns or is noisy, the two neighbours cancel and any step will do. Noise of 1e-6 about 0
# gets 44 jumps in 200 samples; of 200 plain sines of amplitude 1 and 12 samples, all right as they are, 112 get a jump; a step of 0.5 between two
# level stretches becomes 0.5 - 2 pi; a ramp with noise of 0.1 ends up whole turns off. A clean ramp of 0.2 a sample is unwrapped exactly. Where it
# goes wrong nothing is said (it is where no wrap is found, so that all is well, that Scilab warns of an empty matrix).
set -eu
scilab=6.1.1+dfsg2-6
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "scilab-cli=$scilab" "scilab-data=$scilab" "scilab-minimal-bin=$scilab" libmatio11 libhdf5-103-1 libhdf5-hl-100 libaec0 libsz2 \
  libfftw3-double3 libxml2 libicu72 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 libpcre3 libarpack2 libamd2 libcamd2 libccolamd2 \
  libcholmod3 libcolamd2 libmetis5 libumfpack5 libsuitesparseconfig5
for package in *.deb; do dpkg -x "$package" root; done
libs=$folder/root/usr/lib/scilab:$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
cat > unwrap.sce <<'S'
mode(-1);
warning("off");
v = getversion("scilab");
mprintf("Scilab %d.%d.%d\n", v(1), v(2), v(3));
ok = %t;
// steps over pi, taken out by whole turns: what other libraries do
function u = usual(a)
  d = diff(a);
  u = a(1) + [0, cumsum(d - 2 * %pi * round(d / (2 * %pi)))];
endfunction
function show(name, wrapped, truth)
  [u, breaks] = unwrap(wrapped);
  e = max(abs(u - truth));
  mprintf("%-52s wraps %2d, found %2d, largest error %8.3g, the usual way %8.3g\n", name, sum(abs(diff(wrapped)) > %pi), size(breaks, "*"), ..
          e, max(abs(usual(wrapped) - truth)));
  e = resume(e);
endfunction
// normal deviates of a fixed generator
function x = normal(n)
  grand("setsd", 5);
  x = grand(1, n, "nor", 0, 1);
endfunction
wrap = list();
ramp = 0.2 * (0:199);
show("clean ramp, 0.2 a sample", atan(sin(ramp), cos(ramp)), ramp);
ok = ok & e < 1e-9;
for s = [1e-6 0.01 0.1]
  a = s * normal(200);
  show(msprintf("noise of %g about 0", s), a, a);
  ok = ok & e > 6 & max(abs(usual(a) - a)) < 1e-9;
end
p = ramp + 0.1 * normal(200);
p = p - p(1);
show("ramp with noise of 0.1", atan(sin(p), cos(p)), p);
ok = ok & e > 6 & max(abs(usual(atan(sin(p), cos(p))) - p)) < 1e-9;
step = [0 0 0 0 0.5 0.5 0.5 0.5];
show("step of 0.5", step, step);
ok = ok & abs(e - 2 * %pi) < 1e-9;
bad = 0;
for k = 1:200
  a = sin(linspace(0, 2 * %pi, 12) * (1 + k / 100) + k);
  bad = bad + bool2s(max(abs(unwrap(a) - a)) > 6);
  ok = ok & max(abs(usual(a) - a)) < 1e-9;
end
mprintf("sines of amplitude 1, 12 samples: %d of 200 with jumps put in, the usual way none\n", bad);
ok = ok & bad > 100;
exit(1 - bool2s(ok));
S
SCI=$folder/root/usr/share/scilab HOME=$folder LD_LIBRARY_PATH=$libs timeout 100 root/usr/bin/scilab-cli-bin -nb -f unwrap.sce < /dev/null
