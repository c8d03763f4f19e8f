#pragma once
/// \file
/// The sparse matrix of Newton's model by unknowns.

#include "base/large_vector.h"
#include "energies/elements/cell_blocks.h"
#include "energies/elements/coloured_schedule.h"
#include "energies/elements/element_unknowns.h"
#include "energies/elements/unknowns.h"
#include "energies/sparse/element_matrices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// Symmetric matrix with a block of Dim x Dim entries for each pair of unknown nodes that share an element,
/// constraints eliminated: the sum of C^T K C over the elements. It is assembled once and multiplied often: in space
/// a row has about 27 blocks, whereas the matrices of the eight elements around a node have 64 each. A product is
/// bound by memory bandwidth, so only blocks on and above the diagonal are stored, in single precision, in compressed
/// rows.
template <int Dim>
class NodeMatrix {
 public:
  static constexpr int block_size = Dim * Dim;

  /// Computes the sparsity pattern. `unknowns` must outlive this object.
  explicit NodeMatrix(const Unknowns<Dim>& unknowns);

  /// Adds the element matrices of a block. Called for all blocks by cell_blocks.for_each(), it replaces the matrix by
  /// the sum over all elements, whatever the matrix was before. \pre `cell_blocks` are those of the same unknowns
  void add(const CellBlocks<Dim>& cell_blocks, const Chunk& cells, const ElementMatrices<Dim>& of_block);

  /// Adds k(c, d) m for all corners c, d of element e. Not thread-safe. \pre k and m are symmetric
  template <class CornerFactor>
  void add_to_element(std::size_t e, CornerFactor&& k, const Mat<Dim>& m) {
    const auto unknowns = element_unknowns(*unknowns_, e);
    const std::uint8_t* offset = block_offsets_.data() + offsets_begin_[e];
    for (int i = 0; i < unknowns.size(); ++i)
      for (int j = i; j < unknowns.size(); ++j) {
        double sum = 0;
        for (const auto& a : unknowns.corners_of(i))
          for (const auto& b : unknowns.corners_of(j))
            sum += static_cast<double>(a.weight * b.weight) * k(a.corner, b.corner);
        const auto row = static_cast<std::size_t>(std::min(unknowns[i], unknowns[j]));
        float* block = values_.data() + (row_begin_[row] + *offset++) * block_size;
        for (int l = 0; l < block_size; ++l) block[l] += static_cast<float>(sum * m.data()[l]);
      }
  }

  /// y = A x: the same bits whatever the number of threads. \pre both have the size of the unknowns
  void multiply(std::span<const double> x, std::span<double> y) const;

  /// Block (i, i), of unknown node i.
  Mat<Dim> diagonal(std::size_t i) const;

  /// Number of blocks that are stored.
  std::size_t n_blocks() const { return row_begin_.back(); }
  /// Number of blocks of all condensed element matrices, on and above their diagonals.
  std::size_t n_element_blocks() const { return block_offsets_.size(); }

 private:
  void find_pattern();
  void find_block_offsets();
  /// Adds the products of rows [begin, end) with x to y, and those of their transposes below the diagonal.
  void add_product(std::size_t begin, std::size_t end, std::span<const double> x, std::span<double> y) const;

  const Unknowns<Dim>* unknowns_;
  std::size_t rows_per_slab_;           ///< rows of one task of a product
  ColouredSchedule schedule_;           ///< of slabs: those of one colour have no row or column in common
  std::vector<std::size_t> row_begin_;  ///< blocks of row i: [row_begin_[i], row_begin_[i + 1]), the diagonal one first
  LargeVector<Index> columns_;          ///< by block, ascending within a row; padded for prefetching
  /// Blocks of element e's condensed matrix: [offsets_begin_[e], offsets_begin_[e + 1]).
  std::vector<std::size_t> offsets_begin_;
  /// By block (i, j), i <= j, of an element's condensed matrix: the offset within its row of the block it is added
  /// to.
  LargeVector<std::uint8_t> block_offsets_;
  LargeVector<float> values_;  ///< by block, columns within; padded so that the last column can be read as a register
};

}  // namespace shellmatch
