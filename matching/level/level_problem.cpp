#include "matching/level/level_problem.h"

#include "base/error.h"

#include <algorithm>
#include <utility>

namespace shellmatch {

namespace {

/// The regions of a level are its elements.
std::vector<ElementDamping> as_elements(std::span<const RegionDamping> regions) {
  std::vector<ElementDamping> elements;
  elements.reserve(regions.size());
  for (const RegionDamping& one : regions) elements.push_back({one.region, one.factor});
  return elements;
}

}  // namespace

template <int Dim>
LevelProblem<Dim>::LevelProblem(const Unknowns<Dim>& unknowns, const MatchingEnergy<Dim>& energy,
                                EnergyHessian<Dim>& hessian, const TermValues& weights, std::span<const double> mass,
                                std::vector<Vec<Dim>> phi, std::function<Eigen::SparseMatrix<double>(Metric)> metric)
    : unknowns_(&unknowns),
      energy_(&energy),
      hessian_(hessian),
      weights_(weights),
      values_(weights.size()),
      phi_(std::move(phi)),
      metric_(std::move(metric)) {
  SHELLMATCH_CHECK(mass.size() == unknowns.nodes().size(), "one mass for each unknown node");
  mass_.reserve(mass.size() * Dim);
  for (const double m : mass) mass_.insert(mass_.end(), Dim, m);
}

template <int Dim>
bool LevelProblem<Dim>::evaluate(std::span<const double> x, double& value, std::span<double> gradient) {
  const auto x_ahead = std::exchange(x_ahead_, {}), gradient_ahead = std::exchange(gradient_ahead_, {});
  if (!x_ahead.empty() && gradient.size() == gradient_ahead.size() && std::ranges::equal(x, x_ahead)) {
    std::ranges::copy(gradient_ahead, gradient.begin());
    value = values_.sum();
    return true;
  }
  unknowns_->expand(x, phi_);
  if (!energy_->evaluate(phi_, weights_, values_, gradient)) return false;
  value = values_.sum();
  return true;
}

template <int Dim>
bool LevelProblem<Dim>::evaluate_ahead(std::span<const double> x) {
  std::vector<double> gradient(x.size());
  double value;
  if (!evaluate(x, value, gradient)) return false;
  x_ahead_.assign(x.begin(), x.end());
  gradient_ahead_ = std::move(gradient);
  return true;
}

template <int Dim>
void LevelProblem<Dim>::prepare_second_derivative(std::span<const double> x, std::span<const float> damping) {
  unknowns_->expand(x, phi_);
  hessian_.assemble(phi_, weights_, damping);
}

template <int Dim>
std::string LevelProblem<Dim>::what_is_not_finite(std::span<const double> x) {
  unknowns_->expand(x, phi_);
  const auto found = find_not_finite(*energy_, *unknowns_, std::span<const Vec<Dim>>(phi_), weights_);
  return found ? not_finite_text(*found) : "";
}

template <int Dim>
std::string LevelProblem<Dim>::what_of_model_is_not_finite(std::span<const double> x) {
  unknowns_->expand(x, phi_);
  const auto found = hessian_.find_not_finite(phi_, weights_);
  return found ? not_finite_text(*found) : "";
}

template <int Dim>
std::vector<RegionDamping> LevelProblem<Dim>::regions_beyond_model(std::span<const double> x,
                                                                   std::span<const double> d) {
  unknowns_->expand(x, phi_);
  std::vector<RegionDamping> regions;
  for (const ElementDamping& one : hessian_.elements_beyond_margin(phi_, d))
    regions.push_back({one.element, one.factor});
  return regions;
}

template <int Dim>
void LevelProblem<Dim>::add_damping(std::span<const RegionDamping> regions) {
  hessian_.add_damping(as_elements(regions));
}

template <int Dim>
bool LevelProblem<Dim>::extend_model(std::span<const double> x, std::span<const double> d, std::span<double> gradient) {
  unknowns_->expand(x, phi_);
  return hessian_.extend(phi_, d, weights_, gradient) > 0;
}

template <int Dim>
void LevelProblem<Dim>::contract_step(std::span<const RegionDamping> regions, double share, std::span<double> d) {
  hessian_.contract_step(as_elements(regions), share, d);
}

template <int Dim>
std::vector<std::string> LevelProblem<Dim>::term_names() const {
  return energy_->term_names();
}

template <int Dim>
std::vector<double> LevelProblem<Dim>::unknowns_of(const std::vector<Vec<Dim>>& phi) const {
  std::vector<double> x(size());
  unknowns_->restrict_to(phi, x);
  return x;
}

template <int Dim>
std::vector<Vec<Dim>> LevelProblem<Dim>::positions(std::span<const double> x) const {
  std::vector<Vec<Dim>> phi = phi_;
  unknowns_->expand(x, phi);
  return phi;
}

template class LevelProblem<2>;
template class LevelProblem<3>;

}  // namespace shellmatch
