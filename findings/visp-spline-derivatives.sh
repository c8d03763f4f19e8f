#!/bin/sh
# ViSP 3.5.0 (Debian 12): derivatives of B-splines and NURBS are wrong wherever the first basis function of the interval is not flat, and those of
# B-splines depend on where the curve lies. vpBSpline::computeDersBasisFuns() compares r - 1 with an order; r is unsigned, so for r = 0, the first
# function, 0 - 1 is 4294967295, an inner loop that has nothing to do runs, and the last term of each derivative is counted twice: all orders of
# this function are twice as large. They no longer sum to 0: for a curve moved by 100 pixels computeCurveDers() is another vector.
# computeCurveDers(u, der) besides takes control points that come as many places too early in the list as the degree is, so that even its order 0
# lies elsewhere. Of the NURBS, from which vpMeNurbs has the directions to seek edges in, tangents are up to 33 degrees off for a wave, 9 for a
# circle of 9 points; with weights, from the second order on, vpNurbs::computeCurveDersPoint() multiplies by w^(k) for the row where it has w^(j)
# for the column. Points, the functions, and orders below the degree at the end of the curve are right. Nothing is said.
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
cat > derivatives.cpp <<'C'
#include <visp3/core/vpBSpline.h>
#include <visp3/me/vpNurbs.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <list>
#include <vector>
typedef std::vector<double> Knots;
typedef std::vector<vpImagePoint> Points;
static const unsigned degree = 3;
// The k-th derivative of a basis function, from its definition.
static double basis(const Knots& t, unsigned i, unsigned p, double u, unsigned k) {
  if (p == 0) return k == 0 && t[i] <= u && u < t[i + 1];
  const double a = t[i + p] - t[i], b = t[i + p + 1] - t[i + 1];
  if (k > 0) return p * ((a > 0 ? basis(t, i, p - 1, u, k - 1) / a : 0) - (b > 0 ? basis(t, i + 1, p - 1, u, k - 1) / b : 0));
  return (a > 0 ? (u - t[i]) / a * basis(t, i, p - 1, u, 0) : 0) + (b > 0 ? (t[i + p + 1] - u) / b * basis(t, i + 1, p - 1, u, 0) : 0);
}
static bool same(double a, double b) { return std::abs(a - b) < 1e-8 * (1 + std::abs(b)); }
static bool same(const vpImagePoint& a, const vpImagePoint& b) { return same(a.get_i(), b.get_i()) && same(a.get_j(), b.get_j()); }
// The sum of the control points from a place on, each with its right derivative, the first one times so much.
static vpImagePoint sum(const Knots& t, const Points& p, unsigned span, double u, unsigned k, double first, unsigned back = 0) {
  double i = 0, j = 0;
  for (unsigned n = 0; n <= degree; ++n) {
    const double f = basis(t, span - degree + n, degree, u, k) * (n == 0 && k > 0 ? first : 1);
    i += f * p[span - degree - back + n].get_i();
    j += f * p[span - degree - back + n].get_j();
  }
  return vpImagePoint(i, j);
}
int main() {
  std::printf("ViSP 3.5.0\n");
  Knots knots = {0, 0, 0, 0, .25, .5, .75, 1, 1, 1, 1};
  const double heights[] = {0, 1, 4, 2, 5, 7, 6}, widths[] = {0, 3, 2, 6, 5, 8, 9};
  bool as_described = true;
  for (double shift : {0., 100.}) {
    Points points;
    for (int n = 0; n < 7; ++n) points.push_back(vpImagePoint(10 * heights[n] + shift, 10 * widths[n] + shift));
    vpBSpline spline;
    spline.set_p(degree);
    spline.set_knots(std::list<double>(knots.begin(), knots.end()));
    spline.set_controlPoints(std::list<vpImagePoint>(points.begin(), points.end()));
    for (double u : {.05, .3, .6, .9}) {
      const unsigned span = spline.findSpan(u);
      vpBasisFunction** f = spline.computeDersBasisFuns(u, 3);
      for (unsigned k = 0; k < 4; ++k)
        for (unsigned n = 0; n <= degree; ++n) {
          const double right = basis(knots, span - degree + n, degree, u, k);
          as_described = as_described && same(f[k][n].value, n == 0 && k > 0 ? 2 * right : right);
        }
      const double total = f[1][0].value + f[1][1].value + f[1][2].value + f[1][3].value;
      vpImagePoint* d = vpBSpline::computeCurveDers(u, span, degree, 3, knots, points);
      const vpImagePoint right = sum(knots, points, span, u, 1, 1), at = spline.computeCurvePoint(u);
      const double h = 1e-5;
      const vpImagePoint ahead = spline.computeCurvePoint(u + h), behind = spline.computeCurvePoint(u - h);
      std::printf("moved by %3g, u = %.2f: derivative (%8.2f, %8.2f), right (%6.2f, %6.2f), by differences (%6.2f, %6.2f); basis derivatives sum to %.3f\n", shift, u,
                  d[1].get_i(), d[1].get_j(), right.get_i(), right.get_j(), (ahead.get_i() - behind.get_i()) / 2 / h, (ahead.get_j() - behind.get_j()) / 2 / h, total);
      as_described = as_described && std::abs((ahead.get_i() - behind.get_i()) / 2 / h - right.get_i()) < 1e-3 && same(d[0], at);
      for (unsigned k = 1; k < 4; ++k) as_described = as_described && same(d[k], sum(knots, points, span, u, k, 2)) && (shift == 0 || !same(d[k], sum(knots, points, span, u, k, 1)));
      if (span >= 2 * degree) {
        vpImagePoint* member = spline.computeCurveDers(u, 1);
        std::printf("  computeCurveDers(u, 1): order 0 (%.2f, %.2f), where the curve has (%.2f, %.2f)\n", member[0].get_i(), member[0].get_j(), at.get_i(), at.get_j());
        as_described = as_described && same(member[0], sum(knots, points, span, u, 0, 1, degree)) && same(member[1], sum(knots, points, span, u, 1, 2, degree)) && !same(member[0], at);
      }
    }
  }
  // Tangents of NURBS: of the curve above with weights of 1, and of curves through points on a circle.
  std::list<vpImagePoint> wave;
  for (int n = 0; n < 7; ++n) wave.push_back(vpImagePoint(10 * heights[n], 10 * widths[n]));
  for (int count : {0, 8, 12, 24}) {
    vpNurbs curve;
    std::list<vpImagePoint> circle;
    for (int n = 0; n <= count; ++n) circle.push_back(vpImagePoint(200 + 100 * std::sin(2 * M_PI * n / count), 200 + 100 * std::cos(2 * M_PI * n / count)));
    if (count) curve.globalCurveInterp(circle);
    else curve.set_p(degree), curve.set_knots(std::list<double>(knots.begin(), knots.end())), curve.set_controlPoints(wave), curve.set_weights(std::list<double>(7, 1.));
    double off = 0, where = 0, longest = 0;
    for (int n = 0; n < 1000; ++n) {
      const double u = (n + .5) / 1000, h = 1e-5;
      vpImagePoint* d = curve.computeCurveDersPoint(u, 1);
      const vpImagePoint a = curve.computeCurvePoint(u + h), b = curve.computeCurvePoint(u - h);
      const double i = (a.get_i() - b.get_i()) / 2 / h, j = (a.get_j() - b.get_j()) / 2 / h;
      const double angle = std::abs(std::atan2(i * d[1].get_j() - j * d[1].get_i(), i * d[1].get_i() + j * d[1].get_j())) * 180 / M_PI;
      if (angle > off) off = angle, where = u;
      longest = std::max(longest, std::hypot(d[1].get_i(), d[1].get_j()) / std::hypot(i, j));
    }
    std::printf("vpNurbs, %s of %d points: tangents up to %.1f degrees off (at u = %.4f) and up to %.2f times as long\n", count ? "circle" : "wave", count ? count + 1 : 7, off,
                where, longest);
    as_described = as_described && off > (count == 0 ? 20 : count == 8 ? 5 : 2) && off < 45 && longest > 1.3;
  }
  // The second order, with weights.
  const Knots weights = {1, 2, .5, 1, 3, 1, 2};
  vpNurbs rational;
  rational.set_p(degree);
  rational.set_knots(std::list<double>(knots.begin(), knots.end()));
  rational.set_controlPoints(wave);
  rational.set_weights(std::list<double>(weights.begin(), weights.end()));
  Points times, once;
  for (int n = 0; n < 7; ++n) times.push_back(vpImagePoint(10 * heights[n] * weights[n], 10 * widths[n] * weights[n])), once.push_back(vpImagePoint(weights[n], weights[n]));
  for (double u : {.05, .3, .6, .9}) {
    const unsigned span = rational.findSpan(u);
    double row[2][3], column[2][3];  // right, and as found
    for (int seen = 0; seen < 2; ++seen)
      for (unsigned k = 0; k < 3; ++k) {
        double w[3];
        for (unsigned n = 0; n < 3; ++n) w[n] = sum(knots, once, span, u, n, 1 + seen).get_i();
        row[seen][k] = sum(knots, times, span, u, k, 1 + seen).get_i();
        column[seen][k] = sum(knots, times, span, u, k, 1 + seen).get_j();
        for (unsigned n = 1; n <= k; ++n) {
          const double binomial = n == 1 ? k : 1;
          row[seen][k] -= binomial * w[seen ? k : n] * row[seen][k - n];
          column[seen][k] -= binomial * w[n] * column[seen][k - n];
        }
        row[seen][k] /= w[0];
        column[seen][k] /= w[0];
      }
    vpImagePoint* d = rational.computeCurveDersPoint(u, 2);
    const double h = 1e-4;
    const vpImagePoint a = rational.computeCurvePoint(u - h), b = rational.computeCurvePoint(u), c = rational.computeCurvePoint(u + h);
    std::printf("vpNurbs with weights, u = %.2f: second derivative (%.1f, %.1f), right (%.1f, %.1f), by differences (%.1f, %.1f)\n", u, d[2].get_i(), d[2].get_j(), row[0][2],
                column[0][2], (a.get_i() + c.get_i() - 2 * b.get_i()) / h / h, (a.get_j() + c.get_j() - 2 * b.get_j()) / h / h);
    as_described = as_described && std::abs((a.get_i() + c.get_i() - 2 * b.get_i()) / h / h - row[0][2]) < .1 && std::abs((a.get_j() + c.get_j() - 2 * b.get_j()) / h / h - column[0][2]) < .1;
    for (unsigned k = 0; k < 3; ++k) as_described = as_described && same(d[k], vpImagePoint(row[1][k], column[1][k]));
    as_described = as_described && !same(d[2].get_i(), row[0][2]) && !same(d[2].get_j(), column[0][2]);
  }
  return as_described ? 0 : 1;
}
C
g++ -O1 -w -I"$include" -Iroot/usr/include derivatives.cpp -o derivatives -L"$lib" -lvisp_me -lvisp_core -Wl,--allow-shlib-undefined
LD_LIBRARY_PATH="$lib:$lib/blas:$lib/lapack" ./derivatives
