#pragma once
/// \file
/// Which components of two surfaces correspond to each other.

#include "alignment/spectrum/prepared_surface.h"
#include "alignment/spectrum/spectral_shape.h"

#include <array>
#include <memory>

namespace shellmatch {

struct SearchedComponent {
  PreparedSurface prepared;
  std::shared_ptr<const SpectralShape> spectrum;  ///< of `prepared.surface`
};

/// The largest component of either surface, unless of other large ones two are far more alike: a scan may have a floor.
/// Alike are components whose Laplacians have nearly the same least eigenvalues at area 1, whatever their size and
/// pose: M. Reuter, F.-E. Wolter and N. Peinecke, 'Laplace-Beltrami spectra as "Shape-DNA" of surfaces and solids',
/// Computer-Aided Design 38, 2006.
/// \throws InputError if no facet of a surface has an area
std::array<SearchedComponent, 2> alike_components(const Surface<3>& reference, const Surface<3>& template_surface,
                                                  const AlignmentOptions& options);

}  // namespace shellmatch
