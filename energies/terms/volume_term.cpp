// The volume term on eight elements.

#include "energies/autodiff/compiled.h"
#include "energies/assembly/cell_terms.h"
#include "energies/terms/integrands.h"

namespace shellmatch {

namespace {

using autodiff::Pack;

template <class Density, int Dim, bool WithGradient>
Pack volume_term(CellBatch<Dim>& batch, const ShapeTable<Dim>& shape, const EnergyOptions& options,
                 const Pack& measure) {
  using Code = autodiff::Compiled<VolumeFunctor<Density, Dim>>;
  const std::array<Pack, 2> passive = {Pack{} + options.lambda, Pack{} + options.mu};
  std::array<Pack, Dim * Dim> dphi, adjoint;
  Pack sum{};
  batch.evaluator.evaluate(batch.elements);
  if constexpr (WithGradient) batch.evaluator.clear_adjoint();
  for (std::size_t q = 0; q < shape.points.size(); ++q) {
    batch.evaluator.jacobian(q, dphi.data());
    const Pack seed = measure * shape.points[q].weight;
    if constexpr (WithGradient) {
      sum += seed * Code::gradient(dphi.data(), passive.data(), seed, adjoint.data());
      batch.evaluator.add_by_jacobian(q, adjoint.data());
    } else {
      sum += seed * Code::value(dphi.data(), passive.data());
    }
  }
  if constexpr (WithGradient) batch.evaluator.add_to_gradient(batch.elements);
  return sum;
}

}  // namespace

template <int Dim, bool WithGradient>
CellKernel<Dim> volume_kernel(VolumeDensity density) {
  switch (density) {
    case VolumeDensity::full: return volume_term<FullVolume<Dim>, Dim, WithGradient>;
    case VolumeDensity::symmetric_dirichlet: return volume_term<SymmetricDirichletVolume<Dim>, Dim, WithGradient>;
    case VolumeDensity::simplified: break;
  }
  return volume_term<SimplifiedVolume<Dim>, Dim, WithGradient>;
}

template CellKernel<2> volume_kernel<2, false>(VolumeDensity);
template CellKernel<2> volume_kernel<2, true>(VolumeDensity);
template CellKernel<3> volume_kernel<3, false>(VolumeDensity);
template CellKernel<3> volume_kernel<3, true>(VolumeDensity);

}  // namespace shellmatch
