#include "energies/assembly/ceres_problem.h"

#include "base/error.h"
#include "energies/assembly/ceres_evaluator.h"
#include "energies/cost/condensed_cost.h"
#include "energies/cost/pair_cost.h"

#include <utility>
#include <variant>

namespace shellmatch {

template <int Dim>
EnergyFunction<Dim>::EnergyFunction(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                    TermValues weights, std::vector<Vec<Dim>> phi)
    : energy_(&energy), unknowns_(&unknowns), weights_(std::move(weights)), phi_(std::move(phi)) {}

template <int Dim>
bool EnergyFunction<Dim>::Evaluate(const double* x, double* cost, double* gradient) const {
  const std::size_t n = unknowns_->size();
  unknowns_->expand({x, n}, phi_);
  if (!energy_->evaluate(phi_, weights_, values_, {gradient, gradient ? n : 0})) return false;
  *cost = values_.sum();
  return true;
}

template <int Dim>
std::vector<std::string> add_residuals(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                       const TermValues& weights, std::span<const Vec<Dim>> phi, std::span<double> x,
                                       ceres::Problem& problem) {
  SHELLMATCH_CHECK(x.size() == unknowns.size(), "the problem's parameters are the unknowns");
  const auto add = [&](ElementCostFunction residual, std::size_t e, ceres::LossFunction* loss) {
    auto* cost = new CondensedCost<Dim>(std::move(residual), unknowns, e, phi);
    std::vector<double*> blocks;
    for (int i = 0; i < cost->unknowns().size(); ++i)
      blocks.push_back(x.data() + static_cast<std::ptrdiff_t>(cost->unknowns()[i]) * Dim);
    problem.AddResidualBlock(cost, loss, blocks);
  };
  std::vector<std::string> left_out;
  const CeresEvaluator<Dim> costs(energy);
  const EnergyTerms<Dim>& terms = energy.terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!(weights[t] > 0)) continue;
    const auto& entry = terms[t];
    if (const auto* points = std::get_if<PointCode<Dim>>(&entry.term.code)) {
      for (const LocatedPair<Dim>& pair : points->pairs.pairs_of(0, energy.elements().size())) {
        PairResidualBlock block = pair_residual(points->pairs, pair, weights[t]);
        add(std::move(block.residual), pair.element, block.loss.release());
      }
      continue;
    }
    if (entry.term.residuals == nullptr) {
      left_out.push_back(entry.name);
      continue;
    }
    const bool is_of_band = std::holds_alternative<BandCode<Dim>>(entry.term.code);
    for (std::size_t e = 0; e < energy.elements().size(); ++e)
      if (const ElementFields<Dim>& fields = costs.fields_of(t, e); !is_of_band || !fields.band.empty())
        add(entry.term.residuals(fields, weights[t], entry.material), e, nullptr);
  }
  return left_out;
}

template class EnergyFunction<2>;
template class EnergyFunction<3>;
SHELLMATCH_2D_3D(add_residuals);

}  // namespace shellmatch
