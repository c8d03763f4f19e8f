#pragma once
/// \file
/// Signed distance d, normal n and root of the classified shape operator of one shape, interpolated at any point. The
/// energies evaluate the template's field at deformed positions phi(x).

#include "energies/autodiff/jet.h"
#include "energies/autodiff/pack.h"
#include "energies/fields/coefficients.h"
#include "grid/octree/octree.h"
#include "grid/fields/quadrature.h"
#include "grid/fields/spline_space.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace shellmatch {

/// Interpolates nodal fields: multilinear on each cell, or C1 by quadratic splines. Copies of an object share the data.
/// Positions outside the domain are projected onto it first (paper, section 6); the derivative in a projected direction
/// is zero.
template <int Dim>
class GeometryField {
 public:
  static constexpr int n_values = TargetPoint<Dim, double>::size;
  /// In the order of TargetPoint: d, n, root.
  using Values = std::array<double, n_values>;
  using Pack = autodiff::Pack;
  using Packs = std::array<Pack, n_values>;

  /// Multilinear interpolation of the values at the nodes, hanging nodes included, which are copied. `grid` must
  /// outlive this object. \pre one value for each node of `grid`
  GeometryField(const Octree<Dim>& grid, std::span<const double> distance, std::span<const Vec<Dim>> normal,
                std::span<const std::array<double, n_symmetric<Dim>>> root);

  /// Spline interpolation on `grid`, which need not outlive the object. \param keep_definite roots that are positive
  /// definite at the nodes stay so everywhere; they are then of second instead of third order
  static GeometryField smooth(const Octree<Dim>& grid, std::span<const double> distance,
                              std::span<const Vec<Dim>> normal,
                              std::span<const std::array<double, n_symmetric<Dim>>> root, bool keep_definite = true);

  /// The values at y.
  Values value(const Vec<Dim>& y) const;

  /// The values at y and their derivatives by the coordinates of y.
  Values value(const Vec<Dim>& y, std::array<Values, Dim>& derivative) const;

  /// Eight points, located for look_up().
  struct LocatedPoints {
    std::array<Pack, Dim> y, inside;              ///< positions, and the same projected onto the domain
    std::array<Index, autodiff::pack_size> leaf;  ///< leaf of each point; set for smooth fields only
  };
  /// Locates the points, and prefetches the data that look_up() will read.
  LocatedPoints find(const std::array<Pack, Dim>& y) const;

  /// The values at eight points, in lanes where weight > 0. Other lanes get d = 0 and a unit vector n, because a NaN
  /// there would survive the multiplication by a zero weight.
  /// \param values n_values packs
  void look_up(const Pack& weight, const LocatedPoints& located, Pack* values) const;
  void look_up(const Pack& weight, const LocatedPoints& located, Pack* values,
               std::array<Packs, Dim>& derivative) const;

  /// The values at the points of a tensor grid in a cube of the domain, in a quarter of the time: the coefficients are
  /// read once and summed axis by axis. False, with nothing written, where the cube does not lie within one leaf of the
  /// splines. \param at      positions of the points along each axis, in sides of the cube, at most max_gauss_points
  /// \param values  for every eight points, the first axis fastest; the last point fills up
  bool look_up_cube(const Vec<Dim>& corner, double side, std::span<const double> at, std::span<Packs> values) const;

  /// The values at y for any scalar type, for instance ceres::Jet, whose arithmetic gives the derivatives.
  template <class T>
  TargetPoint<Dim, T> at(SmallVec<T, Dim> y) const;

  bool is_smooth() const { return splines_ != nullptr; }
  /// The grid of a multilinear field. \pre !is_smooth()
  const Octree<Dim>& grid() const { return *grid_; }
  /// Level of the smallest cells of the grid or spline space.
  int finest_level() const { return is_smooth() ? splines_->finest_level() : grid_->finest_level(); }

 private:
  // The values of one node or coefficient are stored as a pack and, in space, a pair of doubles.
  static constexpr int n_rest = n_values > autodiff::pack_size ? n_values - autodiff::pack_size : 0;
  static_assert(n_rest == 0 || n_rest == 2);
  typedef double Pair __attribute__((vector_size(16)));
  struct CoefficientRow {
    Pack main;
    Pair rest;
  };
  // They are kept in single precision, which halves the memory and what a look-up reads of it. Next to a shape all
  // values are small or of order 1, so that rounding is far below the error of interpolation. It also bounds by how
  // much derivatives of smooth fields jump where the level changes: by 1e-7 of their size.
  using KeptPack = autodiff::KeptPack;
  typedef float KeptPair __attribute__((vector_size(8)));
  struct LocatedPoint {
    Index leaf;      ///< number of the leaf in the octree or the SplineSpace
    Vec<Dim> t;      ///< position within the leaf, in [0, 1]
    Vec<Dim> slope;  ///< dt/dy: 1 / side of the leaf, or 0 where y is projected
  };

  GeometryField() = default;
  // Allocates the coefficients and calls put(at), where at(row, i) is a reference to value i of a row, initially 0.
  template <class Put>
  void store(std::size_t n_rows, const Put& put);
  LocatedPoint locate(const Vec<Dim>& y) const;
  double component(Index row, int i) const {
    return static_cast<double>(i < autodiff::pack_size ? (*main_)[row][i] : (*rest_)[row][i - autodiff::pack_size]);
  }
  // result[0] gets the values and result[1 + k] the derivatives by coordinate k.
  template <bool WithGradient>
  void multilinear(const LocatedPoint& p, CoefficientRow* result) const;
  template <bool WithGradient>
  void spline(const LocatedPoint& p, CoefficientRow* result) const;
  template <bool WithGradient>
  void row(const LocatedPoint& p, CoefficientRow* result) const;
  // Values (and derivatives) at eight points, before they are transposed to one pack for each value.
  template <bool WithGradient>
  struct LaneRows {
    static constexpr int n_rows = WithGradient ? 1 + Dim : 1;        ///< values, then derivatives by each coordinate
    std::array<std::array<Pack, autodiff::pack_size>, n_rows> main;  ///< main[k][lane]: first eight values of a lane
    std::array<Pack, n_rows * n_rest> rest;                          ///< the remaining values, one pack for each
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

  const Octree<Dim>* grid_ = nullptr;                ///< null for a smooth field
  std::shared_ptr<const SplineSpace<Dim>> splines_;  ///< null for a multilinear field
  /// By node or by coefficient; shared by copies of the field.
  std::shared_ptr<const std::vector<KeptPack>> main_;
  std::shared_ptr<const std::vector<KeptPair>> rest_;
};

/// The fields of both shapes that the energy on one grid reads.
template <int Dim>
struct GeometryPair {
  GeometryField<Dim> reference, target;
  bool root_is_inverse;  ///< true: the reference's field holds C(S1)^{-1/2} (or S1), which the terms read;
                         ///< false: it holds C(S1)^{1/2}, which is inverted at each point
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
  std::array<std::array<T, 3>, Dim> factor;  // along each axis
  for (int k = 0; k < Dim; ++k) {
    const T t = y[k] * static_cast<double>(1 << level) - static_cast<double>(corner[k]);
    factor[k] = is_smooth() ? SplineWeights<T>(t).value : std::array<T, 3>{1.0 - t, t};
  }
  for (int n = 0; n < n_local; ++n) {
    T weight(1.0);
    for (int k = 0, rest = n; k < Dim; ++k, rest /= per_axis) weight = weight * factor[k][rest % per_axis];
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
