#pragma once
/// \file
/// Constraints of hanging nodes. A finite element function is determined by its values at the free nodes, x =
/// C x_free, and derivatives with respect to x_free are obtained with the transpose C^T. The entries of C are
/// 1 for a free node, and 1/2 or 1/4 for each parent of a hanging node. Fields are doubles, `n_components`
/// per node (see components_of). All loops are parallel, and the result does not depend on the number of
/// threads.

#include "grid/octree/nodal_values.h"
#include "grid/octree/octree.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Sets every hanging node to the mean of its parents: nodal = C nodal_free, in place.
/// \pre nodal.size() == grid.n_nodes() * n_components
template <int Dim>
void distribute(const Octree<Dim>& grid, std::span<double> nodal, int n_components = 1);

/// The same for a field of scalars, vectors or component arrays.
template <int Dim, class T>
void distribute(const Octree<Dim>& grid, std::vector<T>& nodal) {
  distribute(grid, components_of(nodal), static_cast<int>(sizeof(T) / sizeof(double)));
}

/// C and C^T of one grid. The transpose is stored by rows, so that each entry of a product with C^T is
/// computed by one thread. Keeps a reference to the grid, which must outlive this object and must not be
/// refined.
template <int Dim>
class Constraints {
 public:
  explicit Constraints(const Octree<Dim>& grid);

  const Octree<Dim>& grid() const { return *grid_; }
  std::size_t n_free() const { return grid_->free_nodes().size(); }

  /// nodal = C free. \pre sizes n_nodes * n_components and n_free() * n_components
  void expand(std::span<const double> free, std::span<double> nodal, int n_components = 1) const;

  /// free = the values of `nodal` at the free nodes. For conforming fields expand() is the inverse.
  void pick(std::span<const double> nodal, std::span<double> free, int n_components = 1) const;

  /// free = C^T nodal.
  void condense(std::span<const double> nodal, std::span<double> free, int n_components = 1) const;

  /// The same in place: adds the weighted values of hanging nodes to their parents and sets hanging nodes to
  /// 0.
  void condense(std::span<double> nodal, int n_components = 1) const;

 private:
  struct Entry {
    Index hanging;
    double weight;
  };
  const Octree<Dim>* grid_;
  std::vector<std::size_t> first_;  ///< the entries of free node i are [first_[i], first_[i + 1])
  std::vector<Entry> entries_;
};

}  // namespace shellmatch
