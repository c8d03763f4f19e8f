#!/bin/sh
# Orocos KDL 1.5.1 (Debian 12): copies of VelocityProfile_TrapHalf, the run-up to a speed or the braking from it, are harder moves than what they are
# made from, above the limit of acceleration, where the way is short. SetProfile() sees when the way is too short to reach the greatest speed, and
# plans rightly. Clone() goes through SetProfileDuration(), by its header there to make a move longer with less acceleration; that one plans with
# maxvel all the same: the machine waits, and then reaches maxvel within the short way, with maxvel^2 / (2 way), which is above maxacc by whatever
# the way is too short: five times for a fifth of it. So copies, those of a Trajectory_Segment too, are elsewhere at the same time, and asking for a
# longer time makes for a harder move. VelocityProfile_Trap, and half profiles with way enough, are right. Nothing is said; a duration that is
# shorter than can be done leaves the right profile alone.
set -eu
version=1.5.1-2+b4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "liborocos-kdl-dev=$version" "liborocos-kdl1.5=$version" libeigen3-dev=3.4.0-4 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
lib=$(dirname "$(find root -name 'liborocos-kdl.so')")
cat > half.cpp <<'C'
#include <kdl/path_line.hpp>
#include <kdl/rotational_interpolation_sa.hpp>
#include <kdl/trajectory_segment.hpp>
#include <kdl/velocityprofile_trap.hpp>
#include <kdl/velocityprofile_traphalf.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <memory>
using namespace KDL;
static bool same(double a, double b) { return std::abs(a - b) < 1e-6 * (1 + std::abs(b)); }
struct Seen { double acceleration, speed, end, duration; };
static Seen see(const VelocityProfile& p) {
  Seen s{0, 0, p.Pos(p.Duration()), p.Duration()};
  for (int i = 1; i < 20000; ++i) {
    const double t = p.Duration() * i / 20000;
    s.acceleration = std::max(s.acceleration, std::abs(p.Acc(t)));
    s.speed = std::max(s.speed, std::abs(p.Vel(t)));
  }
  return s;
}
// The greatest distance between two profiles of the same duration.
static double apart(const VelocityProfile& a, const VelocityProfile& b) {
  double d = 0;
  for (int i = 0; i <= 1000; ++i) d = std::max(d, std::abs(a.Pos(a.Duration() * i / 1000) - b.Pos(a.Duration() * i / 1000)));
  return d;
}
int main() {
  std::printf("Orocos KDL 1.5.1\n");
  const double limit_speed = 1, limit = 2;  // 0.25 m are needed to reach 1 m/s with 2 m/s^2
  bool as_described = true;
  for (bool starting : {true, false})
    for (double way : {.05, .1, .2, .5, 1.}) {
      const bool is_short = way < .25;
      VelocityProfile_TrapHalf planned(limit_speed, limit, starting);
      planned.SetProfile(0, way);
      const Seen p = see(planned);
      std::unique_ptr<VelocityProfile> copy(planned.Clone());
      const Seen c = see(*copy);
      std::printf("%s over %g m: %.4f s, at most %.3f m/s^2; its clone %.4f s, %.3f m/s^2, and up to %.4f m away\n", starting ? "run-up" : "braking", way,
                  p.duration, p.acceleration, c.duration, c.acceleration, apart(planned, *copy));
      as_described = as_described && p.acceleration < limit + 1e-9 && same(p.end, way) && same(c.duration, p.duration);
      if (is_short) as_described = as_described && same(c.acceleration, limit_speed * limit_speed / 2 / way) && apart(planned, *copy) > .05 * way;
      else as_described = as_described && apart(planned, *copy) < 1e-9 && same(c.acceleration, limit);
      for (double longer : {.5, 1.1, 1.5, 3.}) {
        VelocityProfile_TrapHalf slow(limit_speed, limit, starting);
        VelocityProfile_Trap whole(limit_speed, limit);
        slow.SetProfileDuration(0, way, longer * p.duration);
        whole.SetProfile(0, way);
        whole.SetProfileDuration(0, way, longer * whole.Duration());
        const Seen s = see(slow), w = see(whole);
        std::printf("  times %.1f: %.4f s, at most %.3f m/s^2, %.3f m/s; whole trapezoid %.3f m/s^2, %.3f m/s\n", longer, s.duration, s.acceleration, s.speed,
                    w.acceleration, w.speed);
        as_described = as_described && same(s.end, way) && w.acceleration < limit + 1e-9;
        if (is_short && longer > 1) as_described = as_described && same(s.acceleration, limit_speed * limit_speed / 2 / way) && s.acceleration > 1.2 * limit;
        else as_described = as_described && s.acceleration < limit + 1e-9;
      }
    }
  // The same through a trajectory along a line.
  VelocityProfile_TrapHalf* run = new VelocityProfile_TrapHalf(limit_speed, limit, true);
  run->SetProfile(0, .1);
  Trajectory_Segment segment(new Path_Line(Frame(Vector(0, 0, 0)), Frame(Vector(.1, 0, 0)), new RotationalInterpolation_SingleAxis, 1), run);
  std::unique_ptr<Trajectory> copy(segment.Clone());
  const double t = .8 * segment.Duration(), x = segment.Pos(t).p.x(), y = copy->Pos(t).p.x(), a = segment.Acc(.9 * segment.Duration()).vel.x(),
               b = copy->Acc(.9 * segment.Duration()).vel.x();
  std::printf("trajectory of 0.1 m, after 0.8 of the time: at %.4f m; its clone at %.4f m; then accelerations %.3f and %.3f\n", x, y, a, b);
  as_described = as_described && same(x, .064) && same(a, 2) && same(b, 5) && same(y, 2.5 * (.2 - .2 * segment.Duration()) * (.2 - .2 * segment.Duration()));
  return as_described ? 0 : 1;
}
C
g++ -O1 -w -Iroot/usr/include -Iroot/usr/include/eigen3 half.cpp -o half -L"$lib" -lorocos-kdl
LD_LIBRARY_PATH=$lib ./half
