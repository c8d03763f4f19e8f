#include "matching/derivative_check/checked_energy.h"

namespace shellmatch {

template <int Dim>
bool CheckedEnergy<Dim>::evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                                  std::span<double> gradient, std::vector<double>& element_gradients) const {
  return level_.energy.evaluate(phi, weights, values, gradient, &element_gradients);
}

template class CheckedEnergy<2>;
template class CheckedEnergy<3>;

}  // namespace shellmatch
