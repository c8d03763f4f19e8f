#include "alignment/spectrum/alike_components.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

/// Mean of the logarithms of the ratios of the least eigenvalues.
double spectral_distance(const SpectralShape& a, const SpectralShape& b) {
  constexpr Eigen::Index most = 20;
  const Eigen::Index n = std::min({a.values.size(), b.values.size(), most + 1});
  double sum = 0;
  for (Eigen::Index k = 1; k < n; ++k) sum += std::abs(std::log(a.values[k] / b.values[k]));
  return sum / static_cast<double>(n - 1);
}

}  // namespace

std::array<SearchedComponent, 2> alike_components(const Surface<3>& reference, const Surface<3>& template_surface,
                                                  const AlignmentOptions& options) {
  // Poses and individuals change eigenvalues less than shapes do.
  constexpr double far_more_alike = 0.5;
  std::array<std::vector<SearchedComponent>, 2> all;
  for_both([&](int s) {
    const Surface<3>& surface = s == 0 ? reference : template_surface;
    for (std::size_t rank = 0, n = n_large_components(surface); rank < n; ++rank) {
      PreparedSurface prepared = prepare_surface(surface, options, rank);
      auto spectrum = std::make_shared<const SpectralShape>(make_spectral_shape(prepared.surface, options));
      all[static_cast<std::size_t>(s)].push_back({std::move(prepared), std::move(spectrum)});
    }
  });
  std::array<std::size_t, 2> chosen{0, 0};
  double least = 0;
  if (all[0].size() > 1 || all[1].size() > 1)
    least = far_more_alike * spectral_distance(*all[0][0].spectrum, *all[1][0].spectrum);
  for (std::size_t i = 0; i < all[0].size(); ++i)
    for (std::size_t j = 0; j < all[1].size(); ++j)
      if (const double distance = spectral_distance(*all[0][i].spectrum, *all[1][j].spectrum); distance < least) {
        least = distance;
        chosen = {i, j};
      }
  return {std::move(all[0][chosen[0]]), std::move(all[1][chosen[1]])};
}

}  // namespace shellmatch
