#pragma once
/// \file
/// Symmetric element matrices: one block of Dim x Dim entries for each pair of corners.

#include "grid/octree/octree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace shellmatch {

/// The matrices of consecutive elements. Row and column i = c * Dim + k of a matrix is component k at corner c.
template <int Dim>
class ElementMatrices {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  static constexpr int block_size = Dim * Dim;
  /// Entries of the blocks (c, d) with c <= d, row after row, each stored by columns.
  static constexpr int n_block_entries = n_corners<Dim> * (n_corners<Dim> + 1) / 2 * block_size;
  /// With padding, so that the last block can be read as a whole register (WideBlock).
  static constexpr int n_entries = n_block_entries + 16 - block_size;
  /// Single precision suffices: Newton's equations are solved to a relative residual of about 0.1.
  using Matrix = std::array<float, n_entries>;

  /// Offset of block (c, d) in a matrix. \pre c <= d
  static constexpr int block(int c, int d) { return (c * n_corners<Dim> - c * (c - 1) / 2 + (d - c)) * block_size; }
  /// Offset of entry (i, j) in a matrix. \pre i <= j
  static constexpr int entry(int i, int j) { return block(i / Dim, j / Dim) + (j % Dim) * Dim + i % Dim; }

  /// Allocates memory for n_elements matrices where there is less, and leaves their entries uninitialised.
  void resize(std::size_t n_elements) {
    if (n_elements > capacity_) {
      matrices_ = std::make_unique_for_overwrite<Matrix[]>(n_elements);
      capacity_ = n_elements;
    }
    size_ = n_elements;
  }
  std::size_t size() const { return size_; }
  Matrix& operator[](std::size_t e) { return matrices_[e]; }
  const Matrix& operator[](std::size_t e) const { return matrices_[e]; }

  /// Assigns x, stored as the matrices are, to the matrix of element e.
  void set(std::size_t e, const std::array<float, n_block_entries>& x) {
    std::copy(x.begin(), x.end(), matrices_[e].begin());
  }
  /// Adds it.
  void add(std::size_t e, const std::array<float, n_block_entries>& x) {
    Matrix& to = matrices_[e];
    for (int i = 0; i < n_block_entries; ++i) to[i] += x[i];
  }

  /// Adds x to entry (i, j) of element e, and to entry (j, i) of a block on the diagonal, which is stored in full.
  /// \pre i <= j
  void add(std::size_t e, int i, int j, float x) {
    matrices_[e][entry(i, j)] += x;
    if (i != j && i / Dim == j / Dim) matrices_[e][entry(j, i)] += x;
  }
  float trace(std::size_t e) const {
    float sum = 0;
    for (int i = 0; i < n_dofs; ++i) sum += matrices_[e][entry(i, i)];
    return sum;
  }

 private:
  std::unique_ptr<Matrix[]> matrices_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace shellmatch
