#pragma once
/// \file
/// Each energy term as a cost functor of Ceres on element-local degrees of freedom: the positions of the
/// element's corners, corner after corner, Dim components each (24 numbers in space). Ceres' automatic
/// differentiation and gradient checker take these as they are; the fast assembly of MatchingEnergy is tested
/// against them.

#include "energies/assembly/band.h"
#include "energies/terms/fold_barrier.h"
#include "energies/terms/integrands.h"
#include "energies/fields/geometry_field.h"

#include <vector>

namespace shellmatch {

namespace detail {

/// phi and Dphi at a quadrature point from the element's degrees of freedom.
template <int Dim, class T>
void deformation_at(const T* dofs, const typename ShapeTable<Dim>::Point& q, double side, SmallVec<T, Dim>& y,
                    SmallMat<T, Dim>& dphi) {
  for (int k = 0; k < Dim; ++k) {
    y[k] = T(0.0);
    for (int j = 0; j < Dim; ++j) dphi(k, j) = T(0.0);
    for (int c = 0; c < n_corners<Dim>; ++c) {
      y[k] += q.n[c] * dofs[c * Dim + k];
      for (int j = 0; j < Dim; ++j) dphi(k, j) += (q.dn[c][j] / side) * dofs[c * Dim + k];
    }
  }
}

}  // namespace detail

/// A band term (Match, Membrane, Bending) on one element.
template <template <int> class BandTerm, int Dim>
class BandElementCost {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  /// Element `lane` of batch `batch` of the band, which has to outlive the functor, as have table and target.
  BandElementCost(const Band<Dim>& band, std::size_t batch, int lane, std::span<const Element<Dim>> elements,
                  const ShapeTable<Dim>& shape, const GeometryField<Dim>& target, double weight, Lame<double> lame)
      : band_(&band), batch_(batch), lane_(lane), side_(elements[band.batches()[batch].element[lane]].side),
        shape_(&shape), target_(&target), weight_(weight), lame_(lame) {}

  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = T(0.0);
    for (std::size_t q = 0; q < shape_->points.size(); ++q) {
      const auto& point = band_->point(batch_, q);
      const double w = point.weight[lane_] * weight_;
      if (!(w > 0)) continue;
      SmallVec<T, Dim> y;
      SmallMat<T, Dim> dphi;
      detail::deformation_at<Dim>(dofs, shape_->points[q], side_, y, dphi);
      ReferencePoint<Dim, double> x;
      x.d1 = point.reference[0][lane_];
      for (int i = 0; i < Dim; ++i) x.n1[i] = point.reference[1 + i][lane_];
      for (int i = 0; i < n_symmetric<Dim>; ++i) x.r1.v[i] = point.reference[1 + Dim + i][lane_];
      *energy += w * BandTerm<Dim>::density(target_->template at<T>(y), dphi, x, lame_);
    }
    return true;
  }

 private:
  const Band<Dim>* band_;
  std::size_t batch_;
  int lane_;
  double side_;
  const ShapeTable<Dim>* shape_;
  const GeometryField<Dim>* target_;
  double weight_;
  Lame<double> lame_;
};

/// A volume term (SimplifiedVolume, FullVolume, SymmetricDirichletVolume) on one element.
template <template <int> class VolumeTerm, int Dim>
class VolumeElementCost {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  VolumeElementCost(double side, const ShapeTable<Dim>& shape, double weight, Lame<double> lame)
      : side_(side), shape_(&shape), weight_(weight), lame_(lame) {}

  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = T(0.0);
    double volume = weight_;
    for (int k = 0; k < Dim; ++k) volume *= side_;
    for (const auto& q : shape_->points) {
      SmallVec<T, Dim> y;
      SmallMat<T, Dim> dphi;
      detail::deformation_at<Dim>(dofs, q, side_, y, dphi);
      *energy += volume * q.weight * VolumeTerm<Dim>::density(dphi, lame_);
    }
    return std::isfinite(autodiff::scalar_part(*energy));
  }

 private:
  double side_;
  const ShapeTable<Dim>* shape_;
  double weight_;
  Lame<double> lame_;
};

/// The barrier against folds on one element.
template <int Dim>
class BarrierElementCost {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  /// threshold: d0 of energies/terms/fold_barrier.h
  BarrierElementCost(double side, double weight, double threshold) {
    double volume = 1;
    for (int k = 0; k < Dim; ++k) volume *= side;
    factor_ = weight * volume;
    scale_ = 1 / (threshold * volume);
  }

  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = factor_ * FoldBarrierFunctor<Dim>::template evaluate<T, double>(dofs, &scale_);
    return std::isfinite(autodiff::scalar_part(*energy));
  }

 private:
  double factor_, scale_;
};

}  // namespace shellmatch
