#pragma once
/// \file
/// Blocks of Dim x Dim entries as registers, and an element's matrix by the unknowns that carry its nodes: what
/// NodeMatrix is summed and multiplied with.

#include "energies/sparse/element_matrices.h"
#include "energies/elements/unknowns.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace shellmatch {

/// One column of a block: Dim entries, and what follows them where that makes a whole register.
template <int Dim>
struct BlockColumn;
template <>
struct BlockColumn<2> {
  static constexpr int width = 2;
  typedef double Doubles __attribute__((vector_size(16)));
  static Doubles read(const float* from) { return Doubles{from[0], from[1]}; }
  static void add(const Doubles& x, double* to) {
    for (int k = 0; k < 2; ++k) to[k] += x[k];
  }
  /// Entry k of the result is the sum of the entries of t[k].
  static Doubles sums_of(const std::array<Doubles, 2>& t) {
    return __builtin_shufflevector(t[0], t[1], 0, 2) + __builtin_shufflevector(t[0], t[1], 1, 3);
  }
};
template <>
struct BlockColumn<3> {
  static constexpr int width = 4;
  typedef double Doubles __attribute__((vector_size(32)));
  static Doubles read(const float* from) { return Doubles{from[0], from[1], from[2], from[3]}; }
  static void add(const Doubles& x, double* to) {
    typedef double Pair __attribute__((vector_size(16), aligned(8)));
    *reinterpret_cast<Pair*>(to) += Pair{x[0], x[1]};
    to[2] += x[2];
  }
  static Doubles sums_of(const std::array<Doubles, 3>& t) {
    const Doubles a = __builtin_shufflevector(t[0], t[1], 0, 4, 2, 6) + __builtin_shufflevector(t[0], t[1], 1, 5, 3, 7);
    const Doubles b = __builtin_shufflevector(t[2], t[2], 0, 0, 2, 2) + __builtin_shufflevector(t[2], t[2], 1, 1, 3, 3);
    return __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
  }
};

/// A block and what follows it, and where its transpose finds its entries.
typedef float WideBlock __attribute__((vector_size(64)));
typedef int WideIndex __attribute__((vector_size(64)));
template <int Dim>
inline constexpr WideIndex transposed = Dim == 2 ? WideIndex{0, 2, 1, 3} : WideIndex{0, 3, 6, 1, 4, 7, 2, 5, 8};
inline constexpr WideIndex as_it_is{0, 1, 2, 3, 4, 5, 6, 7, 8};

template <int Dim>
WideBlock turned_if(bool turn, const WideBlock& x) {
  return __builtin_shuffle(x, turn ? transposed<Dim> : as_it_is);
}

template <int Dim>
void add_block(const WideBlock& x, float* to) {
  typedef float Most __attribute__((vector_size(Dim == 2 ? 16 : 32), aligned(4)));
  Most most;
  std::memcpy(&most, &x, sizeof most);
  *reinterpret_cast<Most*>(to) += most;
  if constexpr (Dim == 3) to[8] += x[8];
}

/// The unknowns that carry the nodes of an element, each once, in the order of the corners, and which it carries with
/// what weight. `Number` tells unknowns apart.
template <int Dim, class Number>
struct Carriers {
  static constexpr int most = n_corners<Dim> * (1 << (Dim - 1));  // parents of a hanging node
  struct Corner {
    int corner;
    float weight;
  };
  int n = 0;
  std::array<Number, most> unknown;
  std::array<int, most> n_corners_of;
  std::array<std::array<Corner, n_corners<Dim>>, most> corners;

  void add(Number which, int corner, float weight) {
    const auto end = unknown.begin() + n;
    const auto at = static_cast<std::size_t>(std::find(unknown.begin(), end, which) - unknown.begin());
    if (at == static_cast<std::size_t>(n)) {
      unknown[at] = which;
      n_corners_of[at] = 0;
      ++n;
    }
    corners[at][n_corners_of[at]++] = {corner, weight};
  }
  std::span<const Corner> corners_of(int i) const { return {corners[i].data(), static_cast<std::size_t>(n_corners_of[i])}; }
};

template <int Dim>
Carriers<Dim, Index> carriers_of(const Unknowns<Dim>& unknowns, std::size_t element) {
  Carriers<Dim, Index> carriers;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (const auto& carrier : unknowns.carriers_of(unknowns.elements()[element].nodes[c]))
      carriers.add(carrier.unknown, c, carrier.weight);
  return carriers;
}

/// The matrix of an element by what carries its nodes, C^T K C: block (i, j), i <= j, stands at i * most + j.
template <int Dim, class Number>
class Condensed {
 public:
  static constexpr int most = Carriers<Dim, Number>::most;
  Condensed(const Carriers<Dim, Number>& carriers, const float* matrix) {
    constexpr int n = n_corners<Dim>;
    std::array<WideBlock, n * n> k;
    for (int c = 0; c < n; ++c)
      for (int d = c; d < n; ++d, matrix += Dim * Dim) {
        std::memcpy(&k[c * n + d], matrix, sizeof(WideBlock));
        if (d > c) k[d * n + c] = turned_if<Dim>(true, k[c * n + d]);
      }
    std::array<WideBlock, n * most> half;
    for (int c = 0; c < n; ++c)
      for (int j = 0; j < carriers.n; ++j) {
        WideBlock sum{};
        for (const auto& [d, weight] : carriers.corners_of(j)) sum += weight * k[c * n + d];
        half[c * most + j] = sum;
      }
    for (int i = 0; i < carriers.n; ++i)
      for (int j = i; j < carriers.n; ++j) {
        WideBlock sum{};
        for (const auto& [c, weight] : carriers.corners_of(i)) sum += weight * half[c * most + j];
        blocks_[i * most + j] = sum;
      }
  }
  const WideBlock& block(int i, int j) const { return blocks_[i * most + j]; }

 private:
  std::array<WideBlock, most * most> blocks_;
};

}  // namespace shellmatch
