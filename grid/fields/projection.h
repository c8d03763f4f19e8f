#pragma once
/// \file
/// Nodal normals from a nodal distance.

#include "grid/octree/octree.h"
#include "grid/options.h"

#include <vector>

namespace shellmatch {

/// L2 projection of the finite element gradient of a conforming nodal field d onto the vector fields of the
/// same space (paper, section 5): C^T M C g = C^T integral grad d, solved with the consistent mass matrix or
/// with the lumped one, which only averages. Exact where d is linear. Hanging nodes get the mean of their
/// parents.
template <int Dim>
std::vector<Vec<Dim>> project_gradient(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                                       MassKind mass);

/// Scales every vector to unit length. One shorter than `smallest` points nowhere (a distance has such points
/// on its medial axis) and becomes zero.
template <int Dim>
void normalise(std::vector<Vec<Dim>>& nodal, double smallest = 1e-6);

/// Unit normals at all nodes: project_gradient, normalised at the free nodes. Hanging nodes keep the mean of
/// their parents, as the field has to be continuous, and may be shorter than 1.
template <int Dim>
std::vector<Vec<Dim>> nodal_normals(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                                    MassKind mass);

}  // namespace shellmatch
