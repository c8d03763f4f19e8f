#pragma once
/// \file
/// A shape as the energies see it, at any point: signed distance d, normal n and root of the classified shape
/// operator. Of the template it is read at deformed positions: the one position where a coefficient depends on
/// phi.

#include "energies/autodiff/jet.h"
#include "energies/autodiff/pack.h"
#include "energies/fields/coefficients.h"
#include "grid/octree/octree.h"
#include "grid/fields/spline_space.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace shellmatch {

/// Nodal fields between the nodes, which copies of this object share: multilinear on each cell, or C1 as
/// quadratic splines. Positions outside the domain are projected onto it first (paper, section
/// 6); the derivative in a projected direction is zero.
template <int Dim>
class GeometryField {
 public:
  static constexpr int n_values = TargetPoint<Dim, double>::size;
  /// In the order of TargetPoint: d, n, root.
  using Values = std::array<double, n_values>;
  using Pack = autodiff::Pack;
  using Packs = std::array<Pack, n_values>;

  /// Multilinear, from the fields at the nodes, hanging ones included; keeps a copy. `grid` must outlive this
  /// object.
  GeometryField(const Octree<Dim>& grid, std::span<const double> distance, std::span<const Vec<Dim>> normal,
                std::span<const std::array<double, n_symmetric<Dim>>> root);

  /// The same as splines on `grid`, which is not needed afterwards. What is positive definite at the nodes
  /// stays so if `keep_definite`, at the price of second order instead of third.
  static GeometryField smooth(const Octree<Dim>& grid, std::span<const double> distance,
                              std::span<const Vec<Dim>> normal,
                              std::span<const std::array<double, n_symmetric<Dim>>> root,
                              bool keep_definite = true);

  Values value(const Vec<Dim>& y) const;

  /// The same with the derivative by each coordinate of y.
  Values value(const Vec<Dim>& y, std::array<Values, Dim>& derivative) const;

  /// Eight points and where they are.
  struct LocatedPoints {
    std::array<Pack, Dim> y, inside;  ///< the second projected onto the domain
    std::array<Index, autodiff::pack_size> leaf;  ///< if smooth
  };
  /// Asks for what look_up() reads there, which can be had early.
  LocatedPoints find(const std::array<Pack, Dim>& y) const;

  /// At eight points at once, in lanes where weight > 0. Other lanes get harmless values, d = 0 and a unit
  /// vector n: they do not count, but a NaN would outlive a multiplication by zero.
  void look_up(const Pack& weight, const LocatedPoints& located, Pack* values) const;
  void look_up(const Pack& weight, const LocatedPoints& located, Pack* values, std::array<Packs, Dim>& derivative) const;

  /// For any scalar, ceres::Jet among them: the derivative comes from the scalar's own arithmetic.
  template <class T>
  TargetPoint<Dim, T> at(SmallVec<T, Dim> y) const;

  bool is_smooth() const { return splines_ != nullptr; }
  /// Of a multilinear field. \pre !is_smooth()
  const Octree<Dim>& grid() const { return *grid_; }
  /// Of the cells that it is made on.
  int finest_level() const { return is_smooth() ? splines_->finest_level() : grid_->finest_level(); }

 private:
  // The values of a node or coefficient, a whole pack and what is left over in space.
  static constexpr int n_rest = n_values > autodiff::pack_size ? n_values - autodiff::pack_size : 0;
  static_assert(n_rest == 0 || n_rest == 2);
  typedef double Pair __attribute__((vector_size(16)));
  struct CoefficientRow {
    Pack main;
    Pair rest;
  };
  struct LocatedPoint {
    Index leaf;      ///< a cell's number, or SplineSpace's
    Vec<Dim> t;      ///< within the leaf, in [0, 1]
    Vec<Dim> slope;  ///< dt/dy: scale, or 0 where y is projected
  };

