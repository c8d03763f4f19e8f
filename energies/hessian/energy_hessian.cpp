#include "energies/hessian/energy_hessian.h"

#include "base/error.h"
#include "base/parallel.h"
#include "energies/hessian/band_variables.h"

#include <Eigen/LU>

namespace shellmatch {

template <int Dim>
EnergyHessian<Dim>::EnergyHessian(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns)
    : energy_(&energy), unknowns_(&unknowns) {}

template <int Dim>
void EnergyHessian<Dim>::assemble(std::span<const Vec<Dim>> phi, const TermValues& weights,
                                  std::span<const float> damping) {
  const std::size_t n = unknowns_->elements().size();
  SHELLMATCH_CHECK(damping.empty() || damping.size() == n, "one damping factor for each element");
  traces_.resize(n);
  margins_.resize(n_chunks(n, autodiff::pack_size));
  folds_cost_ = energy_->terms().forbid_folds(weights);
  const bool in_tangent = energy_->terms().fit_tangent(weights);
  if (!sum_) sum_.emplace(*unknowns_);
  is_active_.clear();
  energy_->cell_blocks().for_each([&](const Chunk& cells) {
    static thread_local ElementMatrices<Dim> matrices;
    matrices.resize(cells.end - cells.begin);
    measure_margins(cells, phi);
    set_cell_terms(cells, phi, weights, matrices);
    add_corner_terms(cells, phi, weights, matrices);
    if (in_tangent) add_band_terms<TangentVariables<Dim>>(cells, phi, weights, matrices);
    else add_band_terms<AllVariables<Dim>>(cells, phi, weights, matrices);
    add_point_terms(cells, phi, weights, matrices);
    for (std::size_t e = cells.begin; e < cells.end; ++e) traces_[e] = matrices.trace(e - cells.begin);
    add_damping(cells, damping, matrices);
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
  block.diagonal().array() += 1e-6 * block.trace() + 1e-30;
  inverse_blocks_[unknown] = block.inverse().template cast<float>();
}

template <int Dim>
void EnergyHessian<Dim>::invert_blocks_of(std::size_t element) {
  for (const Index node : unknowns_->elements()[element].nodes)
    for (const ConstraintEntry& entry : unknowns_->constraint_entries(node))
      invert_block(static_cast<std::size_t>(entry.unknown));
}

template <int Dim>
void EnergyHessian<Dim>::precondition(std::span<const double> r, std::span<double> z) const {
  parallel_for(
      inverse_blocks_.size(),
      [&](std::size_t i) {
        Vec<Dim> v;
        for (int k = 0; k < Dim; ++k) v[k] = r[i * Dim + k];
        v = (inverse_blocks_[i].template cast<double>() * v).eval();
        for (int k = 0; k < Dim; ++k) z[i * Dim + k] = v[k];
      },
      8192);
}

template class EnergyHessian<2>;
template class EnergyHessian<3>;

}  // namespace shellmatch
