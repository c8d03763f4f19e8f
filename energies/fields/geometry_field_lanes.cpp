// Interpolation of a shape's fields at eight points at once. An evaluation of the gradient spends most of its time
// here.

#include "energies/autodiff/transpose.h"
#include "energies/fields/geometry_field.h"
#include "energies/fields/spline_sum.h"

#include <algorithm>
#include <bit>

namespace shellmatch {

using autodiff::pack_size;

template <int Dim>
typename GeometryField<Dim>::LocatedPoints GeometryField<Dim>::find(const std::array<Pack, Dim>& y) const {
  LocatedPoints located{.y = y, .inside = {}, .leaf = {}};
  std::array<std::array<double, pack_size>, Dim> positions;
  for (int k = 0; k < Dim; ++k) {
    // The order of the comparisons maps NaN, as in lanes of weight 0, to 0.
    Pack& inside = located.inside[k];
    inside = autodiff::where_greater(y[k], Pack{}, y[k]);
    inside = autodiff::where_greater(Pack{} + 1.0, inside, inside, Pack{} + 1.0);
    positions[k] = std::bit_cast<std::array<double, pack_size>>(inside);
  }
  if (!is_smooth()) return located;
  splines_->locate(positions, located.leaf);
  for (const Index l : located.leaf) splines_->prefetch(l);
  return located;
}

// Works in stages over all lanes, so that the memory accesses of the lanes overlap.
template <int Dim>
template <bool WithGradient>
inline void GeometryField<Dim>::spline_lanes(const Pack& weight, const LocatedPoints& located,
                                             LaneRows<WithGradient>& rows) const {
  std::array<typename SplineSpace<Dim>::Local, pack_size> local;
  Pack size;
  std::array<Pack, Dim> corner;
  for (int lane = 0; lane < pack_size; ++lane) {
    const Index leaf = located.leaf[lane];
    local[lane] = splines_->coefficients_of(leaf);
    size[lane] = static_cast<double>(1 << splines_->level_of(leaf));
    const auto c = splines_->corner_of(leaf);
    for (int k = 0; k < Dim; ++k) corner[k][lane] = c[k];
  }
  std::array<Pack, Dim> t, scale;
  for (int k = 0; k < Dim; ++k) {
    t[k] = located.inside[k] * size - corner[k];
    scale[k] = located.inside[k] == located.y[k] ? size : Pack{};  // 0 where y is projected
  }
  const SplineFactors<Dim, Pack> factors(t, scale);

  for (int lane = 0; lane < pack_size; ++lane) {
    if (!(weight[lane] > 0)) {
      rows.clear(lane);
      continue;
    }
    const auto& c = local[lane];
    const auto sum = [&](const auto* from, auto&& put) {
      const auto of_lane = [&](const Pack& x) { return reinterpret_cast<const double*>(&x)[lane]; };
      sum_spline<Dim, WithGradient>(
          factors, [&](int n) { return widened(from[c[n]]); }, of_lane, put);
    };
    sum(main_->data(), [&](int i, const Pack& x) { rows.main[i][lane] = x; });
    if constexpr (n_rest > 0)
      sum(rest_->data(), [&](int i, const Pair& x) {
        for (int r = 0; r < n_rest; ++r) rows.rest[n_rest * i + r][lane] = x[r];
      });
  }
}

template <int Dim>
template <bool WithGradient>
void GeometryField<Dim>::look_up_lanes(const Pack& weight, const LocatedPoints& located, Pack* values,
                                       Packs* derivative) const {
  LaneRows<WithGradient> rows;
  if (is_smooth()) spline_lanes(weight, located, rows);
  else multilinear_lanes(weight, located.y, rows);
  constexpr int n_main = std::min<int>(n_values, pack_size);
  for (int k = 0; k < LaneRows<WithGradient>::n_rows; ++k) {
    autodiff::transpose(rows.main[k]);
    Pack* to = k == 0 ? values : derivative[k - 1].data();
    for (int i = 0; i < n_main; ++i) to[i] = rows.main[k][i];
    for (int i = 0; i < n_rest; ++i) to[n_main + i] = weight > 0 ? rows.rest[n_rest * k + i] : Pack{};
  }
  values[1] = weight > 0 ? values[1] : Pack{} + 1.0;
}

template <int Dim>
void GeometryField<Dim>::look_up(const Pack& weight, const LocatedPoints& located, Pack* values) const {
  look_up_lanes<false>(weight, located, values, nullptr);
}

template <int Dim>
void GeometryField<Dim>::look_up(const Pack& weight, const LocatedPoints& located, Pack* values,
                                 std::array<Packs, Dim>& derivative) const {
  look_up_lanes<true>(weight, located, values, derivative.data());
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                 \
  template typename GeometryField<Dim>::LocatedPoints GeometryField<Dim>::find(const std::array<Pack, Dim>&) const; \
  template void GeometryField<Dim>::look_up(const Pack&, const LocatedPoints&, Pack*) const;                        \
  template void GeometryField<Dim>::look_up(const Pack&, const LocatedPoints&, Pack*, std::array<Packs, Dim>&) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
