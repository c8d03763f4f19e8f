#pragma once
/// \file
/// The model's matrix by unknowns: one block of Dim x Dim entries for each pair of unknown nodes that share
/// an element, hanging nodes eliminated. Summed from element matrices once, multiplied often: a row has about
/// 27 blocks in space, while the eight elements around its node have 64 each.

#include "energies/element_matrices.h"
#include "energies/elements.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class NodeMatrix {
 public:
  static constexpr int block_size = Dim * Dim;

  /// The pattern for one grid. Unknowns must outlive this object.
  explicit NodeMatrix(const Unknowns<Dim>& unknowns);

  /// The sum of the element matrices. Parallel over rows, within a row in the order of the elements: the same
  /// bits whatever the number of threads.
  void assemble(const ElementMatrices<Dim>& elements);

  /// Adds factor * k[c][d] times the identity for all corners c, d of element e. Not for several threads.
  void add_isotropic(std::size_t e, double factor,
                     const std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>>& k);

  /// y = A x.
  void multiply(std::span<const double> x, std::span<double> y) const;

  /// The block on the diagonal of unknown node i.
  Mat<Dim> diagonal(std::size_t i) const;

 private:
  /// Where the block of this column stands in values_, in blocks.
  std::size_t place_of(Index row, Index column) const;

  const Unknowns<Dim>* unknowns_;
  std::vector<std::size_t> first_;  ///< blocks of row i: [first_[i], first_[i + 1])
  std::vector<Index> columns_;      ///< ascending within a row
  std::unique_ptr<float[]> values_;  ///< blocks by columns; and some more, that the last can be read in one go
};

}  // namespace shellmatch
