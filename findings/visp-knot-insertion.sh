#!/bin/sh
# ViSP 3.5.0 (Debian 12): operations of vpNurbs on knots, which are to leave the curve where it is, move it. curveKnotIns() finds the new control
# points rightly, and then puts the new knot before the knot at which its interval begins, not behind it, so that the knots go down: 0 .3 .25 .5 for
# 0 .25 .3 .5. The basis functions from these make another curve, for every new knot, with or without weights; put in order, the knots give the old
# curve to 1e-13. Only a further copy of a knot that is there already is right. refineKnotVectCurve() does order them; it multiplies all control
# points by their weights and divides only as many as there were before, so that the last ones, as many as were inserted, stay multiplied if their
# weights are not 1: the end of the curve flies off. removeCurveKnot(), where the knot cannot be removed within the tolerance, returns 0 as it
# should, yet leaves all control points multiplied. The last two do no harm if all the weights concerned are 1. Nothing is said.
set -eu
version=3.5.0-4
opencv=4.6.0+dfsg-12
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq "libvisp-core-dev=$version" "libvisp-core3.5=$version" "libvisp-me-dev=$version" "libvisp-me3.5=$version" \
  "libopencv-core406=$opencv" "libopencv-flann406=$opencv" "libopencv-imgproc406=$opencv" "libopencv-features2d406=$opencv" \
  "libopencv-calib3d406=$opencv" libgsl27 libgslcblas0 libtbb12 libxml2 libicu72 libblas3 liblapack3 libgfortran5 libquadmath0 libgomp1 2> /dev/null
for package in *.deb; do dpkg -x "$package" root; done
include=$(dirname "$(dirname "$(dirname "$(find root -name vpBSpline.h)")")")
lib=$(dirname "$(find "$folder/root" -name 'libvisp_core.so')")
cat > knots.cpp <<'C'
#include <visp3/me/vpNurbs.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <list>
#include <vector>
typedef std::vector<double> Row;
typedef std::vector<vpImagePoint> Points;
static const unsigned degree = 3;
struct Curve {
  Row knots, weights;
  Points control;
  unsigned span(double u) const {
    unsigned s = degree;
    while (s + degree + 2 < knots.size() && u >= knots[s + 1]) ++s;
    return s;
  }
  vpImagePoint at(double u) { return vpNurbs::computeCurvePoint(u, span(u), degree, knots, control, weights); }
};
static double apart(Curve a, Curve b) {
  double d = 0;
  for (int k = 0; k < 1000; ++k) d = std::max(d, vpImagePoint::distance(a.at(k / 1000.), b.at(k / 1000.)));
  return d;
}
static std::list<double> list(const Row& r) { return std::list<double>(r.begin(), r.end()); }
static vpNurbs nurbs(const Curve& c) {
  vpNurbs n;
  n.set_p(degree);
  n.set_knots(list(c.knots));
  n.set_weights(list(c.weights));
  n.set_controlPoints(std::list<vpImagePoint>(c.control.begin(), c.control.end()));
  return n;
}
static Curve curve(const vpNurbs& n) {
  std::list<double> k, w;
  std::list<vpImagePoint> p;
  n.get_knots(k);
  n.get_weights(w);
  n.get_controlPoints(p);
  return {Row(k.begin(), k.end()), Row(w.begin(), w.end()), Points(p.begin(), p.end())};
}
int main() {
  std::printf("ViSP 3.5.0\n");
  const double heights[] = {0, 1, 4, 2, 5, 7, 6}, widths[] = {0, 3, 2, 6, 5, 8, 9};
  bool as_described = true;
  for (const Row& weights : {Row(7, 1.), Row{1, 2, .5, 1, 3, 1, 1}, Row{1, 2, .5, 1, 3, 4, 2}}) {
    Curve c{{0, 0, 0, 0, .25, .5, .75, 1, 1, 1, 1}, weights, {}};
    for (int n = 0; n < 7; ++n) c.control.push_back(vpImagePoint(100 + 10 * heights[n], 100 + 10 * widths[n]));
    const bool plain = weights[1] == 1, end = weights[6] != 1;
    std::printf("weights");
    for (double w : weights) std::printf(" %g", w);
    std::printf("\n");
    for (double u : {.1, .3, .4, .6, .9})
      for (unsigned times : {1, 2}) {
        vpNurbs n = nurbs(c);
        n.curveKnotIns(u, 0, times);
        Curve mended = curve(n);
        double worst = 0;
        if (times == 1) for (double t : {.05, .12, .2, .27, .35, .45, .55, .65, .7, .8, .95}) worst = std::max(worst, vpImagePoint::distance(n.computeCurvePoint(t), c.at(t)));
        if (times == 1) {
          std::printf("  %g inserted: knots", u);
          for (double k : mended.knots) std::printf(" %g", k);
        } else {
          std::printf("  twice");
        }
        const unsigned place = c.span(u);
        bool before = !std::is_sorted(mended.knots.begin(), mended.knots.end());
        for (unsigned k = 0; k < times; ++k) before = before && mended.knots[place + k] == u;
        std::sort(mended.knots.begin(), mended.knots.end());
        if (times == 1) std::printf(", curve moved by %.3f", worst);
        std::printf("; with the knots in order %.1g\n", apart(c, mended));
        as_described = as_described && before && apart(c, mended) < 1e-10 && (times == 2 || worst > 1);
      }
    vpNurbs again = nurbs(c);
    again.curveKnotIns(.5, 1, 1);
    std::printf("  .5, which is there, inserted once more: moved by %.1g\n", apart(c, curve(again)));
    as_described = as_described && apart(c, curve(again)) < 1e-10;
    for (Row more : {Row{.3}, Row{.3, .6}, Row{.1, .2, .3, .9}}) {
      vpNurbs n = nurbs(c);
      n.refineKnotVectCurve(more.data(), more.size() - 1);  // the index of the last one
      Curve found = curve(n), mended = found;
      for (size_t k = 7; k < mended.control.size(); ++k) mended.control[k].set_ij(mended.control[k].get_i() / mended.weights[k], mended.control[k].get_j() / mended.weights[k]);
      std::printf("  refined by %zu knots: moved by %.4g; with the last %zu control points divided by their weights %.1g\n", more.size(), apart(c, found), more.size(), apart(c, mended));
      as_described = as_described && std::is_sorted(found.knots.begin(), found.knots.end()) && apart(c, mended) < 1e-10;
      as_described = as_described && (plain || (!end && more.size() < 3) ? apart(c, found) < 1e-10 : apart(c, found) > 50);
    }
    Curve found = c;
    const unsigned removed = vpNurbs::removeCurveKnot(.5, 5, 1, 1e-3, 1, degree, found.knots, found.control, found.weights);
    double multiplied = 0;
    for (int k = 0; k < 7; ++k)
      multiplied = std::max(multiplied, vpImagePoint::distance(found.control[k], vpImagePoint(c.control[k].get_i() * weights[k], c.control[k].get_j() * weights[k])));
    std::printf("  .5 to be removed: %u removed, knots %s, moved by %.4g\n", removed, found.knots == c.knots ? "the same" : "others", apart(c, found));
    as_described = as_described && removed == 0 && found.knots == c.knots && found.weights == c.weights && multiplied < 1e-10 && (plain ? apart(c, found) < 1e-10 : apart(c, found) > 50);
  }
  return as_described ? 0 : 1;
}
C
g++ -O1 -w -I"$include" -Iroot/usr/include knots.cpp -o knots -L"$lib" -lvisp_me -lvisp_core -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH="$lib:$lib/blas:$lib/lapack" ./knots
