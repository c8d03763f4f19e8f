#pragma once
/// \file
/// Which components of two surfaces correspond to each other.

#include "alignment/options.h"
#include "geometry/surface/surface.h"

#include <array>
#include <cstddef>

namespace shellmatch {

/// Ranks by area (prepare_surface()) of the components of two surfaces that correspond: the largest ones, unless of
/// other large ones two are far more alike, as where a scan has a floor. Alike are components whose Laplacians have
/// nearly the same least eigenvalues at area 1, whatever their size and pose: M. Reuter, F.-E. Wolter and N. Peinecke,
/// 'Laplace-Beltrami spectra as "Shape-DNA" of surfaces and solids', Computer-Aided Design 38, 2006.
/// \throws InputError if no facet of a surface has an area
std::array<std::size_t, 2> alike_components(const Surface<3>& reference, const Surface<3>& template_surface,
                                            const AlignmentOptions& options);

}  // namespace shellmatch
