// Restraint of Newton's step in cells that it would fold.

#include "base/parallel.h"
#include "energies/element_batch.h"
#include "energies/energy_hessian.h"
#include "energies/fold_barrier.h"

#include <algorithm>

namespace shellmatch {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

/// Of the smallest Bernstein coefficient of det Dphi a step may use up so much that this share remains ...
constexpr double share_left = 0.2;
/// ... unless what remains is more than this.
constexpr double ample = 0.2;
/// Factor on a restraint that was not enough, and on all of them from one step to the next.
constexpr double growth = 8, decay = 0.25;

/// Integral over the unit cell of grad N_c . grad N_d.
template <int Dim>
std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>> laplacian() {
  std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>> k{};
  for (const auto& q : ShapeTable<Dim>(2).points)
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int d = 0; d < n_corners<Dim>; ++d)
        for (int p = 0; p < Dim; ++p) k[c][d] += q.weight * q.dn[c][p] * q.dn[d][p];
  return k;
}

/// Smallest Bernstein coefficient of det Dphi on each of eight elements.
template <int Dim>
[[gnu::noinline]] Pack least_coefficient(const std::array<Pack, n_corners<Dim> * Dim>& dofs, Pack inverse_volume) {
  const auto b = bernstein_determinant<Dim>(dofs.data());
  Pack least = b[0];
  for (const Pack& x : b) least = least < x ? least : x;
  return least * inverse_volume;
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::add_restraint(std::size_t element, double factor) {
  static const auto k = laplacian<Dim>();
  auto& to = matrices_[element / pack_size];
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int d = c; d < n_corners<Dim>; ++d)
      for (int a = 0; a < Dim; ++a)
        to[packed(c * Dim + a, d * Dim + a)].v[element % pack_size] += static_cast<float>(factor * k[c][d]);
}

template <int Dim>
void EnergyHessian<Dim>::keep_restraint() {
  restraint_.resize(unknowns_->elements().size());
  parallel_chunks(matrices_.size(), 512, [&](const Chunk& chunk) {
    for (std::size_t e = chunk.begin * pack_size; e < std::min(chunk.end * pack_size, restraint_.size()); ++e) {
      restraint_[e] *= static_cast<float>(decay);
      if (restraint_[e] > 0) add_restraint(e, restraint_[e]);
    }
  });
}

template <int Dim>
bool EnergyHessian<Dim>::restrain(std::span<const Vec<Dim>> phi, std::span<const double> d) {
  if (!folds_cost_) return false;
  static const double unit = [] {
    double trace = 0;
    for (int c = 0; c < n_corners<Dim>; ++c) trace += Dim * laplacian<Dim>()[c][c];
    return trace;
  }();
  unknowns_->expand(d, nodal_);
  const auto elements = unknowns_->elements();
  const int n_restrained = parallel_sum(matrices_.size(), 64, 0, [&](const Chunk& chunk) {
    int n_here = 0;
    ElementBatch<Dim> here, step;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const int n = static_cast<int>(std::min<std::size_t>(pack_size, elements.size() - b * pack_size));
      const auto member = [&](int lane) { return b * pack_size + static_cast<std::size_t>(std::min(lane, n - 1)); };
      here.load(elements, phi, member);
      step.load(elements, nodal_, member);
      for (int i = 0; i < n_dofs; ++i) step.u[i] += here.u[i];
      Pack inverse_volume = here.inverse_side;
      for (int k = 1; k < Dim; ++k) inverse_volume *= here.inverse_side;
      const Pack after = least_coefficient<Dim>(step.u, inverse_volume);
      if (std::none_of(&after[0], &after[0] + n, [](double x) { return x < ample; })) continue;
      const Pack before = least_coefficient<Dim>(here.u, inverse_volume);
      for (int lane = 0; lane < n; ++lane) {
        if (!(after[lane] < std::min(ample, share_left * before[lane]))) continue;
        const std::size_t e = member(lane);
        double trace = 0;
        for (int i = 0; i < n_dofs; ++i) trace += static_cast<double>(matrices_[b][packed(i, i)].v[lane]);
        // To begin with, as stiff as the element is already.
        const double next = std::max(growth * static_cast<double>(restraint_[e]), trace / unit);
        add_restraint(e, next - static_cast<double>(restraint_[e]));
        restraint_[e] = static_cast<float>(next);
        ++n_here;
      }
    }
    return n_here;
  });
  if (n_restrained > 0) assemble_blocks();
  return n_restrained > 0;
}

template void EnergyHessian<2>::add_restraint(std::size_t, double);
template void EnergyHessian<3>::add_restraint(std::size_t, double);
template void EnergyHessian<2>::keep_restraint();
template void EnergyHessian<3>::keep_restraint();
template bool EnergyHessian<2>::restrain(std::span<const Vec<2>>, std::span<const double>);
template bool EnergyHessian<3>::restrain(std::span<const Vec<3>>, std::span<const double>);

}  // namespace shellmatch
