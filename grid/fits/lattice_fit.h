#pragma once
/// \file
/// The least squares of grid/fits/local_fit.h where the grid is uniform: there the neighbourhood is a ball of a
/// lattice, and second derivatives are the same combination of its values at every node.

#include "grid/octree/nodal_values.h"
#include "grid/octree/octree.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class LatticeFit {
 public:
  /// For neighbourhoods of at least `n_others` nodes beside the one in the middle, and the exponent of the
  /// weights as in CoefficientOptions. `grid` must outlive this object.
  LatticeFit(const Octree<Dim>& grid, std::size_t n_others, double exponent);

  /// Is the lattice's ball narrow enough, and does it determine a quadratic?
  bool is_possible() const { return !terms_.empty(); }

  /// Fills `neighbours`, room of the caller's, and returns the side of the cells, if all that touch the ball
  /// around a node are leaves of one size; else 0.
  double find_neighbours(Index node, std::vector<Index>& neighbours) const;

  /// The field's second derivatives at `node`. \pre find_neighbours() found them, for cells of this side
  SymmetricComponents<Dim> hessian(std::span<const double> field, Index node, double side,
                                   std::span<const Index> neighbours) const;

 private:
  using Offset = std::array<int, Dim>;
  /// The leaves around a node by octant (bit k: above along axis k), if they are all there and of one size;
  /// else the first is no_index.
  using Around = std::array<Index, n_corners<Dim>>;
  struct Term {
    Offset offset;  ///< in cells, at most 2 along each axis
    SymmetricComponents<Dim> weight;
  };

  void choose_terms(std::size_t n_others, double exponent);
  /// \pre there are leaves around the node; the step is at most 1 along each axis
  Index neighbour(Index node, const Offset& step) const;

  const Octree<Dim>* grid_;
  std::vector<Around> around_;      ///< by node
  std::vector<Term> terms_;         ///< none if it is not possible
  std::vector<Offset> next_nodes_;  ///< whose leaves, with those of the middle, are all that touch the ball
};

}  // namespace shellmatch
