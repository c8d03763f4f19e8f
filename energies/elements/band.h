#pragma once
/// \file
/// What the band terms need of the reference shape, at the quadrature points of the elements that the band
/// meets. It does not depend on phi and is computed once for each grid.

#include "energies/autodiff/pack.h"
#include "energies/elements/unknowns.h"
#include "energies/fields/geometry_field.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Elements in which eta_sigma(d1) does not vanish at every quadrature point, eight at a time: the lanes of a
/// pack are different elements at the same local point.
template <int Dim>
class Band {
 public:
  static constexpr int n_lanes = autodiff::pack_size;
  static constexpr int n_reference = ReferencePoint<Dim, double>::size;

  /// One local quadrature point of eight elements.
  struct Point {
    autodiff::Pack weight;  ///< eta_sigma(d1) h^Dim w_q; 0 in lanes where the point is outside the band
    std::array<autodiff::KeptPack, n_reference> kept;  ///< in single precision, as the field from which it is
    /// Component i of ReferencePoint.
    autodiff::Pack reference(int i) const { return widened(kept[i]); }
  };
  struct Batch {
    std::array<Index, n_lanes> element;  ///< number in Unknowns::elements(); where there are fewer than lanes the
                                         ///< first is repeated
    int n_elements;
  };

  /// sigma in units of the domain's side. root_is_inverse: of GeometryPair.
  Band(std::span<const Element<Dim>> elements, const ShapeTable<Dim>& shape, const GeometryField<Dim>& reference,
       bool root_is_inverse, double sigma);

  /// ReferencePoint as a flat array, from the reference's field at a point: n1 normalised, the root inverted unless it
  /// is the inverse already, and projected. \param at_point numbers, or packs of points
  template <class T>
  static std::array<T, n_reference> reference_point(const std::array<T, GeometryField<Dim>::n_values>& at_point,
                                                    bool root_is_inverse);

  std::span<const Batch> batches() const { return batches_; }
  /// Number of the element's batch times lanes plus its lane; no_index outside the band.
  Index lane_of(std::size_t element) const;
  /// Those of a block of elements (energies/elements/cell_blocks.h), first and one past the last: no batch has elements
  /// of two.
  std::array<std::size_t, 2> batches_of(std::size_t block) const {
    return {first_batch_[block], first_batch_[block + 1]};
  }
  /// Point q of batch b.
  const Point& point(std::size_t b, std::size_t q) const { return points_[b * n_points_ + q]; }
  /// The local points of an element that have a weight; one of them is multiplied by a factor. After keep_weights()
  /// both go by the weights that were kept, so that a factor takes the place of an earlier one.
  void active_points(std::size_t b, int lane, std::vector<std::size_t>& q) const {
    q.clear();
    for (std::size_t i = b * n_points_; i < (b + 1) * n_points_; ++i)
      if (weight_before_mask(i)[lane] != 0) q.push_back(i - b * n_points_);
  }
  void multiply_weight(std::size_t b, std::size_t q, int lane, double factor) {
    const std::size_t i = b * n_points_ + q;
    points_[i].weight[lane] = weight_before_mask(i)[lane] * factor;
  }
  void keep_weights() {
    kept_weights_.clear();
    kept_weights_.reserve(points_.size());
    for (const Point& p : points_) kept_weights_.push_back(p.weight);
  }

  /// Asks for the point after that one, early: what lies between takes too long for the processor to see the row.
  void prefetch_after(std::size_t b, std::size_t q) const {
    const auto next = reinterpret_cast<const char*>(&point(b, q) + 1);
    for (std::size_t line = 0; line < sizeof(Point); line += 64) __builtin_prefetch(next + line);
  }
  std::size_t n_elements() const { return n_elements_; }
  std::size_t n_active_points() const { return n_active_points_; }
  /// Integral of eta_sigma(d1) over the domain, without a mask: tends to the measure of M1. Unit: length^(Dim-1).
  double measure() const { return measure_; }

 private:
  const autodiff::Pack& weight_before_mask(std::size_t i) const {
    return kept_weights_.empty() ? points_[i].weight : kept_weights_[i];
  }

  std::vector<Batch> batches_;
  std::vector<std::size_t> first_batch_;  ///< by block
  std::vector<Point> points_;
  std::vector<autodiff::Pack> kept_weights_;  ///< of the points; empty without a mask
  std::size_t n_points_ = 0, n_elements_ = 0, n_active_points_ = 0;
  double measure_ = 0;
};

}  // namespace shellmatch
