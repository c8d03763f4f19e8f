#!/bin/sh
# PDL 2.081 (Perl Data Language, Debian 12; both factors are the same in Debian 13): t_cubic(st => s), the cubic pincushion of PDL::Transform
# 'with inverse', does not come back. Forwards it divides by 1 + s^2, backwards it multiplies by 1 + s; the help has 1 + |s|, with which the radius
# l0 is to stay where it is. So forwards the radius moves (s = 0.2: 1 goes to 1.154), and there and back again is off, by 11 % at l0 and by more or
# less elsewhere. map() takes the inverse to make an image, apply() goes forwards, so that points moved with an image do not lie on it: a spot that
# apply() puts 28.8 from the centre is 25.0 from it in the image. s = 1, where the two factors agree, is right, and s = 0, the default, divides
# by 0 on the way back: NaN. t_quadratic(), of the same make, has the factor of the help in both directions. Nothing is said.
set -eu
pdl=1:2.081-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "pdl=$pdl" perl perl-base perl-modules-5.36 libperl5.36 libfile-which-perl libgsl27 libgslcblas0 libgfortran5 libquadmath0 libcrypt1
for package in *.deb; do dpkg -x "$package" root; done
cat > cubic.pl <<'P'
use PDL; use PDL::Transform; use PDL::Image2D;
print "PDL $PDL::VERSION\n";
my $ok = 1;
my $points = pdl([0.3, 0.7], [1, 0], [0, 2], [-1.5, 0.5]);
for my $make (['t_quadratic', \&t_quadratic], ['t_cubic', \&t_cubic]) {
  my ($name, $f) = @$make;
  for my $s (0.1, 0.2, 0.5, 1, 2) {
    my $t = $f->({st => $s, d => 2});
    my $there = $t->apply($points);
    my $back = abs($t->invert($there) - $points)->max;
    my $fixed = $t->apply(pdl(1, 0))->at(0);
    my $home = $t->invert($t->apply(pdl(1, 0)))->at(0);
    printf "%-11s st = %3.1f: radius l0 = 1 goes to %.4f and comes back to %.4f; there and back, 4 points are off by up to %.1e\n", $name, $s, $fixed, $home, $back;
    if ($name eq 't_quadratic' || $s == 1) { $ok &&= $back < 1e-9 && abs($fixed - 1) < 1e-9; }
    else {
      $ok &&= $back > 0.05 && abs($fixed - (1 + $s)/(1 + $s**2)) < 1e-9;
      # what was to be inverted, if the way there had the factor of the help
      my $help = ($points + $s*$points**3)/(1 + $s);
      my $right = abs($t->invert($help) - $points)->max;
      $ok &&= $right < 1e-9;
    }
  }
}
# one image: a spot, moved with map(), and its centre, moved with apply()
my $n = 121; my $centre = 60;
my $t = t_compose(t_linear({post => [$centre, $centre]}), t_cubic({st => 0.2, l0 => 25, d => 2}), t_linear({pre => [-$centre, -$centre]}));
my ($x, $y) = ($centre + 25, $centre);
my $spot = exp(-((xvals($n, $n) - $x)**2 + (yvals($n, $n) - $y)**2)/8);
my $image = $spot->map($t, {pix => 1, method => 'l'});
my $top = ($image*($image > 0.5));
my $at = ($top*xvals($n, $n))->sum/$top->sum - $centre;
my $to = $t->apply(pdl($x, $y))->at(0) - $centre;
printf "a spot at the radius l0 = 25: apply() puts it at %.2f, in the image of map() it is at %.2f\n", $to, $at;
$ok &&= abs($to - 25*1.2/1.04) < 1e-6 && abs($at - 25) < 0.2;
my $none = t_cubic({d => 2})->invert(pdl(0.3, 0.7))->at(0);
print "without st, there: ", t_cubic({d => 2})->apply(pdl(0.3, 0.7)), ", back: $none\n";
$ok &&= $none != $none;
print $ok ? "as described\n" : "changed\n";
exit !$ok;
P
libs=$(find "$folder/root" -name '*.so.*' -exec dirname {} \; | sort -u | tr '\n' ':')
arch=$(cd root/usr/lib && ls -d *-linux-gnu)
PERL5LIB=root/usr/lib/$arch/perl5/5.36:root/usr/share/perl5:root/usr/lib/$arch/perl/5.36:root/usr/share/perl/5.36:root/usr/lib/$arch/perl-base
export PERL5LIB
LD_LIBRARY_PATH=$libs root/usr/bin/perl cubic.pl
