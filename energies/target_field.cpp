#include "energies/target_field.h"

#include "base/error.h"

namespace shellmatch {

template <int Dim>
TargetField<Dim>::TargetField(const Octree<Dim>& grid, std::span<const double> distance,
                              std::span<const Vec<Dim>> normal,
                              std::span<const std::array<double, n_symmetric<Dim>>> root)
    : grid_(&grid), rows_(static_cast<std::size_t>(grid.n_nodes())) {
  SHELLMATCH_CHECK(distance.size() == rows_.size() && normal.size() == rows_.size() && root.size() == rows_.size(),
                   "the template's fields must have one value for each node");
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    std::array<double, row_size> r{};
    r[0] = distance[i];
    for (int k = 0; k < Dim; ++k) r[1 + k] = normal[i][k];
    for (int k = 0; k < n_symmetric<Dim>; ++k) r[1 + Dim + k] = root[i][k];
    for (int k = 0; k < row_size; ++k) rows_[i][k / 4][k % 4] = r[k];
  }
}

template class TargetField<2>;
template class TargetField<3>;

}  // namespace shellmatch
