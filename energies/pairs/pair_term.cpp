#include "energies/pairs/pair_term.h"

#include "base/error.h"
#include "base/parallel.h"
#include "grid/fields/interpolation.h"

#include <algorithm>

namespace shellmatch {

template <int Dim>
PairTerm<Dim>::PairTerm(const Octree<Dim>& grid, const PointPairs<Dim>& pairs)
    : loss_(pairs.loss), scale_(pairs.scale), tolerance_(pairs.tolerance) {
  SHELLMATCH_CHECK(scale_ > 0, "the scale of a robust loss is positive");
  const auto leaves = grid.leaves();
  pairs_.reserve(pairs.pairs.size());
  for (const PointPair<Dim>& pair : pairs.pairs) {
    SHELLMATCH_CHECK(pair.weight > 0 && pair.p.allFinite() && pair.y.allFinite(),
                     "pairs are finite, their weights positive");
    const LocalPoint<Dim> at = locate_local(grid, pair.p);
    const auto leaf = std::lower_bound(leaves.begin(), leaves.end(), at.cell);
    pairs_.push_back(
        {static_cast<std::size_t>(leaf - leaves.begin()), shape_values<Dim>(at.xi), pair.y, pair.normal, pair.weight});
  }
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const LocatedPair<Dim>& a, const LocatedPair<Dim>& b) { return a.element < b.element; });
}

template <int Dim>
std::span<const LocatedPair<Dim>> PairTerm<Dim>::pairs_of(std::size_t begin, std::size_t end) const {
  const auto first_from = [&](std::size_t element) {
    return std::lower_bound(pairs_.begin(), pairs_.end(), element,
                            [](const LocatedPair<Dim>& pair, std::size_t e) { return pair.element < e; });
  };
  return {first_from(begin), first_from(end)};
}

template <int Dim>
double PairTerm<Dim>::add(std::size_t begin, std::size_t end, std::span<const Element<Dim>> elements,
                          std::span<const Vec<Dim>> phi, double weight, double* gradients) const {
  double sum = 0;
  for (const LocatedPair<Dim>& pair : pairs_of(begin, end)) {
    const Vec<Dim> r = residual(pair, elements[pair.element], phi);
    const double square = r.squaredNorm(), of_pair = weight * pair.weight;
    sum += of_pair * robust_loss(loss_, scale_, square);
    if (gradients == nullptr) continue;
    const double factor = 2 * of_pair * robust_weight(loss_, scale_, square);
    double* g = gradients + (pair.element - begin) * n_dofs;
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int k = 0; k < Dim; ++k) *g++ += factor * pair.n[c] * r[k];
  }
  return sum;
}

template <int Dim>
std::vector<ActivatedPair<Dim>> PairTerm<Dim>::activated(std::span<const Element<Dim>> elements,
                                                         std::span<const Vec<Dim>> phi, std::span<const Vec<Dim>> step,
                                                         double weight) const {
  if (tolerance_ == 0) return {};
  constexpr std::size_t pairs_per_chunk = 1024;
  std::vector<std::vector<ActivatedPair<Dim>>> of_chunk(n_chunks(pairs_.size(), pairs_per_chunk));
  parallel_chunks(pairs_.size(), pairs_per_chunk, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const LocatedPair<Dim>& pair = pairs_[i];
      const Element<Dim>& element = elements[pair.element];
      const Vec<Dim> before = counted(pair, at_p(pair, element, phi) - pair.y);
      if (!beyond_tolerance(before).isZero(0)) continue;
      const Vec<Dim> after = before + counted(pair, at_p(pair, element, step)), beyond = beyond_tolerance(after);
      if (beyond.isZero(0)) continue;
      const Mat<Dim> k = stiffness(pair, weight, beyond);
      of_chunk[chunk.index].push_back({i, k, k * (before - (after - beyond))});
    }
  });
  std::vector<ActivatedPair<Dim>> all;
  for (const auto& found : of_chunk) all.insert(all.end(), found.begin(), found.end());
  return all;
}

template class PairTerm<2>;
template class PairTerm<3>;

}  // namespace shellmatch
