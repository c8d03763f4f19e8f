#include "energies/assembly/matching_energy.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <variant>

namespace shellmatch {

template <int Dim>
MatchingEnergy<Dim>::MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                                    const EnergyOptions& options, double sigma, int points_per_direction)
    : MatchingEnergy(unknowns, geometry, std::make_shared<const EnergyTerms<Dim>>(options), sigma,
                     points_per_direction) {}

template <int Dim>
MatchingEnergy<Dim>::MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                                    std::shared_ptr<const EnergyTerms<Dim>> terms, double sigma,
                                    int points_per_direction)
    : MatchingEnergy(unknowns.elements(), geometry, std::move(terms), sigma, points_per_direction) {
  cell_blocks_.emplace(unknowns);
}

template <int Dim>
MatchingEnergy<Dim>::MatchingEnergy(std::span<const Element<Dim>> elements, const GeometryPair<Dim>& geometry,
                                    std::shared_ptr<const EnergyTerms<Dim>> terms, double sigma,
                                    int points_per_direction)
    : elements_(elements),
      target_(&geometry.target),
      terms_(std::move(terms)),
      shape_(points_per_direction),
      band_(elements, shape_, geometry.reference, geometry.root_is_inverse, sigma) {
  for (const auto& entry : terms_->entries())
    SHELLMATCH_CHECK(entry.own_fields.fit(elements, shape_),
                     "a term's own field has a value for each node, element or quadrature point");
}

namespace {

// Values of the terms by blocks of cells. They are summed in the order of the blocks, whatever the number of threads.
class BlockValues {
 public:
  BlockValues(std::size_t n_blocks, std::size_t n_terms) : n_terms_(n_terms), values_(n_blocks * n_terms, 0.0) {}
  double* of(std::size_t block) { return values_.data() + block * n_terms_; }
  bool is_finite(std::size_t block) {
    double sum = 0;
    for (std::size_t t = 0; t < n_terms_; ++t) sum += of(block)[t];
    return std::isfinite(sum);
  }
  TermValues sum() const {
    TermValues sum(n_terms_);
    for (std::size_t i = 0; i < values_.size(); ++i) sum[i % n_terms_] += values_[i];
    return sum;
  }

 private:
  std::size_t n_terms_;
  std::vector<double> values_;
};

}  // namespace

template <int Dim>
template <bool WithGradient>
void MatchingEnergy<Dim>::add_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                    double* values, double* gradients, BandSums* band_sums) const {
  if (terms_->evaluator() == Evaluator::ceres) {
    add_costs<WithGradient>(cells, phi, weights, values, gradients);
    if (band_sums) add_band_terms<false>(cells, phi, TermValues(n_terms()), values, nullptr, band_sums);
    return;
  }
  const bool is_possible = set_cell_terms<WithGradient>(cells, phi, weights, values, gradients);
  if (is_possible || band_sums) add_band_terms<WithGradient>(cells, phi, weights, values, gradients, band_sums);
  if (is_possible) add_point_terms(cells, phi, weights, values, gradients);
}

template <int Dim>
void MatchingEnergy<Dim>::add_point_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                          double* values, double* gradients) const {
  for (std::size_t t = 0; t < terms_->size(); ++t)
    if (const auto* points = std::get_if<PointCode<Dim>>(&(*terms_)[t].term.code); points && weights[t] > 0)
      values[t] += points->pairs.add(cells.begin, cells.end, elements_, phi, weights[t], gradients);
}

template <int Dim>
void MatchingEnergy<Dim>::set_point_values(std::span<const Vec<Dim>> phi, const TermValues& weights,
                                           TermValues& values) const {
  for (std::size_t t = 0; t < terms_->size(); ++t)
    if (std::holds_alternative<PointCode<Dim>>((*terms_)[t].term.code)) values[t] = 0;
  add_point_terms({0, elements_.size(), 0}, phi, weights, &values[0], nullptr);
}

template <int Dim>
bool MatchingEnergy<Dim>::evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                                   std::span<double> gradient, std::vector<double>* element_gradients) const {
  constexpr std::size_t n_dofs = n_corners<Dim> * Dim;
  std::atomic<bool> possible = true;  // once false, the remaining work is skipped
  parallel_chunks(phi.size(), 16384, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      if (!phi[i].allFinite()) possible = false;
  });
  if (!possible) return false;
  SHELLMATCH_CHECK(weights.size() == n_terms(), "one weight for each term");
  const std::size_t of_block = cells_per_block(elements_.size());
  BlockValues parts(n_chunks(elements_.size(), of_block), n_terms());
  if (gradient.empty()) {
    parallel_chunks(elements_.size(), of_block, [&](const Chunk& cells) {
      if (!possible) return;
      add_terms<false>(cells, phi, weights, parts.of(cells.index), nullptr, nullptr);
      if (!parts.is_finite(cells.index)) possible = false;
    });
  } else {
    SHELLMATCH_CHECK(cell_blocks_.has_value(), "a part of the energy has values only");
    if (element_gradients) element_gradients->resize(elements_.size() * n_dofs);
    cell_blocks_->for_each([&](const Chunk& cells) {
      if (!possible) return;
      static thread_local std::vector<autodiff::Pack> packs;  // a vector of packs, because it is aligned
      const std::size_t n = (cells.end - cells.begin) * n_dofs;
      packs.resize(n / autodiff::pack_size);
      double* gradients = reinterpret_cast<double*>(packs.data());
      add_terms<true>(cells, phi, weights, parts.of(cells.index), gradients, nullptr);
      if (!parts.is_finite(cells.index)) possible = false;
      cell_blocks_->add(cells, gradients, gradient);
      if (element_gradients) std::copy_n(gradients, n, element_gradients->data() + cells.begin * n_dofs);
    });
  }
  values = parts.sum();
  return std::isfinite(values.sum());  // a sum of finite block values may overflow
}

template <int Dim>
bool MatchingEnergy<Dim>::report(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                                 BandSums& band) const {
  const std::size_t of_block = cells_per_block(elements_.size());
  BlockValues parts(n_chunks(elements_.size(), of_block), n_terms());
  band = parallel_sum(elements_.size(), of_block, BandSums{}, [&](const Chunk& cells) {
    BandSums of_cells;
    add_terms<false>(cells, phi, weights, parts.of(cells.index), nullptr, &of_cells);
    return of_cells;
  });
  values = parts.sum();
  return std::isfinite(values.sum());
}

template class MatchingEnergy<2>;
template class MatchingEnergy<3>;

}  // namespace shellmatch
