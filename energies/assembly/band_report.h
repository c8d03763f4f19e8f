#pragma once
/// \file
/// Measures of how the deformed band lies in the template, which reveal oscillating solutions.

#include "energies/autodiff/pack.h"

namespace shellmatch {

/// Means over the band with weight eta_sigma(d1).
struct BandReport {
  double normal_angle = 0;  ///< degrees, 0 to 180: angle between n2(phi) and the transported normal cof(Dphi) n1
  double folded_share = 0;  ///< share of the band where det Dphi <= 0, in [0, 1]
};

/// The sums from which BandReport is computed. They can be accumulated over parts of the band.
struct BandSums {
  double weight = 0, angle = 0, folded = 0;
  BandSums& operator+=(const BandSums& o) {
    weight += o.weight;
    angle += o.angle;
    folded += o.folded;
    return *this;
  }
  BandReport means() const { return weight > 0 ? BandReport{angle / weight, folded / weight} : BandReport{}; }

  /// Adds eight points.
  /// \param weights eta_sigma(d1) times the volume of the point, 0 in unused lanes
  /// \param n1 normal of the reference, n2 the template's at phi, dphi the rows of Dphi
  template <int Dim>
  void add(const autodiff::Pack& weights, const autodiff::Pack* n1, const autodiff::Pack* n2,
           const autodiff::Pack* dphi);
};

}  // namespace shellmatch
