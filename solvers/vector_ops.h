#pragma once
/// \file
/// Vector operations of the minimisers. They are parallel, allocate no memory, and their results do not
/// depend on the number of threads. All vectors of one call have the same length. Outputs must not overlap
/// inputs unless stated.

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>

namespace shellmatch {

/// Length of the chunks of a vector of n entries. It depends on n alone, so sums are reproducible, and yields
/// at most `max_chunks` chunks, so their partial sums fit on the stack.
inline constexpr std::size_t max_chunks = 256;
inline std::size_t chunk_length(std::size_t n) {
  return std::max<std::size_t>(2048, (n + max_chunks - 1) / max_chunks);
}

/// Calls body(begin, end) for chunks of [0, n), in parallel.
void for_chunks(std::size_t n, const auto& body) {
  const auto run = [&body](const Chunk& c) { body(c.begin, c.end); };
  parallel_chunks(n, chunk_length(n), std::ref(run));  // by reference: std::function then allocates nothing
}

/// Sums the K numbers of body(begin, end, sums) over chunks of [0, n), in the order of the chunks.
template <std::size_t K, class Body>
std::array<double, K> chunked_sums(std::size_t n, const Body& body) {
  std::array<std::array<double, K>, max_chunks> parts{};
  const auto run = [&](const Chunk& c) { body(c.begin, c.end, parts[c.index]); };
  parallel_chunks(n, chunk_length(n), std::ref(run));
  std::array<double, K> sums{};
  for (std::size_t p = 0; p < n_chunks(n, chunk_length(n)); ++p)
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
double add_scaled_and_dot(double a, std::span<const double> y, std::span<double> x, std::span<const double> z);

/// A search direction's slope g.d and Euclidean length |d|.
struct DirectionSize {
  double slope, length;
};

/// d = -g + beta d. For beta = 0 the previous d is ignored, even if it is not finite.
DirectionSize conjugate_direction(std::span<const double> g, double beta, std::span<double> d);

/// g.d and |d|
DirectionSize direction_size(std::span<const double> g, std::span<const double> d);

/// Inner products of s = x1 - x0 and y = g1 - g0.
struct PairProducts {
  double s_y, s_s, y_y;
};
PairProducts difference_pair(std::span<const double> x0, std::span<const double> x1, std::span<const double> g0,
                             std::span<const double> g1, std::span<double> s, std::span<double> y);

}  // namespace shellmatch
