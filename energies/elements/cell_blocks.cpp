#include "energies/elements/cell_blocks.h"

#include "base/error.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace shellmatch {

template <int Dim>
CellBlocks<Dim>::CellBlocks(const Unknowns<Dim>& unknowns)
    : unknowns_(&unknowns), n_together_(cells_per_block(unknowns.elements().size())) {
  const std::size_t n_unknown = unknowns.nodes().size(), n_patches = n_chunks(unknowns.elements().size(), n_together_);
  const auto patch_of = [&](const typename Unknowns<Dim>::Place& place) {
    return static_cast<std::size_t>(place.element_corner) / n_corners<Dim> / n_together_;
  };
  // Places ascend by element: those in one patch are neighbours.
  const auto for_each_row = [&](auto&& visit) {
    for (std::size_t i = 0; i < n_unknown; ++i) {
      std::size_t last = n_patches;
      for (const auto& place : unknowns.places_of(i))
        if (const std::size_t patch = patch_of(place); patch != std::exchange(last, patch))
          visit(patch, Row{static_cast<Index>(i), false});
    }
  };
  first_row_.assign(n_patches + 1, 0);
  for_each_row([&](std::size_t patch, const Row&) { ++first_row_[patch + 1]; });
  for (std::size_t p = 0; p < n_patches; ++p) first_row_[p + 1] += first_row_[p];
  rows_.resize(first_row_.back());
  std::vector<std::size_t> next(first_row_.begin(), first_row_.end() - 1);
  for_each_row([&](std::size_t patch, const Row& row) { rows_[next[patch]++] = row; });

  std::vector<Index> touched;
  schedule_ = ColouredSchedule(n_patches, n_unknown, [&](std::size_t patch) -> std::span<const Index> {
    touched.clear();
    for (const Row& row : rows(patch)) touched.push_back(row.unknown);
    return touched;
  });
  std::vector<char> is_reached(n_unknown, 0);
  for (const std::size_t patch : schedule_.pieces())
    for (std::size_t r = first_row_[patch]; r < first_row_[patch + 1]; ++r) {
      char& reached = is_reached[rows_[r].unknown];
      rows_[r].is_first = !reached;
      reached = 1;
    }
  find_rows_of_corners();
}

template <int Dim>
void CellBlocks<Dim>::find_rows_of_corners() {
  const auto elements = unknowns_->elements();
  rows_of_corners_.resize(elements.size());
  first_hanging_.assign(1, 0);
  first_share_.assign(1, 0);
  std::vector<std::uint16_t> row_of(unknowns_->nodes().size());  // of those of the patch at work
  std::unordered_map<Index, std::uint16_t> hanging;              // of that patch, by node
  for (std::size_t p = 0; p < size(); ++p) {
    const auto of_block = rows(p);
    for (std::size_t r = 0; r < of_block.size(); ++r) row_of[of_block[r].unknown] = static_cast<std::uint16_t>(r);
    hanging.clear();
    const std::size_t begin = p * n_together_, end = std::min(elements.size(), begin + n_together_);
    for (std::size_t e = begin; e < end; ++e)
      for (int c = 0; c < n_corners<Dim>; ++c) {
        const Index node = elements[e].nodes[c];
        const auto carriers = unknowns_->carriers_of(node);
        if (carriers.size() == 1 && carriers[0].weight == 1) {
          rows_of_corners_[e][c] = row_of[carriers[0].unknown];
          continue;
        }
        const auto [found, is_new] =
            hanging.try_emplace(node, static_cast<std::uint16_t>(of_block.size() + hanging.size()));
        rows_of_corners_[e][c] = found->second;
        if (!is_new) continue;
        for (const auto& carrier : carriers) shares_.push_back({row_of[carrier.unknown], carrier.weight});
        first_share_.push_back(shares_.size());
      }
    SHELLMATCH_CHECK(of_block.size() + hanging.size() < 1u << 16, "more rows than 16 bits can tell apart");
    first_hanging_.push_back(first_hanging_.back() + hanging.size());
  }
}

template class CellBlocks<2>;
template class CellBlocks<3>;

}  // namespace shellmatch
