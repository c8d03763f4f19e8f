#!/bin/sh
# yorick-yutils 1.5.2 (Yorick 2.2.04, Debian 12; the file is the same in Debian 13): img_interpolate(img, x, y), said to interpolate bilinearly,
# extrapolates. It takes ceil(x) for the pixel to the left of x, so that what is left over is negative, and each value is carried on backwards
# from the next cell, along x and along y. In the middle of a cell the pixels count 0.25, -0.75, -0.75 and 2.25 in place of a quarter each, so that
# 0 and 1 give anything from -1.5 to 2.5, and noise comes out 2.5 times as strong instead of half as strong. Between the last two pixels of a row one
# gets the last. At pixels and on ramps it is exact, which hides it. img_extract_parallelogram_as_rectangle() is built on it: a turned cut out of a
# checkerboard of 0 and 1 runs from -3.5 to 4.3. In the same file img_photometry(), the 'sum of pixel values' within a circle of radius R, has
# 2 pi R^2 times their mean, twice the sum. Nothing is said.
set -eu
yorick=2.2.04+dfsg1-12
yutils=1.5.2-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "yorick=$yorick" "yorick-data=$yorick" "yorick-yutils=$yutils" libx11-6 libxcb1 libxau6 libxdmcp6 libbsd0 libmd0
for package in *.deb; do dpkg -x "$package" root; done
cat > check_img.i <<'I'
require, "img.i";
write, format="Yorick %s, yorick-yutils 1.5.2\n", Y_VERSION;
/* bilinear interpolation with plain arithmetic, and what the package does instead: the same formula from the next pixel */
func bilinear_from(z, x, y, i, j)
{
  u = x - i; v = y - j; n = dimsof(z)(2); k = long(i + (j - 1)*n);
  return (1. - u)*((1. - v)*z(k) + v*z(k + n)) + u*((1. - v)*z(k + 1) + v*z(k + 1 + n));
}
func right(z, x, y) { return bilinear_from(z, x, y, floor(x), floor(y)); }
func from_next(z, x, y) { return bilinear_from(z, x, y, ceil(x), ceil(y)); }
as_described = 1;
/* an image of 0 and 1, along its first row and in the middle of cells */
z = double((indgen(8) + indgen(7)(-,))%2);
x = [1.25, 1.5, 1.75, 2., 2.5, 2.5, 3.9, 7.5];
y = [1., 1., 1., 1., 1., 2.5, 4.1, 1.];
got = img_interpolate(z, x, y);
ref = right(z, x, y);
write, format="x %.2f, y %.2f: img_interpolate %6.3f, bilinear interpolation %6.3f\n", x, y, got, ref;
inner = 1:-1;
as_described &= max(abs(got(inner) - from_next(z, x(inner), y(inner)))) < 1e-12 && max(abs(got - ref)) > 1. && got(0) == z(8,1);
as_described &= min(ref) >= 0. && max(ref) <= 1. && min(got) < -0.4 && max(got) > 1.4;
/* what is right: pixels, and ramps within the image */
a = indgen(40)*1.; b = indgen(30)(-,)*1.;
ramp = 3. + 2.*a - 5.*b + 0.5*a*b;
x = span(1.3, 38.6, 50); y = span(2.1, 28.7, 50);
err = max(abs(img_interpolate(ramp, x, y) - (3. + 2.*x - 5.*y + 0.5*x*y)));
at_pixels = max(abs(img_interpolate(z, [2., 5., 7.], [3., 4., 6.]) - [z(2,3), z(5,4), z(7,6)]));
write, format="at pixels: %.1e off; on a ramp: %.1e off\n", at_pixels, err;
as_described &= err < 1e-11 && at_pixels == 0.;
/* a smooth spot, in the middle of cells: bilinear interpolation is a little low, this much more too high */
spot = exp(-((a - 20.5)^2 + (b - 15.5)^2)/8.);
top = img_interpolate(spot, [20.5], [15.5])(1);
write, format="the top of a smooth spot, 1: img_interpolate %.4f, bilinear interpolation %.4f\n", top, right(spot, 20.5, 15.5);
as_described &= top > 1.1;
/* noise in the middle of cells: the sum of the squared weights */
sum2 = sum2r = 0.;
for (i = 1; i <= 8; i++) for (j = 1; j <= 7; j++) {
  one = 0.*z; one(i,j) = 1.;
  sum2 += img_interpolate(one, [3.5], [3.5])(1)^2; sum2r += right(one, 3.5, 3.5)^2;
}
write, format="noise of 1 becomes %.2f in the middle of a cell, in bilinear interpolation %.2f\n", sqrt(sum2), sqrt(sum2r);
as_described &= abs(sqrt(sum2) - 2.5) < 1e-12 && abs(sqrt(sum2r) - .5) < 1e-12;
/* a turned rectangle cut out of a checkerboard of 0 and 1 with fields of 4 pixels */
board = double(((indgen(0:59)/4) + (indgen(0:59)/4)(-,))%2);
cut = img_extract_parallelogram_as_rectangle(board, 14., 45., 20., 12., 50., 18., 40, 40);
write, format="turned rectangle out of a checkerboard of 0 and 1: from %.2f to %.2f\n", min(cut), max(cut);
as_described &= min(cut) < -1. && max(cut) > 2.;
/* photometry of a uniform image and of one spot */
r = [5., 10., 20.];
flux = img_photometry(array(1., 60, 60), [30., 30., 30.], [30., 30., 30.], r);
write, format="photometry of an image of ones, radius %g: %.2f, area %.2f\n", r, flux, pi*r^2;
as_described &= max(abs(flux/(2.*pi*r^2) - 1.)) < 1e-12;
write, format="%s\n", (as_described ? "as described" : "changed");
if (!as_described) error, "the behaviour changed";
I
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
LD_LIBRARY_PATH=$libs root/usr/lib/yorick/bin/yorick -batch "$folder/check_img.i" > out 2>&1 || true
cat out
grep -qx 'as described' out
