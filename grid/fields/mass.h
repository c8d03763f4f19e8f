#pragma once
/// \file
/// Mass matrices of the free nodes: the L2 product of multilinear functions.

#include "grid/octree/constraints.h"
#include "grid/octree/nodal_incidence.h"
#include "grid/octree/octree.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Diagonal of the lumped mass matrix at the free nodes, in the order of grid.free_nodes(): the row sums of
/// C^T M C. They are C^T applied to the integrals of the shape functions, because each row of C sums to 1.
/// All are positive, and their sum is 1, the volume of the domain.
template <int Dim>
std::vector<double> lumped_mass(const Octree<Dim>& grid);

/// The consistent mass matrix C^T M C, applied without assembling it. Keeps a reference to the grid, which
/// must outlive this object and must not be refined.
template <int Dim>
class MassOperator {
 public:
  explicit MassOperator(const Octree<Dim>& grid);

  const Constraints<Dim>& constraints() const { return constraints_; }

  /// y = C^T M C x. \pre sizes n_free * n_components
  void apply(std::span<const double> x, std::span<double> y, int n_components = 1) const;

  /// Solves C^T M C x = b by conjugate gradients, preconditioned by the lumped mass, with the given x as
  /// initial guess, until the residual is below `tolerance` times b in the norm of the inverse lumped mass.
  /// The components are solved as one system, with common step lengths. Returns the number of iterations.
  int solve(std::span<const double> b, std::span<double> x, int n_components, double tolerance) const;

  std::span<const double> lumped() const { return lumped_; }

 private:
  struct Scratch {
    std::vector<double> nodal, elements;
  };
  void apply(std::span<const double> x, std::span<double> y, int n_components, Scratch& scratch) const;
  /// Assembles element vectors, given leaf by leaf in the order of grid.leaves() and corner by corner, at the free
  /// nodes.
  void sum_elements(std::span<const double> elements, std::span<double> free, int n_components,
                    std::vector<double>& nodal) const;

  const Octree<Dim>* grid_;
  Constraints<Dim> constraints_;
  NodalIncidence<Dim> incidence_;
  std::vector<double> lumped_;
};

}  // namespace shellmatch
