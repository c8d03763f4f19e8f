#pragma once
/// \file
/// The fields that deformation.vtu shows besides the map.

#include "grid/fits/curvature.h"
#include "matching/experiment/options.h"
#include "matching/map_file/deformation_file.h"

#include <vector>

namespace shellmatch {

/// d1, d2, n1, n2 and the roots of the classified shape operators at the nodes, or what the options took in their place.
template <int Dim>
std::vector<NodalField> nodal_fields(const CoefficientFields<Dim>& reference, const CoefficientFields<Dim>& target,
                                     const ExperimentOptions& options);

/// For each leaf: is it in the band, and the lower bound of det Dphi.
template <int Dim>
std::vector<CellField> cell_fields(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                   const std::vector<double>& distance1, double sigma);

}  // namespace shellmatch
