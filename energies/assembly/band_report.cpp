#include "energies/assembly/band_report.h"

#include "energies/densities/small_matrix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shellmatch {

using autodiff::Pack;

template <int Dim>
void BandSums::add(const Pack& weights, const Pack* n1, const Pack* n2, const Pack* dphi) {
  SmallMat<Pack, Dim> a;
  std::copy_n(dphi, Dim * Dim, a.v.begin());
  SmallVec<Pack, Dim> from, to;
  std::copy_n(n1, Dim, from.v.begin());
  std::copy_n(n2, Dim, to.v.begin());
  const SmallVec<Pack, Dim> carried = times(cofactor(a), from);
  const Pack product = dot(to, carried), square = dot(to, to) * dot(carried, carried), det = determinant(a);
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    if (!(weights[lane] > 0)) continue;
    const double lengths = std::sqrt(square[lane]);
    // The angle is undefined where either vector vanishes; it counts as 90 degrees.
    const double cosine = lengths > 0 ? std::clamp(product[lane] / lengths, -1.0, 1.0) : 0.0;
    weight += weights[lane];
    angle += weights[lane] * std::acos(cosine) * 180 / std::numbers::pi;
    folded += det[lane] > 0 ? 0.0 : weights[lane];
  }
}

template void BandSums::add<2>(const Pack&, const Pack*, const Pack*, const Pack*);
template void BandSums::add<3>(const Pack&, const Pack*, const Pack*, const Pack*);

}  // namespace shellmatch
