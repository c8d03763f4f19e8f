#pragma once
/// \file
/// Point pairs as a term of the energy on one grid. A pair acts on the element that holds p like one more quadrature
/// point of it: through the element's gradient and matrix, in which hanging nodes are eliminated for all terms alike.

#include "energies/elements/unknowns.h"
#include "energies/pairs/point_pairs.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// A pair in its element.
template <int Dim>
struct LocatedPair {
  std::size_t element;                    ///< of Unknowns::elements()
  std::array<double, n_corners<Dim>> n;   ///< shape functions at p, by corner
  Vec<Dim> y, normal;
  double weight;
};

template <int Dim>
class PairTerm {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  PairTerm() = default;  ///< no pairs
  /// Locates the points in the leaves of the grid, which is not referred to afterwards. Points outside of the unit domain
  /// are projected onto it. \pre positive weights and scale
  PairTerm(const Octree<Dim>& grid, const PointPairs<Dim>& pairs);

  std::size_t size() const { return pairs_.size(); }
  /// Those of the elements [begin, end), ascending by element, in the given order within one.
  std::span<const LocatedPair<Dim>> pairs_of(std::size_t begin, std::size_t end) const;

  /// The term's weighted value on the elements [begin, end). Adds its derivatives by the positions of their corners to
  /// `gradients`, element after element from `begin`, if not null.
  double add(std::size_t begin, std::size_t end, std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi,
             double weight, double* gradients) const;

  /// Calls body(pair, k) for each pair on these elements, except those within a positive tolerance. k = 2 w rho' B^T B is its
  /// Gauss-Newton block by phi(p), with the nearest point within the tolerance held fixed; w is `weight` times the pair's own.
  template <class Body>
  void for_each_model(std::size_t begin, std::size_t end, std::span<const Element<Dim>> elements,
                      std::span<const Vec<Dim>> phi, double weight, Body&& body) const {
    for (const LocatedPair<Dim>& pair : pairs_of(begin, end)) {
      const bool in_plane = !pair.normal.isZero(0);
      const Vec<Dim> r = residual(pair, elements[pair.element], phi);
      if (tolerance_ > 0 && r.isZero(0)) continue;
      const double factor = 2 * weight * pair.weight * robust_weight(loss_, scale_, r.squaredNorm());
      const Mat<Dim> b = in_plane ? Mat<Dim>(pair.normal * pair.normal.transpose()) : Mat<Dim>::Identity();
      body(pair, Mat<Dim>(factor * b));
    }
  }

  /// The term's weighted value on one element, from the positions of its corners, over any scalar: the functor with which
  /// derivative checks compare add().
  template <class T>
  T element_value(std::size_t element, const T* dofs, double weight) const {
    T sum(0.0);
    for (const LocatedPair<Dim>& pair : pairs_of(element, element + 1)) {
      std::array<T, Dim> gap;
      for (int k = 0; k < Dim; ++k) {
        gap[k] = T(-pair.y[k]);
        for (int c = 0; c < n_corners<Dim>; ++c) gap[k] += pair.n[c] * dofs[c * Dim + k];
      }
      T square(0.0), along(0.0);
      for (int k = 0; k < Dim; ++k) {
        square += gap[k] * gap[k];
        along += pair.normal[k] * gap[k];
      }
      if (!pair.normal.isZero(0)) square = along * along;
      if (tolerance_ > 0) {
        using std::sqrt;
        if (!(square > tolerance_ * tolerance_)) continue;
        const T beyond = sqrt(square) - tolerance_;
        square = beyond * beyond;
      }
      sum += weight * pair.weight * robust_loss(loss_, scale_, square);
    }
    return sum;
  }

 private:
  // B^T B (phi(p) - y), shortened by the tolerance.
  Vec<Dim> residual(const LocatedPair<Dim>& pair, const Element<Dim>& element, std::span<const Vec<Dim>> phi) const {
    Vec<Dim> r = -pair.y;
    for (int c = 0; c < n_corners<Dim>; ++c) r += pair.n[c] * phi[element.nodes[c]];
    if (!pair.normal.isZero(0)) r = Vec<Dim>(pair.normal.dot(r) * pair.normal);
    if (tolerance_ == 0) return r;
    const double length = r.norm();
    return length > tolerance_ ? Vec<Dim>((1 - tolerance_ / length) * r) : Vec<Dim>(Vec<Dim>::Zero());
  }

  std::vector<LocatedPair<Dim>> pairs_;  ///< ascending by element
  RobustLoss loss_ = RobustLoss::trivial;
  double scale_ = 1, tolerance_ = 0;
};

extern template class PairTerm<2>;
extern template class PairTerm<3>;

}  // namespace shellmatch
