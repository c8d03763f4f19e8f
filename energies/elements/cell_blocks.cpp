#include "energies/elements/cell_blocks.h"

#include "base/error.h"

#include <unordered_map>
#include <utility>

namespace shellmatch {

template <int Dim>
CellBlocks<Dim>::CellBlocks(const Unknowns<Dim>& unknowns)
    : unknowns_(&unknowns), cells_per_block_(cells_per_block(unknowns.elements().size())) {
  find_local_unknowns();
  const std::size_t n_unknowns = unknowns.nodes().size();
  std::vector<Index> indices;
  schedule_ = ColouredSchedule(size(), n_unknowns, [&](std::size_t block) -> std::span<const Index> {
    indices.clear();
    for (const LocalUnknown& local : local_unknowns(block)) indices.push_back(local.unknown);
    return indices;
  });
  std::vector<char> is_assigned(n_unknowns, 0);
  for (const std::size_t block : schedule_.tasks())
    for (std::size_t i = unknowns_begin_[block]; i < unknowns_begin_[block + 1]; ++i)
      local_unknowns_[i].is_first = !std::exchange(is_assigned[local_unknowns_[i].unknown], 1);
  find_local_indices();
}

template <int Dim>
void CellBlocks<Dim>::find_local_unknowns() {
  const auto elements = unknowns_->elements();
  const std::size_t n_blocks = n_chunks(elements.size(), cells_per_block_);
  std::vector<std::size_t> last_block(unknowns_->nodes().size(), n_blocks);  // by unknown: that depends on it
  unknowns_begin_.assign(1, 0);
  Index n_met = 0;  // Unknowns numbers unknown nodes as elements meet them: those of earlier blocks are [0, n_met)
  for (std::size_t block = 0; block < n_blocks; ++block) {
    const Chunk cells = cells_of(block);
    Index n_met_now = n_met;
    for (std::size_t e = cells.begin; e < cells.end; ++e)
      for (const Index node : elements[e].nodes)
        for (const auto& [unknown, weight] : unknowns_->constraint_entries(node)) {
          if (unknown >= n_met) n_met_now = std::max(n_met_now, unknown + 1);
          else if (std::exchange(last_block[unknown], block) != block) local_unknowns_.push_back({unknown, false});
        }
    std::sort(local_unknowns_.begin() + static_cast<std::ptrdiff_t>(unknowns_begin_.back()), local_unknowns_.end(),
              [](const LocalUnknown& a, const LocalUnknown& b) { return a.unknown < b.unknown; });
    for (; n_met < n_met_now; ++n_met) local_unknowns_.push_back({n_met, false});
    unknowns_begin_.push_back(local_unknowns_.size());
  }
  local_unknowns_.shrink_to_fit();
}

template <int Dim>
void CellBlocks<Dim>::find_local_indices() {
  const auto elements = unknowns_->elements();
  local_indices_.resize(elements.size());
  constrained_begin_.assign(1, 0);
  entries_begin_.assign(1, 0);
  std::vector<std::uint16_t> local_index(unknowns_->nodes().size());  // by unknown of the current block
  std::unordered_map<Index, std::uint16_t> constrained;  // local index by constrained node of the current block
  for (std::size_t block = 0; block < size(); ++block) {
    const auto of_block = local_unknowns(block);
    for (std::size_t i = 0; i < of_block.size(); ++i) local_index[of_block[i].unknown] = static_cast<std::uint16_t>(i);
    constrained.clear();
    const Chunk cells = cells_of(block);
    for (std::size_t e = cells.begin; e < cells.end; ++e)
      for (int c = 0; c < n_corners<Dim>; ++c) {
        const Index node = elements[e].nodes[c];
        const auto entries = unknowns_->constraint_entries(node);
        if (entries.size() == 1 && entries[0].weight == 1) {
          local_indices_[e][c] = local_index[entries[0].unknown];
          continue;
        }
        const auto [found, is_new] =
            constrained.try_emplace(node, static_cast<std::uint16_t>(of_block.size() + constrained.size()));
        local_indices_[e][c] = found->second;
        if (!is_new) continue;
        for (const ConstraintEntry& entry : entries)
          local_entries_.push_back({local_index[entry.unknown], entry.weight});
        entries_begin_.push_back(local_entries_.size());
      }
    SHELLMATCH_CHECK(of_block.size() + constrained.size() < 1u << 16, "more local indices than 16 bits hold");
    constrained_begin_.push_back(constrained_begin_.back() + constrained.size());
  }
}

template class CellBlocks<2>;
template class CellBlocks<3>;

}  // namespace shellmatch
