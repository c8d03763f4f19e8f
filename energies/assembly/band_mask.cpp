// The mask of the band at the quadrature points.

#include "base/parallel.h"
#include "energies/assembly/matching_energy.h"
#include "energies/elements/band_mask.h"
#include "energies/elements/sum_factorised_evaluator.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace shellmatch {

namespace {

/// Positions of an element's quadrature points, and the ball around their centre that holds them.
template <int Dim>
struct PointCloud {
  std::vector<Vec<Dim>> points;
  Vec<Dim> centre;
  double radius = 0;
  explicit PointCloud(std::size_t n) : points(n) {}
  void enclose() {
    centre.setZero();
    for (const Vec<Dim>& p : points) centre += p;
    centre /= static_cast<double>(points.size());
    radius = 0;
    for (const Vec<Dim>& p : points) radius = std::max(radius, (p - centre).norm());
  }
};

}  // namespace

template <int Dim>
void MatchingEnergy<Dim>::set_mask(std::span<const Vec<Dim>> phi, const BandMask<Dim>& mask) {
  band_.keep_unmasked_weights();
  const auto batches = band_.batches();
  parallel_chunks(batches.size(), 16, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    SumFactorisedEvaluator<Dim> evaluator(shape_);
    PointCloud<Dim> x(shape_.points.size()), y = x;
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      batch.load(elements_, phi, [&](int lane) { return batches[b].element[lane]; });
      evaluator.evaluate(batch);
      for (int lane = 0; lane < batches[b].n_elements; ++lane) {
        const Element<Dim>& element = elements_[batches[b].element[lane]];
        for (std::size_t q = 0; q < x.points.size(); ++q) {
          x.points[q] = element.corner + element.side * shape_.points[q].xi;
          const auto position = evaluator.position(q);
          for (int k = 0; k < Dim; ++k) y.points[q][k] = position[k][lane];
        }
        x.enclose();
        y.enclose();
        if (const std::optional<double> all = mask.constant(x.centre, x.radius, y.centre, y.radius))
          band_.set_mask(b, lane, [&](std::size_t) { return *all; });
        else band_.set_mask(b, lane, [&](std::size_t q) { return mask.weight(x.points[q], y.points[q]); });
      }
    }
  });
}

template void MatchingEnergy<2>::set_mask(std::span<const Vec<2>>, const BandMask<2>&);
template void MatchingEnergy<3>::set_mask(std::span<const Vec<3>>, const BandMask<3>&);

}  // namespace shellmatch
