// Second derivatives of the volume term and of the barrier.

#include "energies/elements/element_batch.h"
#include "energies/assembly/energy_hessian.h"
#include "energies/terms/fold_barrier.h"
#include "energies/densities/stretch_hessian.h"

#include <cmath>

namespace shellmatch {

using autodiff::Pack;
using autodiff::pack_size;

namespace {

/// Integral over the unit cell of dN_c/dxi_a dN_d/dxi_b, entry [c * Dim + a][d * Dim + b].
template <int Dim>
std::array<std::array<double, n_corners<Dim> * Dim>, n_corners<Dim> * Dim> gradient_products() {
  std::array<std::array<double, n_corners<Dim> * Dim>, n_corners<Dim> * Dim> g{};
  for (const auto& q : ShapeTable<Dim>(2).points)  // exact: the integrand is of degree 2 in each variable
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int a = 0; a < Dim; ++a)
        for (int d = 0; d < n_corners<Dim>; ++d)
          for (int b = 0; b < Dim; ++b) g[c * Dim + a][d * Dim + b] += q.weight * q.dn[c][a] * q.dn[d][b];
  return g;
}

/// Dphi at the centre of an element.
template <int Dim>
Mat<Dim> centre_jacobian(const Element<Dim>& element, std::span<const Vec<Dim>> phi) {
  Mat<Dim> j = Mat<Dim>::Zero();
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0; k < Dim; ++k)
      j.col(k) += ((c >> k) & 1 ? 1.0 : -1.0) * phi[element.nodes[c]] / (element.side * (1 << (Dim - 1)));
  return j;
}

template <int Dim>
autodiff::SecondOrder<Dim, Pack> density_of_stretches(const std::array<Pack, Dim>& s,
                                                      const EnergyOptions& options) {
  const Lame<double> lame{options.lambda, options.mu};
  switch (options.volume) {
    case VolumeDensity::full:
      return density_of_stretches<FullVolume<Dim>, Dim>(s, lame);
    case VolumeDensity::symmetric_dirichlet:
      return density_of_stretches<SymmetricDirichletVolume<Dim>, Dim>(s, lame);
    case VolumeDensity::simplified:
      break;
  }
  return density_of_stretches<SimplifiedVolume<Dim>, Dim>(s, lame);
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::set_volume(const Chunk& cells, std::span<const Vec<Dim>> phi, double weight,
                                    ElementMatrices<Dim>& matrices) const {
  static const auto products = gradient_products<Dim>();
  const auto elements = unknowns_->elements().subspan(cells.begin, cells.end - cells.begin);
  std::array<Pack, Dim * Dim * Dim * Dim> h;
  for (std::size_t first = 0; first < elements.size(); first += pack_size) {
    h.fill(Pack{});
    const int n = static_cast<int>(std::min<std::size_t>(pack_size, elements.size() - first));
    std::array<Stretches<Dim>, pack_size> stretches;
    std::array<Pack, Dim> s;
    for (int lane = 0; lane < pack_size; ++lane) {
      const auto& element = elements[first + static_cast<std::size_t>(std::min(lane, n - 1))];
      stretches[lane] = principal_stretches<Dim>(centre_jacobian<Dim>(element, phi));
      for (int k = 0; k < Dim; ++k) s[k][lane] = stretches[lane].s[k];
    }
    const auto psi = density_of_stretches<Dim>(s, options_);
    for (int lane = 0; lane < n; ++lane) {
      // The gradients of the shape functions bring side^-2, the volume side^Dim.
      const double scale = weight * std::pow(elements[first + static_cast<std::size_t>(lane)].side, Dim - 2);
      const auto m = projected_hessian<Dim>(stretches[lane], psi, lane);
      for (int i = 0; i < Dim * Dim; ++i)
        for (int j = 0; j < Dim * Dim; ++j) h[i * Dim * Dim + j][lane] = scale * m(i, j);
    }
    for (int i = 0; i < n_dofs; ++i)
      for (int j = i; j < n_dofs; ++j) {
        const int k = i % Dim, l = j % Dim, c = i / Dim, d = j / Dim;
        Pack sum{};
        for (int p = 0; p < Dim; ++p)
          for (int q = 0; q < Dim; ++q)
            sum += products[c * Dim + p][d * Dim + q] * h[(k * Dim + p) * Dim * Dim + l * Dim + q];
        for (int lane = 0; lane < n; ++lane)
          matrices.set(first + static_cast<std::size_t>(lane), i, j, static_cast<float>(sum[lane]));
      }
  }
}

template <int Dim>
void EnergyHessian<Dim>::add_barrier(const Chunk& cells, std::span<const Vec<Dim>> phi, double weight,
                                     ElementMatrices<Dim>& matrices) const {
  const auto elements = unknowns_->elements();
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    if (room_[e / pack_size].least_determinant[e % pack_size] >= options_.fold_threshold) continue;
    using Jet = ceres::Jet<double, n_dofs>;
    std::array<Jet, n_dofs> jets;
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int k = 0; k < Dim; ++k) jets[c * Dim + k] = Jet(phi[elements[e].nodes[c]][k], c * Dim + k);
    const double volume = std::pow(elements[e].side, Dim);
    const double limit = options_.fold_threshold * volume;
    for (const Jet& determinant : bernstein_determinant<Dim>(jets.data())) {
      const double t = determinant.a / limit;
      if (t >= 1) continue;
      // B(t) = (1-t)^3/t, B''(t) = 2 (1/t^3 - 1) > 0
      const double curvature = weight * volume / n_bernstein_total<Dim> * 2 * (1 / (t * t * t) - 1);
      const Eigen::Matrix<double, n_dofs, 1> g = determinant.v / limit;
      for (int i = 0; i < n_dofs; ++i)
        for (int j = i; j < n_dofs; ++j)
          matrices.add(e - cells.begin, i, j, static_cast<float>(curvature * g[i] * g[j]));
    }
  }
}

template void EnergyHessian<2>::set_volume(const Chunk&, std::span<const Vec<2>>, double, ElementMatrices<2>&) const;
template void EnergyHessian<2>::add_barrier(const Chunk&, std::span<const Vec<2>>, double, ElementMatrices<2>&) const;
template void EnergyHessian<3>::set_volume(const Chunk&, std::span<const Vec<3>>, double, ElementMatrices<3>&) const;
template void EnergyHessian<3>::add_barrier(const Chunk&, std::span<const Vec<3>>, double, ElementMatrices<3>&) const;

}  // namespace shellmatch
