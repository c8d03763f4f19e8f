#pragma once
/// \file
/// The least squares fit of grid/fits/local_fit.h on uniform parts of the grid. There the neighbourhood is a
/// ball of the lattice, and second derivatives are the same linear combination of values at every node.

#include "grid/octree/nodal_values.h"
#include "grid/octree/octree.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class LatticeFit {
 public:
  /// For neighbourhoods of at least `n_others` nodes besides the centre; `exponent` is that of the weights
  /// (CoefficientOptions::fit_weight). `grid` must outlive this object.
  LatticeFit(const Octree<Dim>& grid, std::size_t n_others, double exponent);

  /// True if the ball spans at most two cells along each axis and determines a quadratic.
  bool is_possible() const { return !terms_.empty(); }

  /// If all cells that touch the ball around a node are leaves of one size, fills `neighbours` with the nodes
  /// of the ball and returns the side of the cells; else returns 0.
  double find_neighbours(Index node, std::vector<Index>& neighbours) const;

  /// The field's second derivatives at `node`. \pre find_neighbours() returned this side for the node
  SymmetricComponents<Dim> hessian(std::span<const double> field, Index node, double side,
                                   std::span<const Index> neighbours) const;

 private:
  using Offset = std::array<int, Dim>;
  /// The leaves around a node by octant (bit k: above along axis k). The first is no_index unless all exist
  /// and have the same size.
  using Around = std::array<Index, n_corners<Dim>>;
  /// A node of the ball: at most two steps along each axis, the first of each to one of the next nodes.
  struct Term {
    std::size_t next = 0;  ///< among the next nodes
    Offset rest{};         ///< from there
    bool is_next = true;   ///< no rest
    SymmetricComponents<Dim> weight{};
  };
  /// The next nodes: those one step away along any axes, and the node itself; the first axis fastest.
  static constexpr std::size_t n_next = Dim == 2 ? 9 : 27;

  void choose_terms(std::size_t n_others, double exponent);
  /// \pre there are leaves around the node; the step is at most 1 along each axis
  Index neighbour(Index node, const Offset& step) const;

  const Octree<Dim>* grid_;
  std::vector<Around> around_;  ///< by node
  std::vector<Term> terms_;     ///< empty if the fit is not possible
  bool is_ball_wide_ = false;  ///< the leaves around the node do not cover it; with those around the next nodes they do
};

}  // namespace shellmatch
