#include "solvers/methods/step_regularisation.h"

#include <algorithm>

namespace shellmatch {

namespace {

constexpr double most_damping = 1e30;  // damping is kept in single precision

}  // namespace

std::span<const float> StepRegularisation::next_damping() {
  n_of_step_ = 0;
  for (float& factor : damping_) factor *= static_cast<float>(options_.regularisation_decay);
  return damping_;
}

bool StepRegularisation::regularise(SecondOrderObjective& objective, std::span<const double> x,
                                    std::span<const double> d) {
  if (n_of_step_ == options_.max_regularisations) return false;
  std::vector<RegionDamping> regions = objective.regions_beyond_model(x, d);
  if (regions.empty()) return false;
  ++n_of_step_;
  ++n_systems_;
  for (RegionDamping& region : regions) {
    float& factor = damping_[region.region];
    // To begin with, as stiff as the region is already.
    const double next = std::min(std::max(options_.regularisation_growth * static_cast<double>(factor), region.factor), most_damping);
    region.factor = next - static_cast<double>(factor);
    factor = static_cast<float>(next);
  }
  objective.add_damping(regions);
  return true;
}

}  // namespace shellmatch
