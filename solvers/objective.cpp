#include "solvers/objective.h"

#include "solvers/vector_ops.h"

#include <cmath>

namespace shellmatch {

double Objective::l2_gradient_norm(std::span<const double> gradient) const {
  const std::span<const double> mass = lumped_mass();
  if (mass.size() != gradient.size()) return norm(gradient);
  return std::sqrt(chunked_sums<1>(gradient.size(), [&](std::size_t begin, std::size_t end, auto& sums) {
    for (std::size_t i = begin; i < end; ++i) sums[0] += gradient[i] * gradient[i] / mass[i];
  })[0]);
}

}  // namespace shellmatch
