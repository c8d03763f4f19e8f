// Look-ups of a shape's fields at eight points at once: where most of the time of a gradient goes.

#include "energies/autodiff/transpose.h"
#include "energies/geometry_field.h"
#include "energies/spline_sum.h"

#include <algorithm>
#include <bit>

namespace shellmatch {

using autodiff::pack_size;

// In stages over all lanes, so that none waits for what another one has to fetch from memory.
template <int Dim>
template <bool WithGradient>
inline void GeometryField<Dim>::spline_lanes(const Pack& weight, const std::array<Pack, Dim>& y,
                                             LaneRows<WithGradient>& rows) const {
  using Lanes = std::array<double, pack_size>;
  std::array<Pack, Dim> inside;
  std::array<Lanes, Dim> place;
  for (int k = 0; k < Dim; ++k) {
    // In this order what is not a number, as in lanes that do not count, becomes 0.
    inside[k] = y[k] > 0.0 ? y[k] : Pack{};
    inside[k] = inside[k] < 1.0 ? inside[k] : Pack{} + 1.0;
    place[k] = std::bit_cast<Lanes>(inside[k]);
  }
  std::array<Index, pack_size> leaf;
  splines_->locate(place, leaf);
  for (const Index l : leaf) splines_->prefetch(l);
  std::array<typename SplineSpace<Dim>::Local, pack_size> local;
  Lanes scale;
  std::array<Lanes, Dim> corner;
  for (int lane = 0; lane < pack_size; ++lane) {
    local[lane] = splines_->coefficients_of(leaf[lane]);
    scale[lane] = static_cast<double>(1 << splines_->level_of(leaf[lane]));
    const auto c = splines_->corner_of(leaf[lane]);
    for (int k = 0; k < Dim; ++k) corner[k][lane] = c[k];
  }

  std::array<std::array<Lanes, 3>, Dim> value, slope;
  for (int k = 0; k < Dim; ++k) {
    const Pack size = std::bit_cast<Pack>(scale), t = inside[k] * size - std::bit_cast<Pack>(corner[k]);
    const Pack by_y = inside[k] == y[k] ? size : Pack{};  // none where y is projected
    const std::array<Pack, 3> v = {0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t};
    const std::array<Pack, 3> s = {(t - 1.0) * by_y, (1.0 - 2.0 * t) * by_y, t * by_y};
    value[k] = std::bit_cast<std::array<Lanes, 3>>(v);
    slope[k] = std::bit_cast<std::array<Lanes, 3>>(s);
  }
  for (int lane = 0; lane < pack_size; ++lane) {
    if (!(weight[lane] > 0)) {
      rows.clear(lane);
      continue;
    }
    const auto& c = local[lane];
    const auto sum = [&](const auto* from, auto&& put) {
      sum_spline<Dim, WithGradient>([&](int n) { return from[c[n]]; }, [&](int k, int i) { return value[k][i][lane]; },
                                    [&](int k, int i) { return slope[k][i][lane]; }, put);
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
void GeometryField<Dim>::look_up_lanes(const Pack& weight, const std::array<Pack, Dim>& y, Pack* values,
                                       Packs* derivative) const {
  LaneRows<WithGradient> rows;
  if (is_smooth())
    spline_lanes(weight, y, rows);
  else
    multilinear_lanes(weight, y, rows);
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
void GeometryField<Dim>::look_up(const Pack& weight, const std::array<Pack, Dim>& y, Pack* values) const {
  look_up_lanes<false>(weight, y, values, nullptr);
}

template <int Dim>
void GeometryField<Dim>::look_up(const Pack& weight, const std::array<Pack, Dim>& y, Pack* values,
                                 std::array<Packs, Dim>& derivative) const {
  look_up_lanes<true>(weight, y, values, derivative.data());
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                         \
  template void GeometryField<Dim>::look_up(const Pack&, const std::array<Pack, Dim>&, Pack*) const;        \
  template void GeometryField<Dim>::look_up(const Pack&, const std::array<Pack, Dim>&, Pack*,               \
                                            std::array<Packs, Dim>&) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
