#include "solvers/vector_ops.h"

#include <cmath>

namespace shellmatch {

namespace {

// Adds term(i, j) for i in [begin, end) in eight partial sums, which the compiler keeps in vector registers.
// The order of the additions depends on the chunk alone, not on the alignment of the data.
template <class Term>
double lane_sum(std::size_t begin, std::size_t end, const Term& term) {
  constexpr std::size_t n_lanes = 8;
  double lanes[n_lanes] = {};
  std::size_t i = begin;
  for (; i + n_lanes <= end; i += n_lanes)
    for (std::size_t j = 0; j < n_lanes; ++j) lanes[j] += term(i + j);
  for (std::size_t j = 0; i < end; ++i, ++j) lanes[j] += term(i);
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

}  // namespace

double dot(std::span<const double> x, std::span<const double> y) {
  return chunked_sums<1>(x.size(), [&](std::size_t b, std::size_t e, auto& sums) {
    sums[0] = lane_sum(b, e, [p = x.data(), q = y.data()](std::size_t i) { return p[i] * q[i]; });
  })[0];
}

double norm(std::span<const double> x) { return std::sqrt(dot(x, x)); }

double distance(std::span<const double> x, std::span<const double> y) {
  return std::sqrt(chunked_sums<1>(x.size(), [&](std::size_t b, std::size_t e, auto& sums) {
    sums[0] = lane_sum(b, e, [p = x.data(), q = y.data()](std::size_t i) { return (p[i] - q[i]) * (p[i] - q[i]); });
  })[0]);
}

void add_scaled(std::span<const double> x, double a, std::span<const double> d, std::span<double> out) {
  for_chunks(x.size(), [&, p = x.data(), q = d.data(), o = out.data()](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i) o[i] = p[i] + a * q[i];
  });
}

void scale(double a, std::span<double> x) {
  for_chunks(x.size(), [a, p = x.data()](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i) p[i] *= a;
  });
}

double add_scaled_and_dot(double a, std::span<const double> y, std::span<double> x, std::span<const double> z) {
  return chunked_sums<1>(x.size(), [&](std::size_t b, std::size_t e, auto& sums) {
    sums[0] = lane_sum(b, e, [a, p = x.data(), q = y.data(), r = z.data()](std::size_t i) {
      p[i] += a * q[i];
      return p[i] * r[i];
    });
  })[0];
}

DirectionSize conjugate_direction(std::span<const double> g, double beta, std::span<double> d) {
  const double* p = g.data();
  double* q = d.data();
  const auto sums = chunked_sums<2>(g.size(), [&](std::size_t b, std::size_t e, auto& part) {
    // For beta = 0, 0 * infinity must not enter the new direction.
    for (std::size_t i = b; i < e; ++i) q[i] = beta == 0 ? -p[i] : beta * q[i] - p[i];
    part[0] = lane_sum(b, e, [=](std::size_t i) { return p[i] * q[i]; });
    part[1] = lane_sum(b, e, [=](std::size_t i) { return q[i] * q[i]; });
  });
  return {sums[0], std::sqrt(sums[1])};
}

DirectionSize direction_size(std::span<const double> g, std::span<const double> d) {
  const double *p = g.data(), *q = d.data();
  const auto sums = chunked_sums<2>(g.size(), [&](std::size_t b, std::size_t e, auto& part) {
    part[0] = lane_sum(b, e, [=](std::size_t i) { return p[i] * q[i]; });
    part[1] = lane_sum(b, e, [=](std::size_t i) { return q[i] * q[i]; });
  });
  return {sums[0], std::sqrt(sums[1])};
}

PairProducts difference_pair(std::span<const double> x0, std::span<const double> x1, std::span<const double> g0,
                             std::span<const double> g1, std::span<double> s, std::span<double> y) {
  const auto sums = chunked_sums<3>(x0.size(), [&](std::size_t b, std::size_t e, auto& part) {
    const double *p0 = x0.data(), *p1 = x1.data(), *q0 = g0.data(), *q1 = g1.data();
    double *sp = s.data(), *yp = y.data();
    for (std::size_t i = b; i < e; ++i) {
      sp[i] = p1[i] - p0[i];
      yp[i] = q1[i] - q0[i];
    }
    part[0] = lane_sum(b, e, [=](std::size_t i) { return sp[i] * yp[i]; });
    part[1] = lane_sum(b, e, [=](std::size_t i) { return sp[i] * sp[i]; });
    part[2] = lane_sum(b, e, [=](std::size_t i) { return yp[i] * yp[i]; });
  });
  return {sums[0], sums[1], sums[2]};
}

}  // namespace shellmatch
