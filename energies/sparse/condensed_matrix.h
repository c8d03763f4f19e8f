#pragma once
/// \file
/// The matrix of an element with its constraints eliminated.

#include "energies/elements/element_unknowns.h"
#include "energies/sparse/element_matrices.h"
#include "energies/sparse/node_blocks.h"

#include <array>
#include <cstring>

namespace shellmatch {

/// C^T K C: K is the matrix of an element by its corners, C expresses the corners by the element's unknowns (deal.II:
/// condensation). One block of Dim x Dim entries for each pair of unknowns.
template <int Dim, class Number>
class CondensedMatrix {
 public:
  /// \param matrix the element's, one of ElementMatrices
  CondensedMatrix(const ElementUnknowns<Dim, Number>& unknowns, const float* matrix) {
    constexpr int n = n_corners<Dim>;
    std::array<WideBlock, n * n> k;
    for (int c = 0; c < n; ++c)
      for (int d = c; d < n; ++d, matrix += Dim * Dim) {
        std::memcpy(&k[c * n + d], matrix, sizeof(WideBlock));
        if (d > c) k[d * n + c] = transposed_if<Dim>(true, k[c * n + d]);
      }
    std::array<WideBlock, n * max_size> kc;  // K C
    for (int c = 0; c < n; ++c)
      for (int j = 0; j < unknowns.size(); ++j) {
        WideBlock sum{};
        for (const auto& [d, weight] : unknowns.corners_of(j)) sum += weight * k[c * n + d];
        kc[c * max_size + j] = sum;
      }
    for (int i = 0; i < unknowns.size(); ++i)
      for (int j = i; j < unknowns.size(); ++j) {
        WideBlock sum{};
        for (const auto& [c, weight] : unknowns.corners_of(i)) sum += weight * kc[c * max_size + j];
        blocks_[i * max_size + j] = sum;
      }
  }

  /// Block of the i-th and the j-th unknown of the element, i <= j: the others follow by symmetry.
  const WideBlock& block(int i, int j) const { return blocks_[i * max_size + j]; }

 private:
  static constexpr int max_size = ElementUnknowns<Dim, Number>::max_size;
  std::array<WideBlock, max_size * max_size> blocks_;
};

}  // namespace shellmatch
