#pragma once
/// \file
/// Eight elements in the lanes of a pack: their nodal positions and their gradients.

#include "energies/autodiff/pack.h"
#include "energies/autodiff/transpose.h"
#include "energies/elements/shape_table.h"

#include <algorithm>
#include <array>
#include <span>

namespace shellmatch {

/// Element-local degree of freedom c * Dim + k is component k at corner c.
template <int Dim>
struct ElementBatch {
  using Pack = autodiff::Pack;
  static constexpr int n_lanes = autodiff::pack_size;
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  std::array<Pack, n_dofs> u;         ///< deformed positions of the nodes, by degree of freedom
  std::array<Pack, n_dofs> gradient;  ///< derivative of the energy by u
  Pack side, inverse_side;            ///< of the elements

  /// Reads the positions phi of the nodes; element(lane) is the index of each lane's element.
  template <class ElementOf>
  void load(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, ElementOf&& element) {
    for (int lane = 0; lane < n_lanes; ++lane) {
      const Element<Dim>& e = elements[element(lane)];
      side[lane] = e.side;
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int k = 0; k < Dim; ++k) u[c * Dim + k][lane] = phi[e.nodes[c]][k];
    }
    inverse_side = 1.0 / side;
  }

  /// Prefetches the positions that load() with the same arguments reads.
  template <class ElementOf>
  static void prefetch(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, ElementOf&& element) {
    for (int lane = 0; lane < n_lanes; ++lane)
      for (const Index node : elements[element(lane)].nodes) __builtin_prefetch(&phi[node]);
  }

  /// Loads elements [first, min(first + 8, elements.size())) and returns their number n. Lanes from n on repeat the
  /// last element. \pre first < elements.size()
  std::size_t load_run(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, std::size_t first) {
    const std::size_t n = std::min<std::size_t>(n_lanes, elements.size() - first);
    load(elements, phi, [&](int lane) { return first + std::min(static_cast<std::size_t>(lane), n - 1); });
    return n;
  }

  void clear_gradient() { gradient.fill(Pack{}); }

  /// Writes the gradients of the first n lanes, lane after lane: n * n_dofs numbers.
  void store_gradients(std::size_t n, double* to) const {
    const auto lanes = by_lane();
    for (std::size_t lane = 0; lane < n; ++lane)
      for (int i = 0; i < n_dofs; ++i) *to++ = lanes[lane][i / n_lanes][i % n_lanes];
  }
  /// Adds the gradient of each of the first n lanes to the n_dofs numbers at to(lane).
  template <class To>
  void add_gradients(int n, To&& to) const {
    const auto lanes = by_lane();
    for (int lane = 0; lane < n; ++lane) {
      double* out = to(lane);
      for (int i = 0; i < n_dofs; ++i) out[i] += lanes[lane][i / n_lanes][i % n_lanes];
    }
  }

  /// Largest magnitude of an entry of Dphi on the element. It is attained at a corner, since each entry is a convex
  /// combination of difference quotients along edges.
  Pack largest_entry() const {
    Pack largest{};
    for (int k = 0; k < Dim; ++k)
      for (int c = 0; c < n_corners<Dim>; ++c) {
        if ((c >> k) & 1) continue;
        for (int a = 0; a < Dim; ++a) {
          const Pack x = u[(c | 1 << k) * Dim + a] - u[c * Dim + a];
          largest = autodiff::max_of(largest, autodiff::max_of(x, -x));
        }
      }
    return largest * inverse_side;
  }

 private:
  static_assert(n_dofs % n_lanes == 0);
  /// The gradients, transposed in registers: by lane, then by degree of freedom.
  std::array<std::array<Pack, n_dofs / n_lanes>, n_lanes> by_lane() const {
    std::array<std::array<Pack, n_dofs / n_lanes>, n_lanes> lanes;
    for (int i = 0; i < n_dofs / n_lanes; ++i) {
      std::array<Pack, n_lanes> rows;
      std::copy_n(gradient.begin() + i * n_lanes, n_lanes, rows.begin());
      autodiff::transpose(rows);
      for (int lane = 0; lane < n_lanes; ++lane) lanes[lane][i] = rows[lane];
    }
    return lanes;
  }
};

}  // namespace shellmatch
