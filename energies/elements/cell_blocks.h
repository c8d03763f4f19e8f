#pragma once
/// \file
/// CellBlocks of elements, and the sum of what elements give to the unknowns, patch by patch.

#include "energies/autodiff/pack.h"
#include "energies/elements/unknowns.h"
#include "energies/elements/coloured_schedule.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// A patch is so many consecutive elements, which are neighbours for the most part: few enough for what is computed
/// of them to stay in a core's cache, and many enough cell_blocks for several threads. A multiple of the lanes of a pack.
inline std::size_t cells_per_block(std::size_t n_elements) {
  constexpr std::size_t lanes = autodiff::pack_size, least = 16 * lanes, most = 64 * lanes;
  return std::clamp(n_elements / 64 / lanes * lanes, least, most);
}

/// The cell_blocks of a grid's elements. What a patch computes is held for that patch alone, added to the unknowns it
/// reaches, and forgotten: nothing is stored for every element.
template <int Dim>
class CellBlocks {
 public:
  /// An unknown node that a patch reaches; they ascend.
  struct Row {
    Index unknown;
    bool is_first;  ///< no other patch reaches it before: what is there is not yet of any meaning
  };

  /// unknowns must outlive this object.
  explicit CellBlocks(const Unknowns<Dim>& unknowns);

  std::size_t size() const { return first_row_.size() - 1; }
  std::span<const Row> rows(std::size_t patch) const {
    return {rows_.data() + first_row_[patch], first_row_[patch + 1] - first_row_[patch]};
  }

  /// Calls body(patch) for all cell_blocks, elements [begin, end) with number index, in parallel where they share no
  /// unknown. Bodies that add to the rows of their patch alone give the same bits whatever the number of threads.
  template <class Body>
  void for_each(Body&& body) const {
    const std::size_t n = unknowns_->elements().size();
    schedule_.run([&](std::size_t p) { body(Chunk{p * n_together_, std::min(n, (p + 1) * n_together_), p}); });
  }

  /// What a node that hangs gives one of the rows that carry it.
  struct Share {
    std::uint16_t row;
    float weight;
  };
  /// By the corners of an element: the row of its node in the patch, or what is left above the number of rows if it
  /// hangs or is fixed: its number among such nodes of the patch.
  const std::array<std::uint16_t, n_corners<Dim>>& rows_of_corners(std::size_t element) const {
    return rows_of_corners_[element];
  }
  /// Of a patch's node that hangs: none if it is fixed.
  std::span<const Share> shares_of(std::size_t patch, std::size_t hanging) const {
    const std::size_t h = first_hanging_[patch] + hanging;
    return {shares_.data() + first_share_[h], first_share_[h + 1] - first_share_[h]};
  }

  std::size_t n_shares() const { return shares_.size(); }

  /// Adds element gradients of a patch, element after element, corner after corner, Dim components each, to the
  /// gradient by the unknowns, within for_each(): over all cell_blocks the transpose of Unknowns::expand(), whatever the
  /// gradient held before.
  void add(const Chunk& cells, const double* element_gradients, std::span<double> gradient) const {
    const auto of_block = rows(cells.index);
    const std::size_t n_rows = of_block.size(), n_hanging = first_hanging_[cells.index + 1] - first_hanging_[cells.index];
    static thread_local std::vector<std::array<double, Dim>> sums;  // by row, then by hanging node
    sums.assign(n_rows + n_hanging, {});
    const double* g = element_gradients;
    for (std::size_t e = cells.begin; e < cells.end; ++e)
      for (const std::uint16_t row : rows_of_corners_[e])
        for (int k = 0; k < Dim; ++k) sums[row][k] += *g++;
    for (std::size_t h = 0; h < n_hanging; ++h)
      for (const Share& share : shares_of(cells.index, h))
        for (int k = 0; k < Dim; ++k) sums[share.row][k] += static_cast<double>(share.weight) * sums[n_rows + h][k];
    for (std::size_t r = 0; r < n_rows; ++r) {
      double* to = gradient.data() + static_cast<std::size_t>(of_block[r].unknown) * Dim;
      for (int k = 0; k < Dim; ++k) to[k] = of_block[r].is_first ? sums[r][k] : to[k] + sums[r][k];
    }
  }

 private:
  void find_rows_of_corners();

  const Unknowns<Dim>* unknowns_;
  std::size_t n_together_;              ///< elements of a patch
  std::vector<std::size_t> first_row_;  ///< rows of patch p: [first_row_[p], first_row_[p + 1])
  std::vector<Row> rows_;
  std::vector<std::array<std::uint16_t, n_corners<Dim>>> rows_of_corners_;  ///< by element
  std::vector<std::size_t> first_hanging_;  ///< hanging nodes of patch p: [first_hanging_[p], first_hanging_[p + 1])
  std::vector<std::size_t> first_share_;    ///< the same by hanging node
  std::vector<Share> shares_;
  ColouredSchedule schedule_;
};

extern template class CellBlocks<2>;
extern template class CellBlocks<3>;

}  // namespace shellmatch
