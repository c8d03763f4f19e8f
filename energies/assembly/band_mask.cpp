// The mask of the band at the quadrature points.

#include "base/parallel.h"
#include "energies/assembly/matching_energy.h"
#include "energies/elements/band_mask.h"
#include "energies/elements/sum_factorised_evaluator.h"

#include <vector>

namespace shellmatch {

template <int Dim>
void MatchingEnergy<Dim>::set_mask(const BandMask<Dim>& mask) {
  mask_ = &mask;
  const auto batches = band_.batches();
  parallel_chunks(batches.size(), 16, [&](const Chunk& chunk) {
    std::vector<std::size_t> active;
    std::vector<Vec<Dim>> x;
    std::vector<double> weights;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b)
      for (int lane = 0; lane < batches[b].n_elements; ++lane) {
        const Element<Dim>& element = elements_[batches[b].element[lane]];
        band_.active_points(b, lane, active);
        x.clear();
        for (const std::size_t q : active) x.push_back(element.corner + element.side * shape_.points[q].xi);
        weights.resize(x.size());
        mask.reference_weights(x, weights);
        for (std::size_t i = 0; i < active.size(); ++i) band_.multiply_weight(b, active[i], lane, weights[i]);
      }
  });
  band_.keep_weights();
}

template <int Dim>
void MatchingEnergy<Dim>::refresh_mask(std::span<const Vec<Dim>> phi) {
  if (mask_ == nullptr) return;
  const auto batches = band_.batches();
  parallel_chunks(batches.size(), 16, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    SumFactorisedEvaluator<Dim> evaluator(shape_);
    std::vector<std::size_t> active;
    std::vector<Vec<Dim>> y;
    std::vector<double> weights;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      batch.load(elements_, phi, [&](int lane) { return batches[b].element[lane]; });
      evaluator.evaluate(batch);
      for (int lane = 0; lane < batches[b].n_elements; ++lane) {
        band_.active_points(b, lane, active);
        y.resize(active.size());
        for (std::size_t i = 0; i < active.size(); ++i) {
          const auto position = evaluator.position(active[i]);
          for (int k = 0; k < Dim; ++k) y[i][k] = position[k][lane];
        }
        weights.resize(y.size());
        mask_->template_weights(y, weights);
        for (std::size_t i = 0; i < active.size(); ++i) band_.multiply_weight(b, active[i], lane, weights[i]);
      }
    }
  });
}

#define SHELLMATCH_INSTANTIATE(Dim)                                  \
  template void MatchingEnergy<Dim>::set_mask(const BandMask<Dim>&); \
  template void MatchingEnergy<Dim>::refresh_mask(std::span<const Vec<Dim>>)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
