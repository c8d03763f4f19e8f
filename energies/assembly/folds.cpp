#include "energies/assembly/folds.h"

#include "base/parallel.h"
#include "energies/elements/element_batch.h"
#include "energies/densities/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

template <int Dim>
std::vector<DeterminantBounds> determinant_bounds(std::span<const Element<Dim>> elements,
                                                  std::span<const Vec<Dim>> phi) {
  using autodiff::Pack;
  using autodiff::pack_size;
  std::vector<DeterminantBounds> all(elements.size());
  parallel_chunks(n_chunks(elements.size(), pack_size), 64, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const std::size_t begin = b * pack_size, n = batch.load_run(elements, phi, begin);
      const auto coefficients = bernstein_determinant<Dim>(batch.u.data());
      Pack least = coefficients[0], at_corners = coefficients[0], sum = coefficients[0];
      for (int i = 1; i < n_bernstein_total<Dim>; ++i) {
        least = least < coefficients[i] ? least : coefficients[i];
        sum += coefficients[i];
        // The Bernstein coefficients at the cell's corners are the determinant's values there.
        constexpr int last = n_bernstein<Dim> - 1;
        bool corner = true;
        for (int rest = i, k = 0; k < Dim; ++k, rest /= last + 1) corner = corner && rest % (last + 1) % last == 0;
        if (corner) at_corners = at_corners < coefficients[i] ? at_corners : coefficients[i];
      }
      for (int k = 0; k < Dim; ++k) {
        least *= batch.inverse_side;
        at_corners *= batch.inverse_side;
      }
      for (std::size_t l = 0; l < n; ++l) {
        const int lane = static_cast<int>(l);
        // Comparisons lose NaN, sums do not.
        all[begin + l] = std::isnan(sum[lane]) ? DeterminantBounds{sum[lane], sum[lane]}
                                               : DeterminantBounds{at_corners[lane], least[lane]};
      }
    }
  });
  return all;
}

template <int Dim>
FoldReport find_folds(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi) {
  FoldReport report;
  report.min_determinant = report.lower_bound = std::numeric_limits<double>::infinity();
  const auto bounds = determinant_bounds<Dim>(elements, phi);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto [smallest, bound] = bounds[e];
    report.min_determinant = std::min(report.min_determinant, smallest);
    report.lower_bound = std::min(report.lower_bound, bound);
    report.n_uncertified_cells += !(bound > 0);
    if (!(smallest > 0)) {
      ++report.n_folded_cells;
      report.folded_volume += std::pow(elements[e].side, Dim);
    }
  }
  return report;
}

SHELLMATCH_2D_3D(determinant_bounds);
SHELLMATCH_2D_3D(find_folds);

}  // namespace shellmatch
