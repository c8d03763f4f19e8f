#pragma once
/// \file
/// The model's matrix by unknowns: one block of Dim x Dim entries for each pair of unknown nodes that share
/// an element, hanging nodes eliminated. Summed from element matrices once, multiplied often: a row has about
/// 27 blocks in space, while the eight elements around its node have 64 each. As it is symmetric, only blocks
/// on and above the diagonal are stored: a product is bound by the memory that it reads.

#include "base/large_vector.h"
#include "energies/sparse/element_matrices.h"
#include "energies/elements/unknowns.h"
#include "energies/elements/cell_blocks.h"
#include "energies/elements/coloured_schedule.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class NodeMatrix {
 public:
  static constexpr int block_size = Dim * Dim;

  /// The pattern for one grid. Unknowns must outlive this object.
  explicit NodeMatrix(const Unknowns<Dim>& unknowns);

  /// Adds the element matrices of a block, within cell_blocks.for_each(): over all cell_blocks the sum, whatever was
  /// there before. \pre `cell_blocks` are those of the unknowns
  void add(const CellBlocks<Dim>& cell_blocks, const Chunk& cells, const ElementMatrices<Dim>& of_block);

  /// Adds factor * k[c][d] times the identity for all corners c, d of element e; k is symmetric. Not for
  /// several threads.
  void add_isotropic(std::size_t e, double factor,
                     const std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>>& k);

  /// y = A x: the same bits whatever the number of threads.
  void multiply(std::span<const double> x, std::span<double> y) const;

  /// The block on the diagonal of unknown node i.
  Mat<Dim> diagonal(std::size_t i) const;

 private:
  void find_places();
  // What rows [begin, end) and their mirror evaluator give.
  void add_product(std::size_t begin, std::size_t end, std::span<const double> x, std::span<double> y) const;

  const Unknowns<Dim>* unknowns_;
  std::size_t rows_per_slab_;  ///< that are multiplied by one thread in one go
  ColouredSchedule schedule_;                ///< of slabs: those of one wave share no row or column
  std::vector<std::size_t> first_;   ///< blocks of row i: [first_[i], first_[i + 1]), the diagonal's first
  LargeVector<Index> columns_;       ///< ascending within a row; and some more, to be asked for early
  std::vector<std::size_t> first_place_;  ///< places of element e: [first_place_[e], first_place_[e + 1])
  LargeVector<std::uint8_t> places_;      ///< for each two unknowns that carry an element: of their block in its row
  LargeVector<float> values_;        ///< blocks by columns; and some more, that the last can be read in one go
};

}  // namespace shellmatch
