#pragma once
/// \file
/// Symmetric matrices of elements, one block of Dim x Dim entries for each pair of corners.

#include "grid/octree/octree.h"

#include <array>
#include <cstddef>
#include <memory>

namespace shellmatch {

template <int Dim>
class ElementMatrices {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  static constexpr int block_size = Dim * Dim;
  static constexpr int n_packed = n_dofs * (n_dofs + 1) / 2;
  /// Blocks (c, d) with c <= d, row after row; by columns within a block. And some more, so that the last
  /// block can be read as a whole register.
  static constexpr int n_entries = n_corners<Dim> * (n_corners<Dim> + 1) / 2 * block_size + 16 - block_size;
  /// Single precision is ample for a model that is solved to a tenth.
  using Matrix = std::array<float, n_entries>;

  /// Where block (c, d) begins, c <= d.
  static constexpr int block(int c, int d) {
    return (c * n_corners<Dim> - c * (c - 1) / 2 + (d - c)) * block_size;
  }
  /// Where entry (i, j) stands, i <= j; i = c * Dim + k is component k at corner c.
  static constexpr int entry(int i, int j) { return block(i / Dim, j / Dim) + (j % Dim) * Dim + i % Dim; }

  /// Room for so many; what it holds is of no meaning yet.
  void resize(std::size_t n_elements) {
    if (n_elements > room_) {
      matrices_ = std::make_unique_for_overwrite<Matrix[]>(n_elements);
      room_ = n_elements;
    }
    size_ = n_elements;
  }
  std::size_t size() const { return size_; }
  Matrix& operator[](std::size_t e) { return matrices_[e]; }
  const Matrix& operator[](std::size_t e) const { return matrices_[e]; }

  /// Adds to all entries (i, j), i <= j, of element e: `x` row after row.
  void add(std::size_t e, const std::array<float, n_packed>& x) {
    Matrix& to = matrices_[e];
    for (int at = 0; at < n_packed; ++at) to[places_[at]] += x[at];
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int k = 0; k < Dim; ++k)
        for (int l = k + 1; l < Dim; ++l) to[block(c, c) + k * Dim + l] = to[block(c, c) + l * Dim + k];
  }

  /// Adds x to entry (i, j), i <= j, of element e, and to its mirror image within a block on the diagonal.
  void add(std::size_t e, int i, int j, float x) {
    matrices_[e][entry(i, j)] += x;
    if (i != j && i / Dim == j / Dim) matrices_[e][entry(j, i)] += x;
  }
  void set(std::size_t e, int i, int j, float x) {
    matrices_[e][entry(i, j)] = x;
    if (i / Dim == j / Dim) matrices_[e][entry(j, i)] = x;
  }

  float trace(std::size_t e) const {
    float sum = 0;
    for (int i = 0; i < n_dofs; ++i) sum += matrices_[e][entry(i, i)];
    return sum;
  }

 private:
  static constexpr auto places_ = [] {
    std::array<int, n_packed> places{};
    int at = 0;
    for (int i = 0; i < n_dofs; ++i)
      for (int j = i; j < n_dofs; ++j) places[at++] = entry(i, j);
    return places;
  }();
  std::unique_ptr<Matrix[]> matrices_;
  std::size_t size_ = 0, room_ = 0;
};

}  // namespace shellmatch
