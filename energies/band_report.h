#pragma once
/// \file
/// How the deformed band lies in the template: what oscillations show in.

#include "energies/band.h"
#include "energies/geometry_field.h"

#include <span>

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
};

/// At the quadrature points of the band. phi: positions of all nodes.
template <int Dim>
BandSums sum_band(std::span<const Element<Dim>> elements, const Band<Dim>& band, const ShapeTable<Dim>& shape,
                  const GeometryField<Dim>& target, std::span<const Vec<Dim>> phi);

}  // namespace shellmatch
