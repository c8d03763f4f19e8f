// Look-ups of a shape's fields at eight points at once: where most of the time of a gradient goes.

#include "energies/autodiff/transpose.h"
#include "energies/geometry_field.h"
#include "energies/spline_sum.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace shellmatch {

using autodiff::Pack;
using autodiff::pack_size;

namespace {

/// Each of four lanes twice: what multiplies their pairs of numbers in one pack.
template <int first>
Pack doubled(const Pack& x) {
  return __builtin_shufflevector(x, x, first, first, first + 1, first + 1, first + 2, first + 2, first + 3, first + 3);
}

}  // namespace

template <int Dim>
typename GeometryField<Dim>::Spots GeometryField<Dim>::find(const std::array<Pack, Dim>& y) const {
  Spots spots{.y = y, .inside = {}, .leaf = {}};
  std::array<std::array<double, pack_size>, Dim> place;
  for (int k = 0; k < Dim; ++k) {
    // In this order what is not a number, as in lanes that do not count, becomes 0.
    Pack& inside = spots.inside[k];
    inside = y[k] > 0.0 ? y[k] : Pack{};
    inside = inside < 1.0 ? inside : Pack{} + 1.0;
    place[k] = std::bit_cast<std::array<double, pack_size>>(inside);
  }
  if (!is_smooth()) return spots;
  splines_->locate(place, spots.leaf);
  for (const Index l : spots.leaf) splines_->prefetch(l);
  return spots;
}

// In stages over all lanes, so that none waits for what another one has to fetch from memory.
template <int Dim>
template <bool WithGradient>
inline void GeometryField<Dim>::spline_lanes(const Pack& weight, const Spots& spots,
                                             LaneRows<WithGradient>& rows) const {
  // What is read at coefficient c begins so many doubles from the first; in 32 bits (see store()).
  std::array<typename SplineSpace<Dim>::Local, pack_size> offset;
  Pack size;
  std::array<Pack, Dim> corner;
  for (int lane = 0; lane < pack_size; ++lane) {
    const Index leaf = spots.leaf[lane];
    offset[lane] = splines_->coefficients_of(leaf);
    for (Index& c : offset[lane].c) c = static_cast<Index>(static_cast<std::uint32_t>(c) * pack_size);
    size[lane] = static_cast<double>(1 << splines_->level_of(leaf));
    const auto c = splines_->corner_of(leaf);
    for (int k = 0; k < Dim; ++k) corner[k][lane] = c[k];
  }
  std::array<Pack, Dim> t, scale;
  for (int k = 0; k < Dim; ++k) {
    t[k] = spots.inside[k] * size - corner[k];
    scale[k] = spots.inside[k] == spots.y[k] ? size : Pack{};  // none where y is projected
  }
  const SplineFactors<Dim, Pack> factors(t, scale);

  const auto main = reinterpret_cast<const double*>(main_->data());
  for (int lane = 0; lane < pack_size; ++lane) {
    if (!(weight[lane] > 0)) {
      rows.clear(lane);
      continue;
    }
    sum_long_rows<Dim, WithGradient>(
        factors,
        [&](int n) { return *reinterpret_cast<const Pack*>(main + static_cast<std::uint32_t>(offset[lane][n])); },
        [&](const Pack& x) { return reinterpret_cast<const double*>(&x)[lane]; },
        [&](int i, const Pack& x) { rows.main[i][lane] = x; });
  }
  if constexpr (n_rest > 0) {
    // Pairs of four lanes in one pack.
    const auto rest = reinterpret_cast<const char*>(rest_->data());
    const auto pair = [&](int lane, int n) {
      return *reinterpret_cast<const Pair*>(rest + sizeof(Pair) / pack_size * static_cast<std::uint32_t>(offset[lane][n]));
    };
    std::array<std::array<Pack, LaneRows<WithGradient>::n_rows>, 2> half;
    const auto sum_half = [&]<int first>() {
      const auto two = [&](int lane, int n) {
        return __builtin_shufflevector(pair(lane, n), pair(lane + 1, n), 0, 1, 2, 3);
      };
      sum_spline<Dim, WithGradient>(
          factors,
          [&](int n) { return __builtin_shufflevector(two(first, n), two(first + 2, n), 0, 1, 2, 3, 4, 5, 6, 7); },
          doubled<first>, [&](int i, const Pack& x) { half[first > 0][i] = x; });
    };
    sum_half.template operator()<0>();
    sum_half.template operator()<pack_size / 2>();
    for (int i = 0; i < LaneRows<WithGradient>::n_rows; ++i) {
      rows.rest[n_rest * i] = __builtin_shufflevector(half[0][i], half[1][i], 0, 2, 4, 6, 8, 10, 12, 14);
      rows.rest[n_rest * i + 1] = __builtin_shufflevector(half[0][i], half[1][i], 1, 3, 5, 7, 9, 11, 13, 15);
    }
  }
}

template <int Dim>
template <bool WithGradient>
void GeometryField<Dim>::look_up_lanes(const Pack& weight, const Spots& spots, Pack* values,
                                       Packs* derivative) const {
  LaneRows<WithGradient> rows;
  if (is_smooth())
    spline_lanes(weight, spots, rows);
  else
    multilinear_lanes(weight, spots.y, rows);
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
void GeometryField<Dim>::look_up(const Pack& weight, const Spots& spots, Pack* values) const {
  look_up_lanes<false>(weight, spots, values, nullptr);
}

template <int Dim>
void GeometryField<Dim>::look_up(const Pack& weight, const Spots& spots, Pack* values,
                                 std::array<Packs, Dim>& derivative) const {
  look_up_lanes<true>(weight, spots, values, derivative.data());
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                         \
  template typename GeometryField<Dim>::Spots GeometryField<Dim>::find(const std::array<Pack, Dim>&) const; \
  template void GeometryField<Dim>::look_up(const Pack&, const Spots&, Pack*) const;                        \
  template void GeometryField<Dim>::look_up(const Pack&, const Spots&, Pack*, std::array<Packs, Dim>&) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
