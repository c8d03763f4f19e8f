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
  std::size_t element;                   ///< of Unknowns::elements()
  std::array<double, n_corners<Dim>> n;  ///< shape functions at p, by corner
  Vec<Dim> y, normal;
  double weight;
};

/// A pair that rests within its tolerance at phi, and which a step carries beyond it: its part of the model of a step v
/// of phi(p) is w rho' |B (phi(p) + v - y) - b|^2 with the point b within the tolerance that is nearest to the step's
/// end, and the loss's weight there.
template <int Dim>
struct ActivatedPair {
  std::size_t pair;    ///< of PairTerm::pairs_of() all elements
  Mat<Dim> stiffness;  ///< second derivative by v: 2 w rho' B^T B
  Vec<Dim> pull;       ///< derivative by v at 0: 2 w rho' (B (phi(p) - y) - b), which points away from b
};

template <int Dim>
class PairTerm {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  PairTerm() = default;  ///< no pairs
  /// Locates the points in the leaves of the grid, which is not referred to afterwards. Points outside of the unit
  /// domain are projected onto it. \pre positive weights and scale
  PairTerm(const Octree<Dim>& grid, const PointPairs<Dim>& pairs);

  std::size_t size() const { return pairs_.size(); }
  RobustLoss loss() const { return loss_; }
  double scale() const { return scale_; }
  double tolerance() const { return tolerance_; }
  /// Those of the elements [begin, end), ascending by element, in the given order within one.
  std::span<const LocatedPair<Dim>> pairs_of(std::size_t begin, std::size_t end) const;

  /// The term's weighted value on the elements [begin, end). Adds its derivatives by the positions of their corners to
  /// `gradients`, element after element from `begin`, if not null.
  double add(std::size_t begin, std::size_t end, std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi,
             double weight, double* gradients) const;

  /// Calls body(pair, k) for each pair on these elements, except those within a positive tolerance. k = 2 w rho' B^T B
  /// is its Gauss-Newton block by phi(p), with the nearest point within the tolerance held fixed; w is `weight` times
  /// the pair's own.
  void for_each_model(std::size_t begin, std::size_t end, std::span<const Element<Dim>> elements,
                      std::span<const Vec<Dim>> phi, double weight, auto&& body) const {
    for (const LocatedPair<Dim>& pair : pairs_of(begin, end)) {
      const Vec<Dim> r = residual(pair, elements[pair.element], phi);
      if (tolerance_ > 0 && r.isZero(0)) continue;
      body(pair, stiffness(pair, weight, r));
    }
  }

  /// The pairs within the tolerance at phi that the step from phi, by nodes, carries beyond it; ascending.
  std::vector<ActivatedPair<Dim>> activated(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi,
                                            std::span<const Vec<Dim>> step, double weight) const;

  /// The term's weighted value on one element, from the positions of its corners, over any scalar: the functor with
  /// which derivative checks compare add().
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
  // The nodal field at p.
  static Vec<Dim> at_p(const LocatedPair<Dim>& pair, const Element<Dim>& element, std::span<const Vec<Dim>> nodal) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int c = 0; c < n_corners<Dim>; ++c) sum += pair.n[c] * nodal[element.nodes[c]];
    return sum;
  }
  // B^T B x.
  static Vec<Dim> counted(const LocatedPair<Dim>& pair, const Vec<Dim>& x) {
    return pair.normal.isZero(0) ? x : Vec<Dim>(pair.normal.dot(x) * pair.normal);
  }
  Vec<Dim> beyond_tolerance(const Vec<Dim>& r) const {
    if (tolerance_ == 0) return r;
    const double length = r.norm();
    return length > tolerance_ ? Vec<Dim>((1 - tolerance_ / length) * r) : Vec<Dim>(Vec<Dim>::Zero());
  }
  // B^T B (phi(p) - y), shortened by the tolerance.
  Vec<Dim> residual(const LocatedPair<Dim>& pair, const Element<Dim>& element, std::span<const Vec<Dim>> phi) const {
    return beyond_tolerance(counted(pair, at_p(pair, element, phi) - pair.y));
  }
  // 2 w rho' B^T B, with the residual's rho'.
  Mat<Dim> stiffness(const LocatedPair<Dim>& pair, double weight, const Vec<Dim>& residual) const {
    const double factor = 2 * weight * pair.weight * robust_weight(loss_, scale_, residual.squaredNorm());
    return pair.normal.isZero(0) ? Mat<Dim>(factor * Mat<Dim>::Identity())
                                 : Mat<Dim>(factor * pair.normal * pair.normal.transpose());
  }

  std::vector<LocatedPair<Dim>> pairs_;  ///< ascending by element
  RobustLoss loss_ = RobustLoss::trivial;
  double scale_ = 1, tolerance_ = 0;
};

extern template class PairTerm<2>;
extern template class PairTerm<3>;

}  // namespace shellmatch
