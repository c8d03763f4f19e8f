#pragma once
/// \file
/// Vector operations of the minimisers: parallel, without allocation, and the same bits whatever the number
/// of threads. All vectors of one call have the same length; outputs may not overlap inputs unless said so.

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>

namespace shellmatch {

/// Length of the pieces in which vectors of n entries are worked off. It depends on n alone, so sums are
/// reproducible, and gives at most `max_pieces` pieces, so their parts fit on the stack.
inline constexpr std::size_t max_pieces = 256;
inline std::size_t piece_length(std::size_t n) {
  return std::max<std::size_t>(8192, (n + max_pieces - 1) / max_pieces);
}

/// Calls body(begin, end) on pieces of [0, n), in parallel.
template <class Body>
void for_pieces(std::size_t n, const Body& body) {
  const auto run = [&body](const Chunk& c) { body(c.begin, c.end); };
  parallel_chunks(n, piece_length(n), std::ref(run));  // by reference: std::function then allocates nothing
}

/// Adds up the K numbers of body(begin, end, sums) over pieces of [0, n), in the order of the pieces.
template <std::size_t K, class Body>
std::array<double, K> piecewise_sums(std::size_t n, const Body& body) {
  std::array<std::array<double, K>, max_pieces> parts{};
  const auto run = [&](const Chunk& c) { body(c.begin, c.end, parts[c.index]); };
  parallel_chunks(n, piece_length(n), std::ref(run));
  std::array<double, K> sums{};
  for (std::size_t p = 0; p < n_chunks(n, piece_length(n)); ++p)
    for (std::size_t k = 0; k < K; ++k) sums[k] += parts[p][k];
  return sums;
}

double dot(std::span<const double> x, std::span<const double> y);
double norm(std::span<const double> x);

/// |x - y|
double distance(std::span<const double> x, std::span<const double> y);

/// out = x + a d
void add_scaled(std::span<const double> x, double a, std::span<const double> d, std::span<double> out);

/// x *= a
void scale(double a, std::span<double> x);

/// x += a y, and returns x.z for the new x: one sweep of the two-loop recursion.
double add_scaled_and_dot(double a, std::span<const double> y, std::span<double> x,
                          std::span<const double> z);

/// A search direction's slope g.d and Euclidean length |d|.
struct DirectionSize {
  double slope, length;
};

/// d = -g + beta d; beta = 0 overwrites d whatever it held.
DirectionSize conjugate_direction(std::span<const double> g, double beta, std::span<double> d);

/// g.d and |d|
DirectionSize direction_size(std::span<const double> g, std::span<const double> d);

/// s = x1 - x0 and y = g1 - g0.
struct PairProducts {
  double s_y, s_s, y_y;
};
PairProducts difference_pair(std::span<const double> x0, std::span<const double> x1,
                             std::span<const double> g0, std::span<const double> g1, std::span<double> s,
                             std::span<double> y);

}  // namespace shellmatch
