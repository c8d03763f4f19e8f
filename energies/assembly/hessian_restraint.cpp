// Restraint of Newton's step in cells that it would fold.

#include "base/parallel.h"
#include "energies/elements/element_batch.h"
#include "energies/assembly/energy_hessian.h"

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
constexpr std::size_t batches_per_chunk = 64;

/// Integral over the unit cell of grad N_c . grad N_d.
template <int Dim>
const std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>>& laplacian() {
  static const auto k = [] {
    std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>> sum{};
    for (const auto& q : ShapeTable<Dim>(2).points)
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int d = 0; d < n_corners<Dim>; ++d)
          for (int p = 0; p < Dim; ++p) sum[c][d] += q.weight * q.dn[c][p] * q.dn[d][p];
    return sum;
  }();
  return k;
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::add_kept_restraint(const Chunk& cells, ElementMatrices<Dim>& matrices) {
  const auto& k = laplacian<Dim>();
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    restraint_[e] *= static_cast<float>(decay);
    if (restraint_[e] == 0) continue;
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int d = c; d < n_corners<Dim>; ++d)
        for (int a = 0; a < Dim; ++a)
          matrices.add(e - cells.begin, c * Dim + a, d * Dim + a,
                       static_cast<float>(static_cast<double>(restraint_[e]) * k[c][d]));
  }
}

template <int Dim>
void EnergyHessian<Dim>::measure_room(const Chunk& cells, std::span<const Vec<Dim>> phi) {
  const auto elements = unknowns_->elements().first(cells.end);
  ElementBatch<Dim> batch;
  for (std::size_t first = cells.begin; first < cells.end; first += pack_size) {
    batch.load_run(elements, phi, first);
    room_[first / pack_size] = {least_determinant(batch), batch.largest_entry()};
  }
}

template <int Dim>
bool EnergyHessian<Dim>::restrain(std::span<const Vec<Dim>> phi, std::span<const double> d) {
  if (!folds_cost_) return false;
  static const double unit = [] {
    double trace = 0;
    for (int c = 0; c < n_corners<Dim>; ++c) trace += Dim * laplacian<Dim>()[c][c];
    return trace;
  }();
  nodal_.resize(phi.size(), Vec<Dim>::Zero());  // where nodes are fixed it stays 0
  unknowns_->expand(d, nodal_);
  const auto elements = unknowns_->elements();
  struct Found {
    std::size_t element;
    double more;
  };
  const std::size_t n_batches = n_chunks(elements.size(), pack_size);
  std::vector<std::vector<Found>> of_chunk(n_chunks(n_batches, batches_per_chunk));
  parallel_chunks(n_batches, batches_per_chunk, [&](const Chunk& chunk) {
    ElementBatch<Dim> here, step;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const std::size_t first = b * pack_size;
      const auto n = static_cast<int>(step.load_run(elements, nodal_, first));
      const Pack before = room_[b].least_determinant;
      const Pack certain = before - determinant_change<Dim>(room_[b].largest_entry, step.largest_entry());
      if (std::none_of(&certain[0], &certain[0] + n, [](double x) { return !(x >= ample); })) continue;
      here.load_run(elements, phi, first);
      for (int i = 0; i < n_dofs; ++i) step.u[i] += here.u[i];
      const Pack after = least_determinant(step);
      for (int lane = 0; lane < n; ++lane) {
        if (!(after[lane] < std::min(ample, share_left * before[lane]))) continue;
        const std::size_t e = first + static_cast<std::size_t>(lane);
        // To begin with, as stiff as the element is already.
        const double next = std::max(growth * static_cast<double>(restraint_[e]), static_cast<double>(traces_[e]) / unit);
        of_chunk[chunk.index].push_back({e, next - static_cast<double>(restraint_[e])});
        restraint_[e] = static_cast<float>(next);
      }
    }
  });
  bool any = false;
  for (const auto& chunk : of_chunk)
    for (const Found& found : chunk) {
      sum_->add_isotropic(found.element, found.more, laplacian<Dim>());
      any = true;
    }
  for (const auto& chunk : of_chunk)
    for (const Found& found : chunk)
      for (const Index node : elements[found.element].nodes)
        for (const ConstraintEntry& entry : unknowns_->constraint_entries(node))
          invert_block(static_cast<std::size_t>(entry.unknown));
  return any;
}

template void EnergyHessian<2>::measure_room(const Chunk&, std::span<const Vec<2>>);
template void EnergyHessian<3>::measure_room(const Chunk&, std::span<const Vec<3>>);
template void EnergyHessian<2>::add_kept_restraint(const Chunk&, ElementMatrices<2>&);
template void EnergyHessian<3>::add_kept_restraint(const Chunk&, ElementMatrices<3>&);
template bool EnergyHessian<2>::restrain(std::span<const Vec<2>>, std::span<const double>);
template bool EnergyHessian<3>::restrain(std::span<const Vec<3>>, std::span<const double>);

}  // namespace shellmatch
