#!/bin/sh
# CGAL 5.5.1 (Debian 12; the file is the same in 6.0.1 of Debian 13): Aff_transformation_2(REFLECTION, line) is right for points only. For vectors,
# and so for directions, lines and circles, Reflection_repC2::transform() has the formula of the points: it adds the translation that a vector must
# not have. inverse() does the reverse: it takes its numbers from cartesian(), whose last column is 0, so that a point mirrored and brought back is
# off by twice the distance of the axis from the origin; and is_even() says that a reflection keeps the orientation. Mirrored at x = 2, the vector
# (1,0) is (3,0), a line lies elsewhere than its own points, and a circle of radius 1 has radius 3. It does not show if the axis goes through the
# origin, nor after composition with another transformation (the usual scaling by 1 mends it), nor in the homogeneous kernel, which has code of its
# own. Nothing is said: the manual has 'introduces a reflection by a line' and no limits.
set -eu
version=5.5.1-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libcgal-dev=$version" libboost1.74-dev=1.74.0+ds1-21 libgmp-dev=2:6.2.1+dfsg1-1.1 libgmp10=2:6.2.1+dfsg1-1.1 \
  libmpfr-dev=4.2.0-1 libmpfr6=4.2.0-1
for package in *.deb; do dpkg -x "$package" root; done
lib=$folder/root/usr/lib/x86_64-linux-gnu
cat > mirror.cpp <<'C'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_homogeneous.h>
#include <CGAL/version.h>
#include <cmath>
#include <cstdio>
#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using V = K::Vector_2;
using Map = CGAL::Aff_transformation_2<K>;
struct Seen {
  double point, vector, direction, line, back, radius; // errors, but the radius of the mirrored unit circle
  bool even;
};
// What a map that mirrors at `axis` does; the right places come from the foot of the perpendicular to the axis.
Seen look(const char* what, const Map& map, const K::Line_2& axis) {
  const auto mirrored = [&](const P& p) { return p + 2 * (axis.projection(p) - p); };
  const P p(0.5, -1);
  const V v(1, 0.5), right = mirrored(p + v) - mirrored(p);
  const K::Line_2 line = K::Line_2(p, v).transform(map);
  const V d = map.transform(K::Direction_2(v)).to_vector();
  const K::Circle_2 circle = K::Circle_2(P(0, 0), 1).orthogonal_transform(map);
  Seen s;
  s.point = std::sqrt(CGAL::squared_distance(map.transform(p), mirrored(p)));
  s.vector = std::sqrt((map.transform(v) - right).squared_length());
  s.direction = std::acos(std::fmin(1, d * right / std::sqrt(d.squared_length() * right.squared_length()))) * 180 / CGAL_PI;
  s.line = std::sqrt(CGAL::squared_distance(mirrored(p + 4 * v), line));
  s.back = std::sqrt(CGAL::squared_distance(map.inverse().transform(map.transform(p)), p));
  s.radius = std::sqrt(circle.squared_radius());
  s.even = map.is_even();
  std::printf("%s:\n  errors: point %.2f, vector %.2f, direction %.1f degrees, line %.2f, back by inverse() %.2f;", what, s.point, s.vector,
              s.direction, s.line, s.back);
  std::printf(" unit circle's radius %.2f, even: %s\n", s.radius, s.even ? "yes" : "no");
  return s;
}
bool is_right(const Seen& s) {
  return s.point < 1e-9 && s.vector < 1e-9 && s.direction < 1e-5 && s.line < 1e-9 && s.back < 1e-9 && std::abs(s.radius - 1) < 1e-9;
}
int main() {
  std::printf("CGAL %s\n", TEXT(CGAL_VERSION));
  const K::Line_2 upright(P(2, 0), P(2, 1)), slanted(P(0, 1), P(2, 2)), through(P(0, 0), P(2, 1));
  const Map map(CGAL::REFLECTION, upright);
  const V one = map.transform(V(1, 0));
  const P to = map.transform(P(1, 0)), back = map.inverse().transform(to);
  std::printf("at x = 2: vector (1,0) -> (%g,%g); point (1,0) -> (%g,%g), by inverse() -> (%g,%g); ", one.x(), one.y(), to.x(), to.y(),
              back.x(), back.y());
  std::printf("matrix %g %g %g / %g %g %g\n", map.m(0, 0), map.m(0, 1), map.m(0, 2), map.m(1, 0), map.m(1, 1), map.m(1, 2));
  bool as_described = one == V(3, 0) && to == P(3, 0) && back == P(-3, 0) && map.m(0, 2) == 0;
  const Seen a = look("at x = 2", map, upright);
  as_described &= a.point < 1e-9 && std::abs(a.vector - 4) < 1e-9 && a.direction > 45 && a.line > 2 && std::abs(a.back - 4) < 1e-9;
  as_described &= std::abs(a.radius - 3) < 1e-9 && a.even;
  const Seen b = look("at y = 1 + x/2", Map(CGAL::REFLECTION, slanted), slanted);
  as_described &= b.point < 1e-9 && b.vector > 1.5 && b.direction > 20 && b.line > 3 && b.back > 1.5 && b.radius > 1.5 && b.even;
  const Seen c = look("at y = x/2, through the origin", Map(CGAL::REFLECTION, through), through);
  as_described &= is_right(c) && c.even;
  const Seen d = look("at y = 1 + x/2, times a scaling by 1", Map(CGAL::REFLECTION, slanted) * Map(CGAL::SCALING, 1.0), slanted);
  as_described &= is_right(d) && !d.even;
  using H = CGAL::Simple_homogeneous<double>;
  const CGAL::Aff_transformation_2<H> other(CGAL::REFLECTION, H::Line_2(H::Point_2(2, 0), H::Point_2(2, 1)));
  const H::Vector_2 v = other.transform(H::Vector_2(1, 0));
  std::printf("homogeneous kernel, at x = 2: vector (1,0) -> (%g,%g), even: %s\n", v.hx() / v.hw(), v.hy() / v.hw(), other.is_even() ? "yes" : "no");
  as_described &= v.hx() / v.hw() == -1 && v.hy() == 0 && !other.is_even();
  return !as_described;
}
C
c++ -std=c++17 -O0 -w -I root/usr/include -I root/usr/include/x86_64-linux-gnu mirror.cpp -o mirror -L "$lib" -lmpfr -lgmp
LD_LIBRARY_PATH=$lib ./mirror
