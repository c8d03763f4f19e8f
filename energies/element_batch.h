#pragma once
/// \file
/// Eight elements at once: nodal positions in, shape functions applied, element gradients out.

#include "energies/autodiff/pack.h"
#include "energies/elements.h"

#include <algorithm>
#include <span>

namespace shellmatch {

template <int Dim>
struct ElementBatch {
  using Pack = autodiff::Pack;
  static constexpr int n_lanes = autodiff::pack_size;
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  std::array<Pack, n_dofs> u;         ///< nodal positions, corner after corner
  std::array<Pack, n_dofs> gradient;  ///< derivative by them
  Pack inverse_side;

  /// `element` gives the element of each lane.
  template <class ElementOf>
  void load(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, ElementOf&& element) {
    for (int lane = 0; lane < n_lanes; ++lane) {
      const Element<Dim>& e = elements[element(lane)];
      inverse_side[lane] = 1.0 / e.side;
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int k = 0; k < Dim; ++k) u[c * Dim + k][lane] = phi[e.nodes[c]][k];
    }
  }

  /// Asks for the positions that load() reads, early.
  template <class ElementOf>
  static void prefetch(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, ElementOf&& element) {
    for (int lane = 0; lane < n_lanes; ++lane)
      for (const Index node : elements[element(lane)].nodes) __builtin_prefetch(&phi[node]);
  }

  /// Elements [first, first + 8), or what there is of them; their number. Lanes that are left repeat the last.
  std::size_t load_run(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, std::size_t first) {
    const std::size_t n = std::min<std::size_t>(n_lanes, elements.size() - first);
    load(elements, phi, [&](int lane) { return first + std::min(static_cast<std::size_t>(lane), n - 1); });
    return n;
  }

  void clear_gradient() { gradient.fill(Pack{}); }

  /// Adds the gradients of the first n lanes to those of n elements that stand one after the other.
  void add_gradients(std::size_t n, double* to) const {
    for (std::size_t lane = 0; lane < n; ++lane, to += n_dofs)
      for (int i = 0; i < n_dofs; ++i) to[i] += gradient[i][lane];
  }

  /// Largest entry, in size, that Dphi has anywhere on the element: it is a mean of differences along edges.
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

  /// Dphi by rows at a quadrature point.
  void jacobian(const typename ShapeTable<Dim>::Point& q, Pack* dphi) const {
    std::array<Pack, Dim> y;
    evaluate(q, y, dphi);
  }

  /// The same and y = phi: linear along each axis, so one axis after the other is collapsed.
  void evaluate(const typename ShapeTable<Dim>::Point& q, std::array<Pack, Dim>& y, Pack* dphi) const {
    for (int k = 0; k < Dim; ++k) {
      std::array<Pack, n_corners<Dim>> v;
      for (int c = 0; c < n_corners<Dim>; ++c) v[c] = u[c * Dim + k];
      std::array<std::array<Pack, n_corners<Dim> / 2>, Dim> d;
      for (int axis = 0, n_left = n_corners<Dim> / 2; axis < Dim; ++axis, n_left /= 2)
        for (int i = 0; i < n_left; ++i) {
          for (int j = 0; j < axis; ++j) d[j][i] = d[j][2 * i] + q.xi[axis] * (d[j][2 * i + 1] - d[j][2 * i]);
          d[axis][i] = v[2 * i + 1] - v[2 * i];
          v[i] = v[2 * i] + q.xi[axis] * d[axis][i];
        }
      y[k] = v[0];
      for (int j = 0; j < Dim; ++j) dphi[k * Dim + j] = d[j][0] * inverse_side;
    }
  }

  /// Adds the transpose of jacobian().
  void add_jacobian_adjoint(const typename ShapeTable<Dim>::Point& q, const Pack* by_dphi) {
    add_adjoint(q, std::array<Pack, Dim>{}, by_dphi);
  }

  /// Adds the transpose of evaluate().
  void add_adjoint(const typename ShapeTable<Dim>::Point& q, const std::array<Pack, Dim>& by_y, const Pack* by_dphi) {
    for (int k = 0; k < Dim; ++k) {
      std::array<Pack, n_corners<Dim>> v;
      std::array<std::array<Pack, n_corners<Dim> / 2>, Dim> d;
      v[0] = by_y[k];
      for (int j = 0; j < Dim; ++j) d[j][0] = by_dphi[k * Dim + j] * inverse_side;
      for (int axis = Dim - 1, n_left = 1; axis >= 0; --axis, n_left *= 2)
        for (int i = n_left - 1; i >= 0; --i) {
          const Pack to_upper = q.xi[axis] * v[i] + d[axis][i];
          v[2 * i] = v[i] - to_upper;
          v[2 * i + 1] = to_upper;
          for (int j = 0; j < axis; ++j) {
            d[j][2 * i + 1] = q.xi[axis] * d[j][i];
            d[j][2 * i] = d[j][i] - d[j][2 * i + 1];
          }
        }
      for (int c = 0; c < n_corners<Dim>; ++c) gradient[c * Dim + k] += v[c];
    }
  }
};

/// By how much a Bernstein coefficient of det Dphi can change on an element where the entries of Dphi are at
/// most `largest` in size and change by at most `change`: a determinant is a sum of Dim! products.
template <int Dim>
autodiff::Pack determinant_change(autodiff::Pack largest, autodiff::Pack change) {
  const autodiff::Pack after = largest + change;
  if constexpr (Dim == 2)
    return 2.0 * (after * after - largest * largest);
  else
    return 6.0 * (after * after * after - largest * largest * largest);
}

/// Smallest Bernstein coefficient of det Dphi on each of the eight (energies/fold_barrier.h).
template <int Dim>
autodiff::Pack least_determinant(const ElementBatch<Dim>& batch);

}  // namespace shellmatch
