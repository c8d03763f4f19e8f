// The fold margin of elements, and what keeps Newton's step from using it up: damping and contraction.

#include "base/parallel.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/elements/determinants.h"

#include <algorithm>

namespace shellmatch {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

/// A step may use up the smallest Bernstein coefficient of det Dphi until this share of it remains ...
constexpr double least_share = 0.2;
/// ... and does not count as beyond the margin where more than this remains.
constexpr double safe_determinant = 0.2;
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

/// Trace of the Laplacian's matrix for all components.
template <int Dim>
double laplacian_trace() {
  double trace = 0;
  for (int c = 0; c < n_corners<Dim>; ++c) trace += Dim * laplacian<Dim>()[c][c];
  return trace;
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::add_damping(const Chunk& cells, std::span<const float> damping,
                                     ElementMatrices<Dim>& matrices) const {
  if (damping.empty()) return;
  const auto& k = laplacian<Dim>();
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    if (damping[e] == 0) continue;
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int d = c; d < n_corners<Dim>; ++d)
        for (int a = 0; a < Dim; ++a)
          matrices.add(e - cells.begin, c * Dim + a, d * Dim + a,
                       static_cast<float>(static_cast<double>(damping[e]) * k[c][d]));
  }
}

template <int Dim>
void EnergyHessian<Dim>::measure_margins(const Chunk& cells, std::span<const Vec<Dim>> phi) {
  const auto elements = unknowns_->elements().first(cells.end);
  ElementBatch<Dim> batch;
  for (std::size_t first = cells.begin; first < cells.end; first += pack_size) {
    batch.load_run(elements, phi, first);
    margins_[first / pack_size] = {least_determinant(batch), batch.largest_entry()};
  }
}

template <int Dim>
std::vector<ElementDamping> EnergyHessian<Dim>::elements_beyond_margin(std::span<const Vec<Dim>> phi,
                                                                       std::span<const double> d) {
  if (!folds_cost_) return {};
  static const double unit = laplacian_trace<Dim>();
  std::vector<Vec<Dim>> nodal(phi.size(), Vec<Dim>::Zero());  // where nodes are fixed it stays 0
  unknowns_->expand(d, nodal);
  const auto elements = unknowns_->elements();
  const std::size_t n_batches = n_chunks(elements.size(), pack_size);
  std::vector<std::vector<ElementDamping>> of_chunk(n_chunks(n_batches, batches_per_chunk));
  parallel_chunks(n_batches, batches_per_chunk, [&](const Chunk& chunk) {
    ElementBatch<Dim> here, step;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const std::size_t first = b * pack_size;
      const auto n = static_cast<int>(step.load_run(elements, nodal, first));
      const Pack before = margins_[b].least_determinant;
      const Pack certain = before - determinant_change<Dim>(margins_[b].largest_entry, step.largest_entry());
      if (std::none_of(&certain[0], &certain[0] + n, [](double x) { return !(x >= safe_determinant); })) continue;
      here.load_run(elements, phi, first);
      for (int i = 0; i < n_dofs; ++i) step.u[i] += here.u[i];
      const Pack after = least_determinant(step);
      for (int lane = 0; lane < n; ++lane) {
        if (!(after[lane] < std::min(safe_determinant, least_share * before[lane]))) continue;
        const std::size_t e = first + static_cast<std::size_t>(lane);
        of_chunk[chunk.index].push_back({e, static_cast<double>(traces_[e]) / unit});
      }
    }
  });
  std::vector<ElementDamping> all;
  for (const auto& found : of_chunk) all.insert(all.end(), found.begin(), found.end());
  return all;
}

template <int Dim>
void EnergyHessian<Dim>::add_damping(std::span<const ElementDamping> more) {
  const auto& k = laplacian<Dim>();
  const auto of_corners = [&](int c, int d) { return k[c][d]; };
  for (const ElementDamping& one : more)
    sum_->add_to_element(one.element, of_corners, one.factor * Mat<Dim>::Identity());
  for (const ElementDamping& one : more) invert_blocks_of(one.element);
}

template <int Dim>
void EnergyHessian<Dim>::contract_step(std::span<const ElementDamping> elements, double share,
                                       std::span<double> d) const {
  std::vector<Index> moved;  // the element's unknown nodes
  for (const ElementDamping& one : elements) {
    moved.clear();
    bool is_fixed = false;
    for (const Index node : unknowns_->elements()[one.element].nodes) {
      const auto entries = unknowns_->constraint_entries(node);
      is_fixed |= entries.empty();
      for (const ConstraintEntry& entry : entries)
        if (std::ranges::find(moved, entry.unknown) == moved.end()) moved.push_back(entry.unknown);
    }
    Vec<Dim> mean = Vec<Dim>::Zero();
    const auto of = [&](Index unknown) { return Eigen::Map<Vec<Dim>>(d.data() + unknown * Dim); };
    if (!is_fixed) {
      for (const Index unknown : moved) mean += of(unknown);
      mean /= static_cast<double>(moved.size());
    }
    for (const Index unknown : moved) of(unknown) = mean + share * (of(unknown) - mean);
  }
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                 \
  template void EnergyHessian<Dim>::add_damping(const Chunk&, std::span<const float>, ElementMatrices<Dim>&) const; \
  template void EnergyHessian<Dim>::measure_margins(const Chunk&, std::span<const Vec<Dim>>);                       \
  template std::vector<ElementDamping> EnergyHessian<Dim>::elements_beyond_margin(std::span<const Vec<Dim>>,        \
                                                                                  std::span<const double>);         \
  template void EnergyHessian<Dim>::add_damping(std::span<const ElementDamping>);                                   \
  template void EnergyHessian<Dim>::contract_step(std::span<const ElementDamping>, double, std::span<double>) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
