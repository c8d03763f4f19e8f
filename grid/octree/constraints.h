#pragma once
/// \file
/// Hanging nodes as constraints: a finite element function is given by its free values, x = C x_free, and
/// derivatives go back by the transpose C^T. Rows of C: 1 for a free node, 1/2 or 1/4 for each parent of a
/// hanging one. Fields are doubles, `n_components` per node (see components_of). All loops are parallel and
/// give the same bits whatever the number of threads.

#include "grid/octree/nodal_values.h"
#include "grid/octree/octree.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Gives every hanging node the mean of its parents: nodal = C nodal_free, in place.
/// \pre nodal.size() == grid.n_nodes() * n_components
template <int Dim>
void distribute(const Octree<Dim>& grid, std::span<double> nodal, int n_components = 1);

/// The same for a field of scalars, vectors or component arrays.
template <int Dim, class T>
void distribute(const Octree<Dim>& grid, std::vector<T>& nodal) {
  distribute(grid, components_of(nodal), static_cast<int>(sizeof(T) / sizeof(double)));
}

/// C and C^T of one grid, with C transposed beforehand so that C^T needs no write that two threads share.
/// Refers to the grid, which must live on and must not be refined meanwhile.
template <int Dim>
class Constraints {
 public:
  explicit Constraints(const Octree<Dim>& grid);

  const Octree<Dim>& grid() const { return *grid_; }
  std::size_t n_free() const { return grid_->free_nodes().size(); }

  /// nodal = C free. \pre sizes n_nodes * n_components and n_free() * n_components
  void expand(std::span<const double> free, std::span<double> nodal, int n_components = 1) const;

  /// free = the values of `nodal` at the free nodes; expand() undoes it for conforming fields.
  void pick(std::span<const double> nodal, std::span<double> free, int n_components = 1) const;

  /// free = C^T nodal.
  void condense(std::span<const double> nodal, std::span<double> free, int n_components = 1) const;

  /// The same in place: adds what hanging nodes carry to their parents and clears it.
  void condense(std::span<double> nodal, int n_components = 1) const;

 private:
  struct Entry {
    Index hanging;
    double weight;
  };
  const Octree<Dim>* grid_;
  std::vector<std::size_t> first_;  ///< entries of free node i: [first_[i], first_[i + 1])
  std::vector<Entry> entries_;
};

}  // namespace shellmatch
