#include "solvers/methods/step_regularisation.h"

#include "solvers/vector_ops.h"

#include <algorithm>

namespace shellmatch {

namespace {

constexpr double most_damping = 1e30;  // damping is kept in single precision
constexpr int most_halvings = 20;      // of the step of all regions

}  // namespace

std::span<const float> StepRegularisation::next_damping() {
  n_of_step_ = 0;
  for (float& factor : damping_) factor *= static_cast<float>(options_.regularisation_decay);
  return damping_;
}

bool StepRegularisation::regularise(SecondOrderObjective& objective, std::span<const double> x,
                                    std::span<const double> d, std::span<double> gradient) {
  if (n_of_step_ == options_.max_regularisations) return false;
  std::vector<RegionDamping> regions = objective.regions_beyond_model(x, d);
  const bool extended = objective.extend_model(x, d, gradient);
  if (regions.empty() && !extended) return false;
  ++n_of_step_;
  ++n_systems_;
  for (RegionDamping& region : regions) {
    float& factor = damping_[region.region];
    // To begin with, as stiff as the region is already.
    const double next =
        std::min(std::max(options_.regularisation_growth * static_cast<double>(factor), region.factor), most_damping);
    region.factor = next - static_cast<double>(factor);
    factor = static_cast<float>(next);
  }
  objective.add_damping(regions);
  return true;
}

void StepRegularisation::contract(SecondOrderObjective& objective, std::span<const double> x, std::span<const double> g,
                                  std::span<double> d) {
  if (n_of_step_ < options_.max_regularisations || damping_.empty()) return;  // the last system leads nowhere beyond
  std::vector<double> contracted(d.begin(), d.end());
  for (int n = 0; n < options_.max_contractions + most_halvings; ++n) {
    const std::vector<RegionDamping> regions = objective.regions_beyond_model(x, contracted);
    if (regions.empty()) break;
    if (n < options_.max_contractions) objective.contract_step(regions, 0.5, contracted);
    else scale(0.5, contracted);
  }
  if (dot(g, contracted) < 0) std::ranges::copy(contracted, d.begin());
}

}  // namespace shellmatch