  GeometryField() = default;
  // Fills the rows: put(at), where at(row, i) refers to a number that is 0 so far.
  template <class Put>
  void store(std::size_t n_rows, const Put& put);
  LocatedPoint locate(const Vec<Dim>& y) const;
  double component(Index row, int i) const {
    return i < autodiff::pack_size ? (*main_)[row][i] : (*rest_)[row][i - autodiff::pack_size];
  }
  // Value, then the derivatives by the coordinates.
  template <bool WithGradient>
  void multilinear(const LocatedPoint& p, CoefficientRow* result) const;
  template <bool WithGradient>
  void spline(const LocatedPoint& p, CoefficientRow* result) const;
  template <bool WithGradient>
  void row(const LocatedPoint& p, CoefficientRow* result) const;
  // What eight points read, on its way to one pack for each value.
  template <bool WithGradient>
  struct LaneRows {
    static constexpr int n_rows = WithGradient ? 1 + Dim : 1;          ///< values, then derivatives by each coordinate
    std::array<std::array<Pack, autodiff::pack_size>, n_rows> main;  ///< by lane
    std::array<Pack, n_rows * n_rest> rest;                          ///< one pack for each value already
    void clear(int lane) {
      for (auto& row : main) row[lane] = Pack{};
    }
  };
  template <bool WithGradient>
  void multilinear_lanes(const Pack& weight, const std::array<Pack, Dim>& y, LaneRows<WithGradient>& rows) const;
  template <bool WithGradient>
  void spline_lanes(const Pack& weight, const LocatedPoints& located, LaneRows<WithGradient>& rows) const;
  template <bool WithGradient>
  void look_up_lanes(const Pack& weight, const LocatedPoints& located, Pack* values, Packs* derivative) const;

  const Octree<Dim>* grid_ = nullptr;                ///< null: smooth
  std::shared_ptr<const SplineSpace<Dim>> splines_;  ///< null: multilinear
  /// By node, or by coefficient; copies of the field share them.
  std::shared_ptr<const std::vector<Pack>> main_;
  std::shared_ptr<const std::vector<Pair>> rest_;
};

/// Both shapes, as the energy of one grid reads them.
template <int Dim>
struct GeometryPair {
  GeometryField<Dim> reference, target;
  bool root_is_inverse;  ///< the reference's root is C(S1)^{-1/2} (or S1), to be taken as it is; else
                         ///< C(S1)^{1/2}, inverted at each point
};

template <int Dim>
template <class T>
TargetPoint<Dim, T> GeometryField<Dim>::at(SmallVec<T, Dim> y) const {
  Vec<Dim> position;
  for (int k = 0; k < Dim; ++k) {
    if (autodiff::scalar_part(y[k]) < 0) y[k] = T(0.0);
    if (autodiff::scalar_part(y[k]) > 1) y[k] = T(1.0);
    position[k] = autodiff::scalar_part(y[k]);
  }
  const Index leaf = is_smooth() ? splines_->locate(position) : grid_->locate(position);
  const int level = is_smooth() ? splines_->level_of(leaf) : grid_->cell(leaf).level;
  const auto corner = is_smooth() ? splines_->corner_of(leaf) : grid_->cell(leaf).corner;
  std::array<T, n_values> sum;
  sum.fill(T(0.0));
  const int per_axis = is_smooth() ? 3 : 2;
  const int n_local = is_smooth() ? SplineSpace<Dim>::n_local : n_corners<Dim>;
  for (int n = 0; n < n_local; ++n) {
    T weight(1.0);
    for (int k = 0, rest = n; k < Dim; ++k, rest /= per_axis) {
      const T t = y[k] * static_cast<double>(1 << level) - static_cast<double>(corner[k]);
      const int i = rest % per_axis;
      if (is_smooth())
        weight = weight * (i == 0 ? 0.5 * (1.0 - t) * (1.0 - t) : i == 1 ? 0.5 + t * (1.0 - t) : 0.5 * t * t);
      else
        weight = weight * (i == 1 ? t : 1.0 - t);
    }
    const Index row = is_smooth() ? splines_->coefficients_of(leaf)[n] : grid_->cell(leaf).nodes[n];
    for (int i = 0; i < n_values; ++i) sum[i] += weight * component(row, i);
  }
  TargetPoint<Dim, T> p;
  p.d2 = sum[0];
  for (int i = 0; i < Dim; ++i) p.n2[i] = sum[1 + i];
  for (int i = 0; i < n_symmetric<Dim>; ++i) p.root.v[i] = sum[1 + Dim + i];
  return p;
}

extern template class GeometryField<2>;
extern template class GeometryField<3>;

}  // namespace shellmatch
