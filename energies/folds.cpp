#include "energies/folds.h"

#include "base/parallel.h"
#include "energies/fold_barrier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shellmatch {

template <int Dim>
std::pair<double, double> determinant_bounds(const Element<Dim>& element, std::span<const Vec<Dim>> phi) {
  std::array<double, n_corners<Dim> * Dim> dofs;
  double volume = 1;
  for (int k = 0; k < Dim; ++k) volume *= element.side;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0; k < Dim; ++k) dofs[c * Dim + k] = phi[element.nodes[c]][k];
  const auto b = bernstein_determinant<Dim>(dofs.data());
  const double bound = *std::min_element(b.begin(), b.end());
  // The coefficients at the cell's corners are the determinant's values there.
  double smallest = std::numeric_limits<double>::infinity();
  constexpr int n = n_bernstein<Dim>;
  for (int i = 0; i < n_bernstein_total<Dim>; ++i) {
    bool corner = true;
    for (int rest = i, k = 0; k < Dim; ++k, rest /= n) corner = corner && (rest % n == 0 || rest % n == n - 1);
    if (corner) smallest = std::min(smallest, b[i]);
  }
  return {smallest / volume, bound / volume};
}

template <int Dim>
FoldReport find_folds(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi) {
  struct Part : FoldReport {
    Part& operator+=(const Part& o) {
      min_determinant = std::min(min_determinant, o.min_determinant);
      lower_bound = std::min(lower_bound, o.lower_bound);
      n_folded_cells += o.n_folded_cells;
      n_uncertified_cells += o.n_uncertified_cells;
      folded_volume += o.folded_volume;
      return *this;
    }
  };
  Part none;
  none.min_determinant = none.lower_bound = std::numeric_limits<double>::infinity();
  return parallel_sum(elements.size(), 1024, none, [&](const Chunk& chunk) {
    Part part = none;
    for (std::size_t e = chunk.begin; e < chunk.end; ++e) {
      const auto [smallest, bound] = determinant_bounds<Dim>(elements[e], phi);
      part.min_determinant = std::min(part.min_determinant, smallest);
      part.lower_bound = std::min(part.lower_bound, bound);
      part.n_uncertified_cells += bound <= 0;
      if (smallest <= 0) {
        ++part.n_folded_cells;
        part.folded_volume += std::pow(elements[e].side, Dim);
      }
    }
    return part;
  });
}

template std::pair<double, double> determinant_bounds<2>(const Element<2>&, std::span<const Vec<2>>);
template std::pair<double, double> determinant_bounds<3>(const Element<3>&, std::span<const Vec<3>>);
template FoldReport find_folds<2>(std::span<const Element<2>>, std::span<const Vec<2>>);
template FoldReport find_folds<3>(std::span<const Element<3>>, std::span<const Vec<3>>);

}  // namespace shellmatch
