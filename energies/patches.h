#pragma once
/// \file
/// Patches of elements, and the sum of what elements give to the unknowns, patch by patch.

#include "energies/autodiff/pack.h"
#include "energies/elements.h"
#include "energies/waves.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// A patch is so many consecutive elements, which are neighbours for the most part: few enough for what is computed
/// of them to stay in a core's cache, and many enough patches for several threads. A multiple of the lanes of a pack.
inline std::size_t elements_per_patch(std::size_t n_elements) {
  constexpr std::size_t lanes = autodiff::pack_size, least = 16 * lanes, most = 64 * lanes;
  return std::clamp(n_elements / 64 / lanes * lanes, least, most);
}

/// The patches of a grid's elements. What a patch computes is held for that patch alone, added to the unknowns it
/// reaches, and forgotten: nothing is stored for every element.
template <int Dim>
class Patches {
 public:
  /// An unknown node that a patch reaches.
  struct Row {
    Index unknown;
    std::uint32_t first_place;  ///< of those where it counts in this patch, among Unknowns::places_of
    std::uint16_t n_places;
    bool is_first;  ///< no other patch reaches it before: what is there is not yet of any meaning
  };

  /// unknowns must outlive this object.
  explicit Patches(const Unknowns<Dim>& unknowns);

  std::size_t size() const { return first_row_.size() - 1; }
  std::span<const Row> rows(std::size_t patch) const {
    return {rows_.data() + first_row_[patch], first_row_[patch + 1] - first_row_[patch]};
  }
  /// Where the unknown of a row counts in its patch.
  std::span<const typename Unknowns<Dim>::Place> places_of(const Row& row) const {
    return unknowns_->places_of(static_cast<std::size_t>(row.unknown)).subspan(row.first_place, row.n_places);
  }

  /// Calls body(patch) for all patches, elements [begin, end) with number index, in parallel where they share no
  /// unknown. Bodies that add to the rows of their patch alone give the same bits whatever the number of threads.
  template <class Body>
  void for_each(Body&& body) const {
    const std::size_t n = unknowns_->elements().size();
    waves_.run([&](std::size_t p) { body(Chunk{p * n_together_, std::min(n, (p + 1) * n_together_), p}); });
  }

  /// Adds element gradients of a patch, element after element, corner after corner, Dim components each, to the
  /// gradient by the unknowns, within for_each(): over all patches the transpose of Unknowns::expand(), whatever the
  /// gradient held before.
  void add(const Chunk& patch, const double* element_gradients, std::span<double> gradient) const {
    for (const Row& row : rows(patch.index)) {
      std::array<double, Dim> sum{};
      for (const auto& place : places_of(row)) {
        const double* g =
            element_gradients + (static_cast<std::size_t>(place.element_corner) - patch.begin * n_corners<Dim>)*Dim;
        for (int k = 0; k < Dim; ++k) sum[k] += static_cast<double>(place.weight) * g[k];
      }
      double* to = gradient.data() + static_cast<std::size_t>(row.unknown) * Dim;
      for (int k = 0; k < Dim; ++k) to[k] = row.is_first ? sum[k] : to[k] + sum[k];
    }
  }

 private:
  const Unknowns<Dim>* unknowns_;
  std::size_t n_together_;              ///< elements of a patch
  std::vector<std::size_t> first_row_;  ///< rows of patch p: [first_row_[p], first_row_[p + 1])
  std::vector<Row> rows_;
  Waves waves_;
};

extern template class Patches<2>;
extern template class Patches<3>;

}  // namespace shellmatch
