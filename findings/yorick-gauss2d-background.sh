#!/bin/sh
# yorick-yutils 1.5.2 (Yorick 2.2.04, Debian 12; the file is the same in Debian 13): gauss2d(xy, a), the Gaussian spot with a background
# a(7) + a(8) x + a(9) y that is made for fits by lmfit(), is wrong once it has a background. With nine parameters the slope along y is a(7), the
# constant, and a(9) does nothing, so that a spot on a slope cannot be fitted: the centre of a clean one ends 42 pixels off. With seven and more
# the derivatives by place, width and angle are wrong: they are to be multiplied by the peak, to which the background has been added by then. For a
# spot 10 high on 50 they are up to 600 times too large; with deriv=1, which the help of lmfit() wants used wherever there are derivatives, 100 steps
# end 0.9 pixels beside a clean spot, while differences take 5. No more is said than that the steps are used up, which blames the data. Without
# background (six parameters) all is well, as in gauss(), in one dimension, which adds the background last.
set -eu
yorick=2.2.04+dfsg1-12
yutils=1.5.2-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "yorick=$yorick" "yorick-data=$yorick" "yorick-yutils=$yutils" libx11-6 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0
for package in *.deb; do dpkg -x "$package" root; done
cat > check_gauss.i <<'I'
require, "gauss.i";
require, "lmfit.i";
write, format="Yorick %s, yorick-yutils 1.5.2\n", Y_VERSION;
as_described = 1;
xy = array(double, 40, 50, 2);
xy(..,1) = indgen(40);
xy(..,2) = indgen(50)(-,);
/* the formula of the help, written out */
func formula(xy, a)
{
  u = xy(..,1) - a(2); v = xy(..,2) - a(3);
  z = a(1)*exp(-0.5*(((u*cos(a(6)) + v*sin(a(6)))/a(4))^2 + ((v*cos(a(6)) - u*sin(a(6)))/a(5))^2));
  if (numberof(a) >= 7) z += a(7);
  if (numberof(a) >= 8) z += a(8)*xy(..,1);
  if (numberof(a) >= 9) z += a(9)*xy(..,2);
  return z;
}
spot = [10., 20.3, 24.1, 3., 5., 0.4];
for (n = 6; n <= 9; n++) {
  a = grow(spot, [50., 0.1, 0.2])(1:n);
  model = gauss2d(xy, a, grad, deriv=1);
  off = max(abs(model - formula(xy, a)));
  /* derivatives by central differences of the formula */
  worst = array(0., n);
  for (k = 1; k <= n; k++) {
    up = down = a; up(k) += 1e-5; down(k) -= 1e-5;
    d = (formula(xy, up) - formula(xy, down))/2e-5;
    worst(k) = max(abs(grad(..,k)))/max(abs(d));
  }
  write, format="%d parameters: the model is off by up to %6.2f; largest derivatives by x0, y0, dx, dy, alpha, divided by the right ones:", n, off;
  write, format=" %.2f", worst(2:6);
  write, format="%s\n", "";
  as_described &= (n < 9 ? off < 1e-9 : off > 2000. && max(abs(model - formula(xy, a) - (a(7) - a(9))*xy(..,2))) < 1e-9);
  as_described &= (n < 7 ? max(abs(worst(1:6) - 1.)) < 1e-4 : min(worst(2:6)) > 5. && abs(worst(1) - 1.) < 1e-4);
}
/* noise of the same numbers on every machine */
noise = array(0., 40, 50);
seed = 12345;
for (k = 1; k <= 2000; k++) { seed = (16807*seed)%2147483647; noise(k) = 0.02*(seed/2147483647. - 0.5); }
start = [9., 19.5, 24.8, 3.5, 5.5, 0.3, 45., 0., 0.];
func fit(text, z, n, deriv)
{
  a = start(1:n);
  r = lmfit(gauss2d, xy, a, z, deriv=deriv);
  resid = sqrt(avg((gauss2d(xy, a) - z)^2));
  beside = abs(a(2) - spot(2), a(3) - spot(3));
  write, format="%s: %3d steps, centre %.4f beside the spot, widths %.2f and %.2f, rms residual %.4f\n", text, r.niter, beside, a(4), a(5), resid;
  return [r.niter, beside, resid];
}
bare = formula(xy, spot) + noise;
r = fit("no background, derivatives           ", bare, 6, 1);
as_described &= r(2) < 0.01 && r(3) < 0.01;
r = fit("background 50, by differences        ", bare + 50., 7, 0);
as_described &= r(2) < 0.01 && r(3) < 0.01;
r = fit("background 50, derivatives           ", bare + 50., 7, 1);
as_described &= r(2) > 0.2 && r(3) > 0.1;
r = fit("50 + 0.1 x, by differences           ", bare + 50. + 0.1*xy(..,1), 8, 0);
as_described &= r(2) < 0.01 && r(3) < 0.01;
r = fit("50 + 0.1 x + 0.2 y, by differences   ", bare + 50. + 0.1*xy(..,1) + 0.2*xy(..,2), 9, 0);
as_described &= r(3) > 0.5;
write, format="%s\n", (as_described ? "as described" : "changed");
I
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
LD_LIBRARY_PATH=$libs root/usr/lib/yorick/bin/yorick -batch "$folder/check_gauss.i" > out 2>&1 || true
cat out
grep -qx 'as described' out
