#pragma once
/// \file
/// Blocks of consecutive elements with a local numbering of their unknowns, and the assembly of element gradients
/// block by block.

#include "energies/autodiff/pack.h"
#include "energies/elements/coloured_schedule.h"
#include "energies/elements/unknowns.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// Number of elements in a block, a multiple of the lanes of a pack. Blocks are small enough for their element
/// gradients and matrices to stay in a core's second-level cache. 256 blocks, in some eight colours, keep 16 threads
/// busy; with 64, more than four threads gained nothing (docs/performance.md).
inline std::size_t cells_per_block(std::size_t n_elements) {
  constexpr std::size_t lanes = autodiff::pack_size, least = 8 * lanes, most = 64 * lanes;
  return std::clamp(n_elements / 256 / lanes * lanes, least, most);
}

/// The elements of a grid in blocks. What is computed for the elements of a block is stored for that block alone and
/// added to the unknowns at once, so that nothing is stored for all elements. Block p holds elements
/// [p * cells_per_block, (p + 1) * cells_per_block), most of which are neighbours.
///
/// Within a block, local index i < n = local_unknowns(p).size() stands for an unknown, and local index n + h for the
/// h-th constrained node of the block: one that hangs or is fixed.
template <int Dim>
class CellBlocks {
 public:
  /// An unknown node on which elements of a block depend.
  struct LocalUnknown {
    Index unknown;  ///< its index in the grid
    bool is_first;  ///< no earlier block in the schedule depends on it: this one assigns its sum, later ones add theirs
  };
  /// ConstraintEntry in a block's local numbering.
  struct LocalEntry {
    std::uint16_t local_index;  ///< of the unknown
    float weight;
  };
  /// Local index by corner of an element.
  using LocalIndices = std::array<std::uint16_t, n_corners<Dim>>;

  /// `unknowns` must outlive this object.
  explicit CellBlocks(const Unknowns<Dim>& unknowns);

  /// Number of blocks.
  std::size_t size() const { return unknowns_begin_.size() - 1; }
  /// Ascending by unknown.
  std::span<const LocalUnknown> local_unknowns(std::size_t block) const {
    return {local_unknowns_.data() + unknowns_begin_[block], unknowns_begin_[block + 1] - unknowns_begin_[block]};
  }
  const LocalIndices& local_indices(std::size_t element) const { return local_indices_[element]; }
  /// Constraint entries of the block's h-th constrained node: none for a fixed one.
  std::span<const LocalEntry> local_entries(std::size_t block, std::size_t h) const {
    const std::size_t i = constrained_begin_[block] + h;
    return {local_entries_.data() + entries_begin_[i], entries_begin_[i + 1] - entries_begin_[i]};
  }
  /// In all blocks together.
  std::size_t n_local_entries() const { return local_entries_.size(); }

  /// Calls body(cells) for all blocks, elements [cells.begin, cells.end) of block cells.index, in parallel where
  /// blocks have no unknown in common. Bodies that write to the local unknowns of their block alone give the same
  /// bits whatever the number of threads.
  void for_each(auto&& body) const {
    schedule_.run([&](std::size_t block) { body(cells_of(block)); });
  }

  /// Adds the element gradients of a block to the gradient by the unknowns: C^T g. Called for all blocks by
  /// for_each(), it replaces the gradient by the sum over all elements, whatever the gradient was before.
  /// \param element_gradients of the block: element after element, corner after corner, Dim components each
  /// \pre gradient.size() == unknowns.size()
  void add(const Chunk& cells, const double* element_gradients, std::span<double> gradient) const {
    const auto of_block = local_unknowns(cells.index);
    const std::size_t n = of_block.size(),
                      n_constrained = constrained_begin_[cells.index + 1] - constrained_begin_[cells.index];
    static thread_local std::vector<std::array<double, Dim>> sums;  // by local index
    sums.assign(n + n_constrained, {});
    const double* g = element_gradients;
    for (std::size_t e = cells.begin; e < cells.end; ++e)
      for (const std::uint16_t i : local_indices_[e])
        for (int k = 0; k < Dim; ++k) sums[i][k] += *g++;
    for (std::size_t h = 0; h < n_constrained; ++h)
      for (const LocalEntry& entry : local_entries(cells.index, h))
        for (int k = 0; k < Dim; ++k) sums[entry.local_index][k] += static_cast<double>(entry.weight) * sums[n + h][k];
    for (std::size_t i = 0; i < n; ++i) {
      double* to = gradient.data() + static_cast<std::size_t>(of_block[i].unknown) * Dim;
      for (int k = 0; k < Dim; ++k) to[k] = of_block[i].is_first ? sums[i][k] : to[k] + sums[i][k];
    }
  }

 private:
  void find_local_unknowns();
  void find_local_indices();
  Chunk cells_of(std::size_t block) const {
    return {block * cells_per_block_, std::min(unknowns_->elements().size(), (block + 1) * cells_per_block_), block};
  }

  const Unknowns<Dim>* unknowns_;
  std::size_t cells_per_block_;
  /// Local unknowns of block p: [unknowns_begin_[p], unknowns_begin_[p + 1]).
  std::vector<std::size_t> unknowns_begin_;
  std::vector<LocalUnknown> local_unknowns_;
  std::vector<LocalIndices> local_indices_;  ///< by element
  /// Constrained nodes of block p: [constrained_begin_[p], constrained_begin_[p + 1]).
  std::vector<std::size_t> constrained_begin_;
  /// Entries of constrained node i: [entries_begin_[i], entries_begin_[i + 1]).
  std::vector<std::size_t> entries_begin_;
  std::vector<LocalEntry> local_entries_;
  ColouredSchedule schedule_;  ///< of the blocks
};

extern template class CellBlocks<2>;
extern template class CellBlocks<3>;

}  // namespace shellmatch
