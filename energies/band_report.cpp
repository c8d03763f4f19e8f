#include "energies/band_report.h"

#include "base/parallel.h"
#include "energies/element_batch.h"

#include <cmath>
#include <numbers>

namespace shellmatch {

template <int Dim>
BandSums sum_band(std::span<const Element<Dim>> elements, const Band<Dim>& band, const ShapeTable<Dim>& shape,
                  const GeometryField<Dim>& target, std::span<const Vec<Dim>> phi) {
  using autodiff::Pack;
  const auto batches = band.batches();
  return parallel_sum(batches.size(), 32, BandSums{}, [&](const Chunk& chunk) {
    BandSums sums;
    ElementBatch<Dim> batch;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      batch.load(elements, phi, [&](int lane) { return batches[b].element[lane]; });
      for (std::size_t q = 0; q < shape.points.size(); ++q) {
        const auto& point = band.point(b, q);
        std::array<Pack, Dim> place;
        std::array<Pack, Dim * Dim> jacobian;
        batch.evaluate(shape.points[q], place, jacobian.data());
        std::array<Pack, GeometryField<Dim>::n_values> there;
        target.look_up(point.weight, place, there.data());
        for (int lane = 0; lane < autodiff::pack_size; ++lane) {
          const double weight = point.weight[lane];
          if (!(weight > 0)) continue;
          SmallMat<double, Dim> dphi;
          for (int i = 0; i < Dim * Dim; ++i) dphi.v[i] = jacobian[i][lane];
          SmallVec<double, Dim> n1, n2;
          for (int k = 0; k < Dim; ++k) {
            n1[k] = point.reference[1 + k][lane];
            n2[k] = there[1 + k][lane];
          }
          const SmallVec<double, Dim> carried = times(cofactor(dphi), n1);
          const double lengths = std::sqrt(dot(n2, n2) * dot(carried, carried));
          // Where either vanishes there is no angle; count it as a right one.
          const double cosine = lengths > 0 ? std::clamp(dot(n2, carried) / lengths, -1.0, 1.0) : 0.0;
          sums.weight += weight;
          sums.angle += weight * std::acos(cosine) * 180 / std::numbers::pi;
          sums.folded += determinant(dphi) > 0 ? 0.0 : weight;
        }
      }
    }
    return sums;
  });
}

template BandSums sum_band<2>(std::span<const Element<2>>, const Band<2>&, const ShapeTable<2>&,
                              const GeometryField<2>&, std::span<const Vec<2>>);
template BandSums sum_band<3>(std::span<const Element<3>>, const Band<3>&, const ShapeTable<3>&,
                              const GeometryField<3>&, std::span<const Vec<3>>);

}  // namespace shellmatch
