// Second derivatives of the band terms, eight elements at a time.

#include "energies/elements/sum_factorised_evaluator.h"
#include "energies/assembly/energy_hessian.h"
#include "energies/densities/tangent_hessian.h"

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

/// Rows: entries of the argument of W. Columns: entries of X, then components of phi.
template <int Dim>
using Jacobian = std::array<std::array<Pack, (Dim - 1) * (Dim - 1) + Dim>, (Dim - 1) * (Dim - 1)>;

/// h += factor j^T w j
template <int Dim>
void add_congruent(double factor, const SquarePack<(Dim - 1) * (Dim - 1)>& w, const Jacobian<Dim>& j,
                   SquarePack<(Dim - 1) * (Dim - 1) + Dim>& h) {
  constexpr int m = (Dim - 1) * (Dim - 1), n = m + Dim;
  Jacobian<Dim> wj{};
  for (int e = 0; e < m; ++e)
    for (int f = 0; f < m; ++f)
      for (int v = 0; v < n; ++v) wj[e][v] += w[e][f] * j[f][v];
  for (int u = 0; u < n; ++u)
    for (int v = u; v < n; ++v) {
      Pack sum{};
      for (int e = 0; e < m; ++e) sum += j[e][u] * wj[e][v];
      h[u][v] += factor * sum;
      if (u != v) h[v][u] += factor * sum;
    }
}

/// What the template and the deformation give at eight points.
template <int Dim>
struct PointGeometry {
  std::array<Pack, Dim> gradient2;  ///< of d2 at phi
  std::array<Pack, Dim> n2;
  std::array<Pack, n_symmetric<Dim>> root;
  // By the coordinates of phi; the first not normalised, its component along n2 is of no use.
  std::array<std::array<Pack, Dim>, Dim> n2_derivative;
  std::array<std::array<Pack, n_symmetric<Dim>>, Dim> root_derivative;
};

