#include "energies/fields/geometry_field.h"

#include "base/error.h"
#include "energies/fields/spline_sum.h"
#include "grid/fields/spline_coefficients.h"

namespace shellmatch {

namespace {

/// Component i of the values at a node, in the order of TargetPoint.
template <int Dim>
class NodalValues {
 public:
  NodalValues(const Octree<Dim>& grid, std::span<const double> distance, std::span<const Vec<Dim>> normal,
              std::span<const std::array<double, n_symmetric<Dim>>> root)
      : distance_(distance), normal_(normal), root_(root) {
    const auto n = static_cast<std::size_t>(grid.n_nodes());
    SHELLMATCH_CHECK(distance.size() == n && normal.size() == n && root.size() == n,
                     "the fields must have one value for each node");
  }
  double operator()(Index node, std::size_t i) const {
    if (i == 0) return distance_[node];
    return i <= Dim ? normal_[node][static_cast<Eigen::Index>(i) - 1] : root_[node][i - 1 - Dim];
  }

 private:
  std::span<const double> distance_;
  std::span<const Vec<Dim>> normal_;
  std::span<const std::array<double, n_symmetric<Dim>>> root_;
};

}  // namespace

template <int Dim>
GeometryField<Dim>::GeometryField(const Octree<Dim>& grid, std::span<const double> distance,
                                  std::span<const Vec<Dim>> normal,
                                  std::span<const std::array<double, n_symmetric<Dim>>> root)
    : grid_(&grid) {
  const NodalValues<Dim> nodal(grid, distance, normal, root);
  store(static_cast<std::size_t>(grid.n_nodes()), [&](const auto& at) {
    parallel_for(
        static_cast<std::size_t>(grid.n_nodes()),
        [&](std::size_t node) {
          for (std::size_t i = 0; i < n_values; ++i)
            at(static_cast<Index>(node), i) = static_cast<float>(nodal(static_cast<Index>(node), i));
        },
        4096);
  });
}

template <int Dim>
GeometryField<Dim> GeometryField<Dim>::smooth(const Octree<Dim>& grid, std::span<const double> distance,
                                              std::span<const Vec<Dim>> normal,
                                              std::span<const std::array<double, n_symmetric<Dim>>> root,
                                              bool keep_definite) {
  const NodalValues<Dim> nodal(grid, distance, normal, root);
  SplineSpace<Dim> splines(grid);
  GeometryField field;
  field.store(static_cast<std::size_t>(splines.n_coefficients()), [&](const auto& at) {
    // Quasi-interpolation overshoots at sharp edges, so the roots would not stay positive definite.
    if (keep_definite) splines.template coefficients<n_values, 1 + Dim>(nodal, at);
    else splines.template coefficients<n_values, n_values>(nodal, at);
  });
  splines.forget_grid();
  field.splines_ = std::make_shared<const SplineSpace<Dim>>(std::move(splines));
  return field;
}

template <int Dim>
template <class Put>
void GeometryField<Dim>::store(std::size_t n_rows, const Put& put) {
  const auto main = std::make_shared<std::vector<KeptPack>>(n_rows, KeptPack{});
  const auto rest = std::make_shared<std::vector<KeptPair>>(n_rest > 0 ? n_rows : 0, KeptPair{});
  const auto mains = reinterpret_cast<float*>(main->data()), rests = reinterpret_cast<float*>(rest->data());
  put([=](Index row, std::size_t i) -> float& {
    const auto r = static_cast<std::size_t>(row);
    return i < autodiff::pack_size ? mains[r * autodiff::pack_size + i] : rests[r * n_rest + i - autodiff::pack_size];
  });
  main_ = main;
  rest_ = rest;
}

template <int Dim>
inline typename GeometryField<Dim>::LocatedPoint GeometryField<Dim>::locate(const Vec<Dim>& y) const {
  const Vec<Dim> inside = y.cwiseMax(0.0).cwiseMin(1.0);
  LocatedPoint p;
  const auto set_local = [&](int level, const typename Octree<Dim>::Coord& corner) {
    const double scale = static_cast<double>(1 << level);
    for (int k = 0; k < Dim; ++k) {
      p.t[k] = inside[k] * scale - corner[k];
      p.slope[k] = inside[k] == y[k] ? scale : 0.0;
    }
  };
  if (is_smooth()) {
    p.leaf = splines_->locate(inside);
    set_local(splines_->level_of(p.leaf), splines_->corner_of(p.leaf));
  } else {
    p.leaf = grid_->locate(inside);
    const auto& cell = grid_->cell(p.leaf);
    set_local(cell.level, cell.corner);
  }
  return p;
}

template <int Dim>
template <bool WithGradient>
inline void GeometryField<Dim>::spline(const LocatedPoint& p, CoefficientRow* result) const {
  const auto local = splines_->coefficients_of(p.leaf);
  const auto array_of = [](const Vec<Dim>& x) {
    std::array<double, Dim> a;
    for (int k = 0; k < Dim; ++k) a[k] = x[k];
    return a;
  };
  const SplineFactors<Dim, double> factors(array_of(p.t), array_of(p.slope));
  // Sums one array of coefficients at a time: first the packs, then the pairs.
  const auto sum = [&](const auto& from, auto&& put) {
    sum_spline<Dim, WithGradient>(
        factors, [&](int n) { return widened(from[local[n]]); }, [](double x) { return x; }, put);
  };
  sum(*main_, [&](int i, const Pack& x) { result[i].main = x; });
  if constexpr (n_rest > 0) sum(*rest_, [&](int i, const Pair& x) { result[i].rest = x; });
}

template <int Dim>
template <bool WithGradient>
inline void GeometryField<Dim>::multilinear(const LocatedPoint& p, CoefficientRow* result) const {
  const auto& nodes = grid_->cell(p.leaf).nodes;
  const auto collapse = [&](const auto* rows, auto&& put) {
    using Part = decltype(widened(rows[0]));
    constexpr int n = n_corners<Dim>;
    std::array<Part, n> v;
    for (int c = 0; c < n; ++c) v[c] = widened(rows[nodes[c]]);
    std::array<std::array<Part, n / 2>, Dim> d;
    for (int k = 0, left = n / 2; k < Dim; ++k, left /= 2)
      for (int i = 0; i < left; ++i) {
        if (WithGradient)
          for (int j = 0; j < k; ++j) d[j][i] = d[j][2 * i] + p.t[k] * (d[j][2 * i + 1] - d[j][2 * i]);
        const Part difference = v[2 * i + 1] - v[2 * i];
        if (WithGradient) d[k][i] = p.slope[k] * difference;
        v[i] = v[2 * i] + p.t[k] * difference;
      }
    put(0, v[0]);
    if (WithGradient)
      for (int k = 0; k < Dim; ++k) put(1 + k, d[k][0]);
  };
  collapse(main_->data(), [&](int i, const Pack& x) { result[i].main = x; });
  if constexpr (n_rest > 0) collapse(rest_->data(), [&](int i, const Pair& x) { result[i].rest = x; });
}

template <int Dim>
template <bool WithGradient>
inline void GeometryField<Dim>::row(const LocatedPoint& p, CoefficientRow* result) const {
  if (is_smooth()) spline<WithGradient>(p, result);
  else multilinear<WithGradient>(p, result);
}

template <int Dim>
typename GeometryField<Dim>::Values GeometryField<Dim>::value(const Vec<Dim>& y) const {
  CoefficientRow r;
  row<false>(locate(y), &r);
  Values v;
  for (int i = 0; i < n_values; ++i) v[i] = i < autodiff::pack_size ? r.main[i] : r.rest[i - autodiff::pack_size];
  return v;
}

template <int Dim>
typename GeometryField<Dim>::Values GeometryField<Dim>::value(const Vec<Dim>& y,
                                                              std::array<Values, Dim>& derivative) const {
  std::array<CoefficientRow, 1 + Dim> rows;
  row<true>(locate(y), rows.data());
  Values v;
  for (int k = 0; k <= Dim; ++k)
    for (int i = 0; i < n_values; ++i) {
      const CoefficientRow& r = rows[k];
      (k == 0 ? v : derivative[k - 1])[i] = i < autodiff::pack_size ? r.main[i] : r.rest[i - autodiff::pack_size];
    }
  return v;
}

template <int Dim>
template <bool WithGradient>
void GeometryField<Dim>::multilinear_lanes(const Pack& weight, const std::array<Pack, Dim>& y,
                                           LaneRows<WithGradient>& rows) const {
  rows.rest.fill(Pack{});
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    if (!(weight[lane] > 0)) {
      rows.clear(lane);
      continue;
    }
    Vec<Dim> position;
    for (int k = 0; k < Dim; ++k) position[k] = y[k][lane];
    std::array<CoefficientRow, LaneRows<WithGradient>::n_rows> r;
    multilinear<WithGradient>(locate(position), r.data());
    for (int k = 0; k < LaneRows<WithGradient>::n_rows; ++k) {
      rows.main[k][lane] = r[k].main;
      for (int i = 0; i < n_rest; ++i) rows.rest[n_rest * k + i][lane] = r[k].rest[i];
    }
  }
}

template class GeometryField<2>;
template class GeometryField<3>;
template void GeometryField<2>::multilinear_lanes<true>(const Pack&, const std::array<Pack, 2>&, LaneRows<true>&) const;
template void GeometryField<2>::multilinear_lanes<false>(const Pack&, const std::array<Pack, 2>&,
                                                         LaneRows<false>&) const;
template void GeometryField<3>::multilinear_lanes<true>(const Pack&, const std::array<Pack, 3>&, LaneRows<true>&) const;
template void GeometryField<3>::multilinear_lanes<false>(const Pack&, const std::array<Pack, 3>&,
                                                         LaneRows<false>&) const;

}  // namespace shellmatch
