#pragma once
/// \file
/// How the deformed band lies in the template: what oscillations show in.

#include "energies/autodiff/pack.h"

namespace shellmatch {

/// Means over the band, weighted by eta_sigma(d1).
struct BandReport {
  double normal_angle = 0;  ///< degrees between n2(phi) and the transported normal cof(Dphi) n1
  double folded_share = 0;  ///< share of the band where det Dphi <= 0
};

/// What the means are made of, for bands that are looked at piece by piece.
struct BandSums {
  double weight = 0, angle = 0, folded = 0;
  BandSums& operator+=(const BandSums& o) {
    weight += o.weight;
    angle += o.angle;
    folded += o.folded;
    return *this;
  }
  BandReport means() const { return weight > 0 ? BandReport{angle / weight, folded / weight} : BandReport{}; }

  /// Adds eight points: eta_sigma(d1) times volume, 0 where a lane does not count; the reference's normal, the
  /// template's at phi, and Dphi by rows.
  template <int Dim>
  void add(const autodiff::Pack& weights, const autodiff::Pack* n1, const autodiff::Pack* n2, const autodiff::Pack* dphi);
};

}  // namespace shellmatch
