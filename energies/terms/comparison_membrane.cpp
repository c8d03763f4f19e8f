// The membrane terms that the paper compares with.

#include "energies/assembly/band_kernel.h"

namespace shellmatch {

template <int Dim, bool WithGradient>
TermKernel<Dim> comparison_kernel(MembraneModel model) {
  switch (model) {
    case MembraneModel::no_p2:
      return &apply_term<BandFunctor<MembraneWithoutP2<Dim>, Dim>, Dim, WithGradient>;
    case MembraneModel::cauchy_green:
      return &apply_term<BandFunctor<CauchyGreenMembrane<Dim>, Dim>, Dim, WithGradient>;
    case MembraneModel::thin_shell:
      break;
  }
  return nullptr;
}

template TermKernel<2> comparison_kernel<2, true>(MembraneModel);
template TermKernel<2> comparison_kernel<2, false>(MembraneModel);
template TermKernel<3> comparison_kernel<3, true>(MembraneModel);
template TermKernel<3> comparison_kernel<3, false>(MembraneModel);

}  // namespace shellmatch
