#pragma once
/// \file
/// The parts of two shapes that their files have, and the mask that leaves out all others.

#include "energies/elements/band_mask.h"
#include "geometry/distance/observed_part.h"

#include <span>
#include <utility>

namespace shellmatch {

/// In the unit domain.
template <int Dim>
struct ObservedPair {
  ObservedPart<Dim> reference, template_shape;

  bool is_all() const { return reference.is_all() && template_shape.is_all(); }
  /// Do both shapes have data, the one at x and the other at y?
  bool contains(const Vec<Dim>& x, const Vec<Dim>& y) const {
    return reference.contains(x) && template_shape.contains(y);
  }
};

/// Of shapes whose surfaces and evidence lie in the unit domain; the first is the one that phi deforms.
template <int Dim>
ObservedPair<Dim> observed_pair(const Shape<Dim>& deformed, const Shape<Dim>& other) {
  return {ObservedPart<Dim>(deformed.evidence), ObservedPart<Dim>(other.evidence)};
}

template <int Dim>
ObservedPair<Dim> exchanged(const ObservedPair<Dim>& pair) {
  return {pair.template_shape, pair.reference};
}

/// 1 where both shapes have data, 0 from the edges of gaps on, and a cubic between, over a given width or that of the
/// gap, whichever is less.
template <int Dim>
class ObservedMask final : public BandMask<Dim> {
 public:
  /// \param width > 0; unit domain. Half of the band's, within which coefficients are fitted to data and gap alike:
  ///   half of that and twice as much made errors larger
  ///   on five pairs of which a third had been cut away
  ObservedMask(ObservedPair<Dim> parts, double width) : parts_(std::move(parts)), width_(width) {}
  void reference_weights(std::span<const Vec<Dim>> x, std::span<double> weights) const override;
  void template_weights(std::span<const Vec<Dim>> y, std::span<double> weights) const override;

 private:
  ObservedPair<Dim> parts_;
  double width_;
};

}  // namespace shellmatch
