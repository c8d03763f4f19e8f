#pragma once
/// \file
/// Elements and unknowns of a grid as the energies use them, and shape functions at quadrature points.

#include "energies/elements/boundary_condition.h"
#include "grid/octree/octree.h"
#include "grid/fields/quadrature.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

/// Multilinear shape functions and their derivatives at the points of a tensor Gauss rule on the unit cell.
template <int Dim>
struct ShapeTable {
  struct Point {
    double weight;
    Vec<Dim> xi;
    std::array<double, n_corners<Dim>> n;
    std::array<std::array<double, Dim>, n_corners<Dim>> dn;  ///< by the unit cell's coordinates
  };
  int points_per_direction;
  std::vector<Point> points;  ///< the first direction runs fastest
  explicit ShapeTable(int points_per_direction);
};

/// A leaf as an element: its corners and its side.
template <int Dim>
struct Element {
  std::array<Index, n_corners<Dim>> nodes;
  double side;
  Vec<Dim> corner = Vec<Dim>::Zero();  ///< position of the lower one
};

/// The unknowns of a grid: Dim components for each node that neither hangs nor is fixed by the boundary
/// condition. Unknown Dim*i + k is component k of node nodes()[i].
template <int Dim>
class Unknowns {
 public:
  Unknowns(const Octree<Dim>& grid, BoundaryCondition boundary);

  std::size_t size() const { return nodes_.size() * Dim; }
  /// In the order in which the elements meet them, through hanging nodes too.
  std::span<const Index> nodes() const { return nodes_; }
  std::span<const Element<Dim>> elements() const { return elements_; }  ///< in the order of grid.leaves()

  /// Where unknown node i counts: at a corner of an element, itself or through a hanging node.
  struct Place {
    Index element_corner;  ///< element number times corners, plus corner
    float weight;          ///< 1, or 1/2, 1/4 through a hanging node: exact in float
  };
  std::span<const Place> places_of(std::size_t i) const {
    return {places_.data() + first_[i], first_[i + 1] - first_[i]};
  }

  /// The unknown nodes that carry a node of the grid: itself, the parents of a hanging one, none of a fixed
  /// one.
  struct Carrier {
    Index unknown;
    float weight;
  };
  std::span<const Carrier> carriers_of(Index node) const {
    return {carriers_.data() + first_carrier_[node], first_carrier_[node + 1] - first_carrier_[node]};
  }

  /// Writes x into the nodal field and gives hanging nodes the mean of their parents; fixed nodes stay.
  void expand(std::span<const double> x, std::vector<Vec<Dim>>& nodal) const;

  /// The unknowns' values of a nodal field.
  void restrict_to(const std::vector<Vec<Dim>>& nodal, std::span<double> x) const;

 private:
  const Octree<Dim>* grid_;
  std::vector<Index> nodes_;
  std::vector<Element<Dim>> elements_;
  std::vector<std::size_t> first_;  ///< places of unknown node i: [first_[i], first_[i + 1])
  std::vector<Place> places_;
  std::vector<std::size_t> first_carrier_;  ///< the same by node of the grid
  std::vector<Carrier> carriers_;
};

}  // namespace shellmatch
