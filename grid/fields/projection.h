#pragma once
/// \file
/// Normals at the nodes from distances at the nodes.

#include "grid/octree/octree.h"
#include "grid/options.h"

#include <vector>

namespace shellmatch {

/// L2 projection of the gradient of a conforming nodal field d onto the vector fields of the same finite
/// element space (paper, section 5): C^T M C g = C^T integral grad d, with the consistent or the lumped mass
/// matrix. The lumped one amounts to a weighted average. Exact where d is linear. Hanging nodes get the mean
/// of their parents.
template <int Dim>
std::vector<Vec<Dim>> project_gradient(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                                       MassKind mass);

/// Scales every vector to unit length. Vectors shorter than `smallest` have no reliable direction (as
/// gradients of a distance on its medial axis) and are set to zero.
template <int Dim>
void normalise(std::vector<Vec<Dim>>& nodal, double smallest = 1e-6);

/// Normals at all nodes: project_gradient(), normalised at the free nodes. Normals at hanging nodes are the
/// means of their parents, so that the field is continuous, and may be shorter than 1.
template <int Dim>
std::vector<Vec<Dim>> nodal_normals(const Octree<Dim>& grid, const std::vector<double>& nodal_distance, MassKind mass);

}  // namespace shellmatch
