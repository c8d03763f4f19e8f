#pragma once
/// \file
/// Blocks of Dim x Dim entries in vector registers: the operations with which NodeMatrix is assembled and multiplied.
/// A block is stored by columns in single precision; reads may extend past its end, where other entries follow.

#include <array>
#include <cstring>

namespace shellmatch {

/// One column of a block in double precision: Dim entries, followed in space by one entry of padding, which is read
/// but never written.
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

/// A whole block, padded to a register with the entries that follow it in memory.
typedef float WideBlock __attribute__((vector_size(64)));
typedef int WideIndex __attribute__((vector_size(64)));
/// Which entry of a block stands where in its transpose.
template <int Dim>
inline constexpr WideIndex transposed_order = Dim == 2 ? WideIndex{0, 2, 1, 3} : WideIndex{0, 3, 6, 1, 4, 7, 2, 5, 8};
inline constexpr WideIndex same_order{0, 1, 2, 3, 4, 5, 6, 7, 8};

/// The transpose of x if `transpose`, else x.
template <int Dim>
WideBlock transposed_if(bool transpose, const WideBlock& x) {
  return __builtin_shuffle(x, transpose ? transposed_order<Dim> : same_order);
}

/// Adds the block, without its padding, to the Dim * Dim entries at `to`.
template <int Dim>
void add_block(const WideBlock& x, float* to) {
  typedef float Front __attribute__((vector_size(Dim == 2 ? 16 : 32), aligned(4)));  // 4 of 4 entries, or 8 of 9
  Front front;
  std::memcpy(&front, &x, sizeof front);
  *reinterpret_cast<Front*>(to) += front;
  if constexpr (Dim == 3) to[8] += x[8];
}

}  // namespace shellmatch
