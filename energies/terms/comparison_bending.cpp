// The bending terms that the paper compares with.

#include "energies/assembly/band_kernel.h"

namespace shellmatch {

template <int Dim, bool WithGradient>
TermKernel<Dim> comparison_kernel(BendingModel model) {
  switch (model) {
    case BendingModel::no_p2:
      return &apply_term<BandFunctor<BendingWithoutP2<Dim>, Dim>, Dim, WithGradient>;
    case BendingModel::quadratic:
      return &apply_term<BandFunctor<QuadraticBending<Dim>, Dim>, Dim, WithGradient>;
    case BendingModel::thin_shell:
      break;
  }
  return nullptr;
}

template TermKernel<2> comparison_kernel<2, true>(BendingModel);
template TermKernel<2> comparison_kernel<2, false>(BendingModel);
template TermKernel<3> comparison_kernel<3, true>(BendingModel);
template TermKernel<3> comparison_kernel<3, false>(BendingModel);

}  // namespace shellmatch
