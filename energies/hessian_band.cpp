// Second derivatives of the band terms, eight elements at a time.

#include "base/parallel.h"
#include "energies/element_batch.h"
#include "energies/energy_hessian.h"
#include "energies/tangent_hessian.h"

#include <cmath>

namespace shellmatch {

namespace {

template <int M>
using SquarePack = std::array<std::array<Pack, M>, M>;

/// t^T A s for tangent bases t, s.
template <int Dim, class Entry>
SquarePack<Dim - 1> in_frames(const std::array<std::array<Pack, Dim>, Dim - 1>& t, Entry&& a,
                              const std::array<std::array<Pack, Dim>, Dim - 1>& s) {
  SquarePack<Dim - 1> r{};
  for (int i = 0; i < Dim - 1; ++i)
    for (int k = 0; k < Dim; ++k)
      for (int j = 0; j < Dim - 1; ++j)
        for (int l = 0; l < Dim; ++l) r[i][j] += t[i][k] * a(k, l) * s[j][l];
  return r;
}

/// What the template and the deformation give at eight points.
template <int Dim>
struct PointGeometry {
  std::array<Pack, Dim> gradient2;  ///< of d2 at phi
  std::array<Pack, Dim> n2;
  std::array<Pack, n_symmetric<Dim>> root;
};

template <int Dim>
PointGeometry<Dim> geometry_at(const TargetField<Dim>& target, const Pack& weight, const std::array<Pack, Dim>& y) {
  PointGeometry<Dim> g{};
  g.n2[0] = Pack{} + 1.0;
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    if (!(weight[lane] > 0)) continue;
    Vec<Dim> place;
    for (int k = 0; k < Dim; ++k) place[k] = y[k][lane];
    std::array<typename TargetField<Dim>::Row, Dim> d;
    const auto row = target.value(place, d);
    Vec<Dim> n;
    for (int k = 0; k < Dim; ++k) {
      g.gradient2[k][lane] = d[k][0][0];
      n[k] = row[(1 + k) / 4][(1 + k) % 4];
    }
    const double length = n.norm();
    n = length > 1e-9 ? Vec<Dim>(n / length) : Vec<Dim>(Vec<Dim>::Unit(0));
    for (int k = 0; k < Dim; ++k) g.n2[k][lane] = n[k];
    for (int i = 0; i < n_symmetric<Dim>; ++i) g.root[i][lane] = row[(1 + Dim + i) / 4][(1 + Dim + i) % 4];
  }
  return g;
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::assemble_band(std::span<const Vec<Dim>> phi, const TermValues& weights) {
  constexpr int m = (Dim - 1) * (Dim - 1);
  const auto elements = unknowns_->elements();
  const Band<Dim>& band = energy_->band();
  const auto& points = energy_->shape().points;
  const Lame<double> lame{options_.lambda, options_.mu};

  parallel_chunks(band.batches().size(), 32, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    std::array<Pack, n_packed> k;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const auto& members = band.batches()[b];
      batch.load(elements, phi, [&](int lane) { return members.element[lane]; });
      k.fill(Pack{});
      const auto add_square = [&](const std::array<Pack, n_dofs>& v) {
        int at = 0;
        for (int i = 0; i < n_dofs; ++i)
          for (int j = i; j < n_dofs; ++j) k[at++] += v[i] * v[j];
      };
      for (std::size_t q = 0; q < points.size(); ++q) {
        const auto& point = band.point(b, q);
        if (autodiff::sum_lanes(point.weight) == 0) continue;
        std::array<Pack, Dim> y;
        batch.position(points[q], y);
        const auto g = geometry_at<Dim>(*target_, point.weight, y);
        std::array<Pack, n_dofs> v;
        if (weights[Term::match] > 0) {
          const Pack scale = autodiff::root_of(2.0 * weights[Term::match] * point.weight);
          for (int c = 0; c < n_corners<Dim>; ++c)
            for (int a = 0; a < Dim; ++a) v[c * Dim + a] = scale * points[q].n[c] * g.gradient2[a];
          add_square(v);
        }
        // X = t2^T Dphi t1; membrane: W of X; bending: W of N X R, N and R the roots in the frames.
        std::array<Pack, Dim * Dim> dphi;
        batch.jacobian(points[q], dphi.data());
        std::array<Pack, Dim> n1;
        for (int a = 0; a < Dim; ++a) n1[a] = point.reference[1 + a];
        const auto t1 = tangent_basis<Dim>(n1), t2 = tangent_basis<Dim>(g.n2);
        const auto x = in_frames<Dim>(t2, [&](int i, int j) { return dphi[i * Dim + j]; }, t1);
        const auto n = in_frames<Dim>(t2, [&](int i, int j) { return g.root[SmallSym<double, Dim>::slot(i, j)]; }, t2);
        const auto r = in_frames<Dim>(t1, [&](int i, int j) { return point.reference[1 + Dim + SmallSym<double, Dim>::slot(i, j)]; }, t1);
        std::array<Pack, m> flat{}, bent{};
        for (int i = 0; i < Dim - 1; ++i)
          for (int j = 0; j < Dim - 1; ++j) {
            flat[i * (Dim - 1) + j] = x[i][j];
            for (int s = 0; s < Dim - 1; ++s)
              for (int t = 0; t < Dim - 1; ++t) bent[i * (Dim - 1) + j] += n[i][s] * x[s][t] * r[t][j];
          }
        // Lanes without weight may hold anything: an infinity would outlive the multiplication by zero.
        for (int i = 0; i < m; ++i) {
          const Pack one = Pack{} + (i % Dim == 0 ? 1.0 : 0.0);
          flat[i] = point.weight > 0 ? flat[i] : one;
          bent[i] = point.weight > 0 ? bent[i] : one;
        }
        SquarePack<m> h{};
        if (weights[Term::membrane] > 0) {
          const auto w = tangent_hessian<Dim>(flat, lame);
          for (int i = 0; i < m; ++i)
            for (int j = 0; j < m; ++j) h[i][j] += weights[Term::membrane] * w[i][j];
        }
        if (weights[Term::bending] > 0) {
          const auto w = tangent_hessian<Dim>(bent, lame);
          // d(N X R) / dX, entry (i j) by (s t): N_is R_tj.
          const auto chain = [&](int e, int f) { return n[e / (Dim - 1)][f / (Dim - 1)] * r[f % (Dim - 1)][e % (Dim - 1)]; };
          for (int i = 0; i < m; ++i)
            for (int j = i; j < m; ++j) {
              Pack sum{};
              for (int e = 0; e < m; ++e)
                for (int f = 0; f < m; ++f) sum += chain(e, i) * w[e][f] * chain(f, j);
              h[i][j] += weights[Term::bending] * sum;
              if (i != j) h[j][i] += weights[Term::bending] * sum;
            }
        }
        const auto l = cholesky<m>(h);
        const Pack root_weight = autodiff::root_of(point.weight);
        for (int mode = 0; mode < m; ++mode) {
          // Component a of corner c moves X_ij by t2_i[a] (grad N_c . t1_j).
          std::array<std::array<Pack, Dim>, Dim> direction{};  // sum_ij L_ij,mode t2_i t1_j^T
          for (int i = 0; i < Dim - 1; ++i)
            for (int j = 0; j < Dim - 1; ++j)
              for (int a = 0; a < Dim; ++a)
                for (int d = 0; d < Dim; ++d)
                  direction[a][d] += l[i * (Dim - 1) + j][mode] * t2[i][a] * t1[j][d];
          for (int a = 0; a < Dim; ++a)
            for (int d = 0; d < Dim; ++d) direction[a][d] *= root_weight * batch.inverse_side;
          for (int c = 0; c < n_corners<Dim>; ++c)
            for (int a = 0; a < Dim; ++a) {
              Pack s = points[q].dn[c][0] * direction[a][0];
              for (int d = 1; d < Dim; ++d) s += points[q].dn[c][d] * direction[a][d];
              v[c * Dim + a] = s;
            }
          add_square(v);
        }
      }
      for (int lane = 0; lane < members.n_elements; ++lane) {
        const auto e = static_cast<std::size_t>(members.element[lane]);
        auto& to = matrices_[e / autodiff::pack_size];
        for (int i = 0; i < n_packed; ++i) to[i].v[e % autodiff::pack_size] += static_cast<float>(k[i][lane]);
      }
    }
  });
}

template void EnergyHessian<2>::assemble_band(std::span<const Vec<2>>, const TermValues&);
template void EnergyHessian<3>::assemble_band(std::span<const Vec<3>>, const TermValues&);

}  // namespace shellmatch
