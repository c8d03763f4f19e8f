#include "energies/patches.h"

namespace shellmatch {

template <int Dim>
Patches<Dim>::Patches(const Unknowns<Dim>& unknowns)
    : unknowns_(&unknowns), n_together_(elements_per_patch(unknowns.elements().size())) {
  const std::size_t n_unknown = unknowns.nodes().size(), n_patches = n_chunks(unknowns.elements().size(), n_together_);
  const auto patch_of = [&](const typename Unknowns<Dim>::Place& place) {
    return static_cast<std::size_t>(place.element_corner) / n_corners<Dim> / n_together_;
  };
  // Places ascend by element: those in one patch are neighbours.
  const auto for_each_row = [&](auto&& visit) {
    for (std::size_t i = 0; i < n_unknown; ++i) {
      const auto places = unknowns.places_of(i);
      for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
        const std::size_t patch = patch_of(places[begin]);
        while (end < places.size() && patch_of(places[end]) == patch) ++end;
        visit(patch, Row{static_cast<Index>(i), static_cast<std::uint32_t>(begin),
                         static_cast<std::uint16_t>(end - begin), false});
      }
    }
  };
  first_row_.assign(n_patches + 1, 0);
  for_each_row([&](std::size_t patch, const Row&) { ++first_row_[patch + 1]; });
  for (std::size_t p = 0; p < n_patches; ++p) first_row_[p + 1] += first_row_[p];
  rows_.resize(first_row_.back());
  std::vector<std::size_t> next(first_row_.begin(), first_row_.end() - 1);
  for_each_row([&](std::size_t patch, const Row& row) { rows_[next[patch]++] = row; });

  std::vector<Index> touched;
  waves_ = Waves(n_patches, n_unknown, [&](std::size_t patch) -> std::span<const Index> {
    touched.clear();
    for (const Row& row : rows(patch)) touched.push_back(row.unknown);
    return touched;
  });
  std::vector<char> is_reached(n_unknown, 0);
  for (const std::size_t patch : waves_.pieces())
    for (std::size_t r = first_row_[patch]; r < first_row_[patch + 1]; ++r) {
      char& reached = is_reached[rows_[r].unknown];
      rows_[r].is_first = !reached;
      reached = 1;
    }
}

template class Patches<2>;
template class Patches<3>;

}  // namespace shellmatch
