#include "energies/assembly/energy_hessian.h"

#include "base/parallel.h"

#include <Eigen/LU>

namespace shellmatch {

template <int Dim>
EnergyHessian<Dim>::EnergyHessian(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                  const GeometryField<Dim>& target, const EnergyOptions& options)
    : energy_(&energy), unknowns_(&unknowns), target_(&target), options_(options) {}

template <int Dim>
void EnergyHessian<Dim>::assemble(std::span<const Vec<Dim>> phi, const TermValues& weights) {
  const std::size_t n = unknowns_->elements().size();
  traces_.resize(n);
  restraint_.resize(n);
  room_.resize(n_chunks(n, autodiff::pack_size));
  folds_cost_ =
      weights[Term::barrier] > 0 || (options_.volume == VolumeDensity::full && weights[Term::volume] > 0);
  if (!sum_) sum_.emplace(*unknowns_);
  energy_->cell_blocks().for_each([&](const Chunk& cells) {
    static thread_local ElementMatrices<Dim> matrices;
    matrices.resize(cells.end - cells.begin);
    measure_room(cells, phi);
    set_volume(cells, phi, weights[Term::volume], matrices);
    if (weights[Term::barrier] > 0) add_barrier(cells, phi, weights[Term::barrier], matrices);
    add_band(cells, phi, weights, matrices);
    for (std::size_t e = cells.begin; e < cells.end; ++e) traces_[e] = matrices.trace(e - cells.begin);
    add_kept_restraint(cells, matrices);
    sum_->add(energy_->cell_blocks(), cells, matrices);
  });
  inverse_blocks_.resize(unknowns_->nodes().size());
  parallel_for(inverse_blocks_.size(), [&](std::size_t i) { invert_block(i); });
}

template <int Dim>
void EnergyHessian<Dim>::apply(std::span<const double> x, std::span<double> y) const {
  sum_->multiply(x, y);
}

template <int Dim>
void EnergyHessian<Dim>::invert_block(std::size_t unknown) {
  Mat<Dim> block = sum_->diagonal(unknown);
  block.diagonal().array() += 1e-6 * block.trace() + 1e-300;
  inverse_blocks_[unknown] = block.inverse();
}

template <int Dim>
void EnergyHessian<Dim>::precondition(std::span<const double> r, std::span<double> z) const {
  parallel_for(
      inverse_blocks_.size(),
      [&](std::size_t i) {
        Vec<Dim> v;
        for (int k = 0; k < Dim; ++k) v[k] = r[i * Dim + k];
        v = (inverse_blocks_[i] * v).eval();
        for (int k = 0; k < Dim; ++k) z[i * Dim + k] = v[k];
      },
      8192);
}

template class EnergyHessian<2>;
template class EnergyHessian<3>;

}  // namespace shellmatch
