#pragma once
/// \file
/// The additional fields of deformation.vtu.

#include "grid/fits/curvature.h"
#include "matching/experiment/options.h"
#include "matching/map_file/deformation_file.h"

#include <vector>

namespace shellmatch {

/// At the nodes d1, d2, n1, n2 and the roots of the classified shape operators, or the coefficients that replace these.
template <int Dim>
std::vector<NodalField> nodal_fields(const CoefficientFields<Dim>& reference, const CoefficientFields<Dim>& target,
                                     const ExperimentOptions& options);

/// For each leaf whether it is in the band, and the lower bound of det Dphi.
template <int Dim>
std::vector<CellField> cell_fields(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                   const std::vector<double>& distance1, double sigma);

}  // namespace shellmatch
