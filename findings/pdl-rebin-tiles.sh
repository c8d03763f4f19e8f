#!/bin/sh
# PDL 2.081 (Perl Data Language, Debian 12; Debian 13 calls dupN() likewise): rebin(), the change of an array's size of PDL::ImageND, sets copies
# side by side when it enlarges by a whole factor: 0 1 2 in 6 cells is 0 1 2 0 1 2, not 0 0 1 1 2 2. The help has it that expansion samples and
# that the intensities are kept. For whole factors there is a way of its own ('cells map 1 -> n'), which calls dupN(r); that repeats the array r
# times, not each cell. So a mask of one region that is doubled has four, its centre is wrong, and rebin() back to the old size is not the old
# array but the mean of places far apart. To 5 cells, or to 7, the same array is spread as it should be, and reduction is right, so that it shows
# for just the sizes that are asked for most. Shape, type, sum and mean come out as one expects them, and nothing is said.
set -eu
pdl=1:2.081-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "pdl=$pdl" perl perl-base perl-modules-5.36 libperl5.36 libfile-which-perl libgsl27 libgslcblas0 libgfortran5 libquadmath0 libcrypt1
for package in *.deb; do dpkg -x "$package" root; done
cat > rebin.pl <<'P'
use PDL; use PDL::ImageND; use PDL::Image2D;
print "PDL $PDL::VERSION\n";
my $ok = 1;
my $a = sequence(3);
for my $n (1, 3, 5, 6, 7, 9) { print "0 1 2 in $n cells: ", rebin($a, $n), "\n"; }
$ok &&= all(rebin($a, 6) == pdl(0, 1, 2, 0, 1, 2)) && all(rebin($a, 9) == pdl(0, 1, 2, 0, 1, 2, 0, 1, 2));
# to other sizes, and down, it is the mean over the overlap of old and new cells
sub overlap {
  my ($a, $n) = @_;
  my $m = $a->nelem; my $b = zeroes($n);
  for my $j (0..$n-1) { for my $i (0..$m-1) {
    my $lo = $i/$m > $j/$n ? $i/$m : $j/$n; my $hi = ($i+1)/$m < ($j+1)/$n ? ($i+1)/$m : ($j+1)/$n;
    $b->set($j, $b->at($j) + ($hi - $lo)*$n*$a->at($i)) if $hi > $lo;
  } }
  return $b;
}
my $wave = sin(sequence(12))->copy;
for my $n (4, 5, 6, 7, 11, 13, 17, 23, 25, 24, 36, 48) {
  my $off = abs(rebin($wave, $n) - overlap($wave, $n))->max;
  printf "12 cells of a wave in %2d: up to %.2g from the mean over the overlap, sum %.4f of %.4f\n", $n, $off, (rebin($wave, $n, {Norm => 1}))->sum, $wave->sum;
  $ok &&= ($off > 0.5) == ($n > 12 && $n % 12 == 0) && ($off < 1e-9 || $n % 12 == 0) && abs((rebin($wave, $n, {Norm => 1}))->sum - $wave->sum) < 1e-9;
}
# a mask with one region, 8 by 6 cells with the corner at (5, 4), in an image of 40 by 30
my $mask = zeroes(40, 30);
$mask->slice('5:12,4:9') .= 1;
sub centre { my $m = shift; (($m*xvals($m))->sum/$m->sum, ($m*yvals($m))->sum/$m->sum) }
for my $size ([80, 60], [81, 61], [20, 15]) {
  my $b = rebin($mask, @$size);
  my @c = centre($b);
  my $regions = cc8compt(($b > 0.5))->max;
  my @right = map { (($_->[0] + 0.5)*$_->[1] - 0.5) } [8.5, $size->[0]/40], [6.5, $size->[1]/30];
  printf "mask of one region in %d x %d: %d region(s), centre (%.2f, %.2f), right (%.2f, %.2f)\n", @$size, $regions, @c, @right;
  my $double = $size->[0] == 80;
  $ok &&= $regions == ($double ? 4 : 1) && (abs($c[0] - $right[0]) < 0.05 && abs($c[1] - $right[1]) < 0.05) == !$double;
}
my $back = rebin(rebin($mask, 80, 60), 40, 30);
printf "doubled and halved again: %.0f of 48 cells in their place\n", ($back*$mask)->sum;
$ok &&= ($back*$mask)->sum < 48;
print $ok ? "as described\n" : "changed\n";
exit !$ok;
P
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
arch=$(cd root/usr/lib && ls -d *-linux-gnu)
PERL5LIB=root/usr/lib/$arch/perl5/5.36:root/usr/share/perl5:root/usr/lib/$arch/perl/5.36:root/usr/share/perl/5.36:root/usr/lib/$arch/perl-base
export PERL5LIB
LD_LIBRARY_PATH=$libs root/usr/bin/perl rebin.pl
