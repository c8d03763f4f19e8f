#include "energies/energy_hessian.h"

#include "base/parallel.h"
#include "energies/element_batch.h"

#include <Eigen/LU>

#include <cstring>

namespace shellmatch {

using autodiff::Pack;
using autodiff::pack_size;

namespace {

Pack widened(const float* lanes) {
  using FloatPack = float __attribute__((vector_size(sizeof(float) * pack_size)));
  FloatPack f;
  std::memcpy(&f, lanes, sizeof f);
  return __builtin_convertvector(f, Pack);
}

}  // namespace

template <int Dim>
EnergyHessian<Dim>::EnergyHessian(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                  const TargetField<Dim>& target, const EnergyOptions& options)
    : energy_(&energy), unknowns_(&unknowns), target_(&target), options_(options) {}

template <int Dim>
void EnergyHessian<Dim>::assemble(std::span<const Vec<Dim>> phi, const TermValues& weights) {
  matrices_.resize((unknowns_->elements().size() + pack_size - 1) / pack_size);
  nodal_.assign(phi.size(), Vec<Dim>::Zero());
  element_products_.resize(unknowns_->elements().size() * n_dofs);
  assemble_volume(phi, weights[Term::volume]);
  if (weights[Term::barrier] > 0) assemble_barrier(phi, weights[Term::barrier]);
  assemble_band(phi, weights);
  folds_cost_ = weights[Term::barrier] > 0 || (options_.volume == VolumeDensity::full && weights[Term::volume] > 0);
  keep_restraint();
  assemble_blocks();
}

template <int Dim>
void EnergyHessian<Dim>::apply(std::span<const double> x, std::span<double> y) const {
  unknowns_->expand(x, nodal_);
  const auto elements = unknowns_->elements();
  parallel_chunks(matrices_.size(), 64, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const int n = static_cast<int>(std::min<std::size_t>(pack_size, elements.size() - b * pack_size));
      batch.load(elements, nodal_, [&](int lane) { return b * pack_size + static_cast<std::size_t>(std::min(lane, n - 1)); });
      batch.clear_gradient();
      const Lanes* k = matrices_[b].data();
      for (int i = 0; i < n_dofs; ++i) {
        const Pack xi = batch.u[i];
        Pack yi = batch.gradient[i] + widened((k++)->v) * xi;
        for (int j = i + 1; j < n_dofs; ++j) {
          const Pack kij = widened((k++)->v);
          yi += kij * batch.u[j];
          batch.gradient[j] += kij * xi;
        }
        batch.gradient[i] = yi;
      }
      for (int lane = 0; lane < n; ++lane) {
        double* out = element_products_.data() + (b * pack_size + static_cast<std::size_t>(lane)) * n_dofs;
        for (int i = 0; i < n_dofs; ++i) out[i] = batch.gradient[i][lane];
      }
    }
  });
  unknowns_->sum_elements(element_products_, y);
}

template <int Dim>
void EnergyHessian<Dim>::assemble_blocks() {
  // The diagonal blocks, component by component, with the same sum that gradients use. A node that hangs in
  // an element counts there with its weight once, not squared: too large a block is harmless, and where two of a
  // node's children share an element their product would be missing otherwise.
  const std::size_t n_nodes = unknowns_->nodes().size();
  inverse_blocks_.assign(n_nodes, Mat<Dim>::Zero());
  std::vector<double> column(n_nodes * Dim);
  const std::size_t n_elements = unknowns_->elements().size();
  for (int l = 0; l < Dim; ++l) {
    parallel_for(n_elements, [&](std::size_t e) {
      double* out = element_products_.data() + e * n_dofs;
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int k = 0; k < Dim; ++k) {
          const int i = c * Dim + std::min(k, l), j = c * Dim + std::max(k, l);
          out[c * Dim + k] = static_cast<double>(matrices_[e / pack_size][packed(i, j)].v[e % pack_size]);
        }
    });
    unknowns_->sum_elements(element_products_, column);
    parallel_for(n_nodes, [&](std::size_t i) {
      for (int k = 0; k < Dim; ++k) inverse_blocks_[i](k, l) = column[i * Dim + k];
    });
  }
  parallel_for(n_nodes, [&](std::size_t i) {
    Mat<Dim> block = inverse_blocks_[i];
    block.diagonal().array() += 1e-6 * block.trace() + 1e-300;
    inverse_blocks_[i] = block.inverse();
  });
}

template <int Dim>
void EnergyHessian<Dim>::precondition(std::span<const double> r, std::span<double> z) const {
  parallel_for(inverse_blocks_.size(), [&](std::size_t i) {
    Vec<Dim> v;
    for (int k = 0; k < Dim; ++k) v[k] = r[i * Dim + k];
    v = (inverse_blocks_[i] * v).eval();
    for (int k = 0; k < Dim; ++k) z[i * Dim + k] = v[k];
  }, 8192);
}

template class EnergyHessian<2>;
template class EnergyHessian<3>;

}  // namespace shellmatch