template <int Dim>
PointGeometry<Dim> geometry_at(const GeometryField<Dim>& target, const Pack& weight,
                               const std::array<Pack, Dim>& y) {
  constexpr int n_values = GeometryField<Dim>::n_values;
  std::array<Pack, n_values> values;
  std::array<std::array<Pack, n_values>, Dim> derivative;
  target.look_up(weight, target.find(y), values.data(), derivative);
  PointGeometry<Dim> g;
  Pack square{};
  for (int k = 0; k < Dim; ++k) square += values[1 + k] * values[1 + k];
  const Pack length = autodiff::root_of(square);
  const Pack divisor = autodiff::max_of(length, Pack{} + 1e-2);
  for (int k = 0; k < Dim; ++k) {
    g.gradient2[k] = derivative[k][0];
    // Where there is no normal any unit vector does.
    g.n2[k] = length > 1e-9 ? values[1 + k] / length : Pack{} + (k == 0 ? 1.0 : 0.0);
    for (int a = 0; a < Dim; ++a) g.n2_derivative[a][k] = derivative[a][1 + k] / divisor;
  }
  for (int i = 0; i < n_symmetric<Dim>; ++i) {
    g.root[i] = values[1 + Dim + i];
    for (int a = 0; a < Dim; ++a) g.root_derivative[a][i] = derivative[a][1 + Dim + i];
  }
  return g;
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::add_band(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                  ElementMatrices<Dim>& matrices) const {
  constexpr int m = (Dim - 1) * (Dim - 1), n_variables = m + Dim, n_packed = ElementMatrices<Dim>::n_packed;
  const auto elements = unknowns_->elements();
  const Band<Dim>& band = energy_->band();
  const auto& points = energy_->shape().points;
  const Lame<double> lame{options_.lambda, options_.mu};

  ElementBatch<Dim> batch;
  SumFactorisedEvaluator<Dim> evaluator(energy_->shape());
  std::array<Pack, n_packed> k;
  std::array<std::array<Pack, n_variables>, n_dofs> modes;
  const auto [first, last] = band.batches_of(cells.index);
  for (std::size_t b = first; b < last; ++b) {
    const auto& members = band.batches()[b];
    batch.load(elements, phi, [&](int lane) { return members.element[lane]; });
    if (b + 1 < last) batch.prefetch(elements, phi, [&](int lane) { return band.batches()[b + 1].element[lane]; });
    evaluator.evaluate(batch);
    k.fill(Pack{});
    for (std::size_t q = 0; q < points.size(); ++q) {
      const auto& point = band.point(b, q);
      if (autodiff::sum_lanes(point.weight) == 0) continue;
      std::array<Pack, Dim * Dim> dphi;
      evaluator.jacobian(q, dphi.data());
      const auto g = geometry_at<Dim>(*target_, point.weight, evaluator.position(q));
      // X = t2^T Dphi t1; membrane: W of X; bending: W of N X R, N and R the roots in the frames.
      std::array<Pack, Dim> n1;
      for (int a = 0; a < Dim; ++a) n1[a] = point.reference[1 + a];
      const auto t1 = tangent_basis<Dim>(n1), t2 = tangent_basis<Dim>(g.n2);
      const auto x = in_frames<Dim>(
          t2, [&](int i, int j) { return dphi[i * Dim + j]; }, t1);
      const auto n = in_frames<Dim>(
          t2, [&](int i, int j) { return g.root[SmallSym<double, Dim>::slot(i, j)]; }, t2);
      const auto r = in_frames<Dim>(
          t1, [&](int i, int j) { return point.reference[1 + Dim + SmallSym<double, Dim>::slot(i, j)]; },
          t1);
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
      // The second derivative by X and phi together: J^T W'' J with J of the whole chain.
      SquarePack<n_variables> h{};
      for (int a = 0; a < Dim; ++a)
        for (int c = 0; c < Dim; ++c)
          h[m + a][m + c] = 2.0 * weights[Term::match] * g.gradient2[a] * g.gradient2[c];
      Jacobian<Dim> by_x{};
      for (int e = 0; e < m; ++e) by_x[e][e] = Pack{} + 1.0;
      std::array<std::array<Pack, Dim>, Dim - 1> turn{};  // t2_i . dn2/dphi_a
      for (int i = 0; i < Dim - 1; ++i)
        for (int a = 0; a < Dim; ++a)
          for (int d = 0; d < Dim; ++d) turn[i][a] += t2[i][d] * g.n2_derivative[a][d];
      for (int j = 0; j < Dim - 1; ++j) {
        Pack leaning{};  // n2 . Dphi t1_j
        for (int c = 0; c < Dim; ++c)
          for (int d = 0; d < Dim; ++d) leaning += g.n2[c] * dphi[c * Dim + d] * t1[j][d];
        for (int i = 0; i < Dim - 1; ++i)
          for (int a = 0; a < Dim; ++a) by_x[i * (Dim - 1) + j][m + a] = -turn[i][a] * leaning;
      }
      if (weights[Term::membrane] > 0)
        add_congruent<Dim>(weights[Term::membrane], tangent_hessian<Dim>(flat, lame), by_x, h);
      if (weights[Term::bending] > 0) {
        std::array<Pack, Dim - 1> across{};  // t2_i . N n2
        for (int i = 0; i < Dim - 1; ++i)
          for (int c = 0; c < Dim; ++c)
            for (int d = 0; d < Dim; ++d)
              across[i] += t2[i][c] * g.root[SmallSym<double, Dim>::slot(c, d)] * g.n2[d];
        // d(N X R): N dX R, entry (i j) by (s t) N_is R_tj, and dN X R.
        Jacobian<Dim> by_root{};
        for (int e = 0; e < m; ++e)
          for (int f = 0; f < m; ++f) {
            const Pack chain = n[e / (Dim - 1)][f / (Dim - 1)] * r[f % (Dim - 1)][e % (Dim - 1)];
            for (int u = 0; u < n_variables; ++u) by_root[e][u] += chain * by_x[f][u];
          }
        for (int a = 0; a < Dim; ++a) {
          auto dn = in_frames<Dim>(
              t2, [&](int i, int j) { return g.root_derivative[a][SmallSym<double, Dim>::slot(i, j)]; },
              t2);
          for (int i = 0; i < Dim - 1; ++i)
            for (int j = 0; j < Dim - 1; ++j) dn[i][j] -= turn[i][a] * across[j] + across[i] * turn[j][a];
          for (int i = 0; i < Dim - 1; ++i)
            for (int j = 0; j < Dim - 1; ++j)
              for (int s = 0; s < Dim - 1; ++s)
                for (int t = 0; t < Dim - 1; ++t)
                  by_root[i * (Dim - 1) + j][m + a] += dn[i][s] * x[s][t] * r[t][j];
        }
        add_congruent<Dim>(weights[Term::bending], tangent_hessian<Dim>(bent, lame), by_root, h);
      }
      for (int i = 0; i < n_variables; ++i)
        for (int j = 0; j < n_variables; ++j)
          h[i][j] = point.weight > 0 ? h[i][j] : Pack{} + (i == j ? 1.0 : 0.0);
      const auto l = cholesky<n_variables>(h);
      const Pack root_weight = autodiff::root_of(point.weight);
      for (int mode = 0; mode < n_variables; ++mode) {
        // Component a of corner c moves X_ij by t2_i[a] (grad N_c . t1_j), and phi_a by N_c.
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
            Pack s = points[q].n[c] * root_weight * l[m + a][mode];
            for (int d = 0; d < Dim; ++d) s += points[q].dn[c][d] * direction[a][d];
            modes[c * Dim + a][mode] = s;
          }
      }
      // All modes of a point at once: the sums are read and written once, which is what this loop's time
      // is.
      int at = 0;
      for (int i = 0; i < n_dofs; ++i) {
        const auto row = modes[i];
        for (int j = i; j < n_dofs; ++j) {
          Pack sum = k[at];
          for (int mode = 0; mode < n_variables; ++mode) sum += row[mode] * modes[j][mode];
          k[at++] = sum;
        }
      }
    }
    for (int lane = 0; lane < members.n_elements; ++lane) {
      std::array<float, n_packed> of_element;
      for (int i = 0; i < n_packed; ++i) of_element[i] = static_cast<float>(k[i][lane]);
      matrices.add(static_cast<std::size_t>(members.element[lane]) - cells.begin, of_element);
    }
  }
}

template void EnergyHessian<2>::add_band(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                         ElementMatrices<2>&) const;
template void EnergyHessian<3>::add_band(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                         ElementMatrices<3>&) const;

}  // namespace shellmatch
