#include "alignment/spectrum/alike_components.h"

#include "alignment/spectrum/laplacian.h"
#include "alignment/spectrum/prepared_surface.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shellmatch {

namespace {

constexpr int n_eigenvalues = 20;

/// The least ones of a component but the first, times its area.
Eigen::VectorXd spectrum_of(const Surface<3>& component, const AlignmentOptions& options) {
  const SurfaceLaplacian laplacian = surface_laplacian(component, options.mollification);
  return laplacian.mass.sum() * least_eigenpairs(laplacian, n_eigenvalues + 1).values.tail(n_eigenvalues);
}

}  // namespace

std::array<std::size_t, 2> alike_components(const Surface<3>& reference, const Surface<3>& template_surface,
                                            const AlignmentOptions& options) {
  // Poses and individuals change eigenvalues less than shapes do.
  constexpr double far_more_alike = 0.5;
  const std::size_t n[2] = {n_large_components(reference), n_large_components(template_surface)};
  std::array<std::size_t, 2> chosen{0, 0};
  if (n[0] == 1 && n[1] == 1) return chosen;
  std::vector<Eigen::VectorXd> spectra[2];
  for_both([&](int s) {
    for (std::size_t rank = 0; rank < n[s]; ++rank)
      spectra[s].push_back(
          spectrum_of(prepare_surface(s == 0 ? reference : template_surface, options, rank).surface, options));
  });
  const auto distance = [&](std::size_t i, std::size_t j) {
    double sum = 0;
    for (int k = 0; k < n_eigenvalues; ++k) sum += std::abs(std::log(spectra[0][i][k] / spectra[1][j][k]));
    return sum;
  };
  double least = far_more_alike * distance(0, 0);
  for (std::size_t i = 0; i < n[0]; ++i)
    for (std::size_t j = 0; j < n[1]; ++j)
      if (distance(i, j) < least) {
        least = distance(i, j);
        chosen = {i, j};
      }
  return chosen;
}

}  // namespace shellmatch
