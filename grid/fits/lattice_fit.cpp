#include "grid/fits/lattice_fit.h"

#include "base/parallel.h"
#include "grid/fits/quadratic_fit.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

/// All offsets with lower <= entry <= upper.
template <int Dim>
std::vector<std::array<int, Dim>> box(int lower, int upper) {
  std::vector<std::array<int, Dim>> all(1);
  for (int k = 0; k < Dim; ++k) {
    std::vector<std::array<int, Dim>> longer;
    for (auto offset : all)
      for (offset[k] = lower; offset[k] <= upper; ++offset[k]) longer.push_back(offset);
    all = std::move(longer);
  }
  return all;
}

template <int Dim>
int square(const std::array<int, Dim>& offset) {
  int sum = 0;
  for (const int o : offset) sum += o * o;
  return sum;
}

/// For the leaf in each octant around a node, the places of its corners among the next nodes.
template <int Dim>
constexpr auto place_of_corner = [] {
  std::array<std::array<std::size_t, n_corners<Dim>>, n_corners<Dim>> place{};
  for (int octant = 0; octant < n_corners<Dim>; ++octant)
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int k = 0, stride = 1; k < Dim; ++k, stride *= 3)
        place[octant][c] += static_cast<std::size_t>(stride * ((octant >> k & 1) + (c >> k & 1)));
  return place;
}();

}  // namespace

template <int Dim>
LatticeFit<Dim>::LatticeFit(const Octree<Dim>& grid, std::size_t n_others, double exponent) : grid_(&grid) {
  choose_terms(n_others, exponent);
  if (terms_.empty()) return;
  Around none;
  none.fill(no_index);
  around_.assign(static_cast<std::size_t>(grid.n_nodes()), none);
  for (const Index leaf : grid.leaves())
    for (int c = 0; c < n_corners<Dim>; ++c) around_[grid.cell(leaf).nodes[c]][n_corners<Dim> - 1 - c] = leaf;
  parallel_for(around_.size(), [&](std::size_t node) {
    Around& leaves = around_[node];
    for (const Index leaf : leaves)
      if (leaf == no_index || leaves[0] == no_index || grid.cell(leaf).level != grid.cell(leaves[0]).level)
        leaves[0] = no_index;
  });
}

template <int Dim>
void LatticeFit<Dim>::choose_terms(std::size_t n_others, double exponent) {
  auto offsets = box<Dim>(-2, 2);
  std::ranges::stable_sort(offsets, {}, square<Dim>);
  if (n_others >= offsets.size() || square<Dim>(offsets[n_others]) > 4) return;
  const int farthest = square<Dim>(offsets[n_others]);  // offsets[0] is the node itself
  std::erase_if(offsets, [&](const Offset& o) { return square<Dim>(o) > farthest || square<Dim>(o) == 0; });
  is_ball_wide_ = farthest > 1;

  for (const Offset& one : offsets) {
    QuadraticFit<Dim, 1> fit;
    const auto add = [&](const Offset& o) {
      Vec<Dim> x;
      for (int k = 0; k < Dim; ++k) x[k] = o[k] / std::sqrt(farthest);
      const double share = static_cast<double>(std::max(square<Dim>(o), 1)) / farthest;
      fit.add(x, {o == one ? 1.0 : 0.0}, exponent == 0 ? 1.0 : std::pow(share, -0.5 * exponent));
    };
    add({});
    for (const Offset& o : offsets) add(o);
    if (!fit.factorise()) {
      terms_.clear();
      return;
    }
    Term& term = terms_.emplace_back();
    for (int k = 0, stride = 1; k < Dim; ++k, stride *= 3) {
      const int first = std::clamp(one[k], -1, 1);
      term.rest[k] = one[k] - first;
      term.next += static_cast<std::size_t>(stride * (first + 1));
    }
    term.is_next = square<Dim>(term.rest) == 0;
    term.weight = fit.hessian(0);
    for (double& w : terms_.back().weight) w /= farthest;
  }
}

template <int Dim>
Index LatticeFit<Dim>::neighbour(Index node, const Offset& step) const {
  int octant = 0, corner = 0;
  for (int k = 0; k < Dim; ++k) {
    octant |= (step[k] > 0) << k;
    corner |= (step[k] >= 0) << k;  // 0 is the upper end of the leaf below
  }
  return grid_->cell(around_[node][octant]).nodes[corner];
}

template <int Dim>
double LatticeFit<Dim>::find_neighbours(Index node, std::vector<Index>& neighbours) const {
  if (terms_.empty() || around_[node][0] == no_index) return 0;
  std::array<Index, n_next> next;
  for (int octant = 0; octant < n_corners<Dim>; ++octant) {
    const auto& nodes = grid_->cell(around_[node][octant]).nodes;
    for (int c = 0; c < n_corners<Dim>; ++c) next[place_of_corner<Dim>[octant][c]] = nodes[c];
  }
  // A node and the next share a leaf, so all these leaves have the same size.
  if (is_ball_wide_)
    for (const Index other : next)
      if (around_[other][0] == no_index) return 0;
  neighbours.clear();
  for (const Term& term : terms_) {
    const Index other = term.is_next ? next[term.next] : neighbour(next[term.next], term.rest);
    if (grid_->free_index(other) == no_index) return 0;
    neighbours.push_back(other);
  }
  return grid_->cell(around_[node][0]).side();
}

template <int Dim>
SymmetricComponents<Dim> LatticeFit<Dim>::hessian(std::span<const double> field, Index node, double side,
                                                  std::span<const Index> neighbours) const {
  SymmetricComponents<Dim> sum{};
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    // Differences avoid cancellation where the values are large.
    const double difference = field[neighbours[i]] - field[node];
    for (std::size_t m = 0; m < sum.size(); ++m) sum[m] += terms_[i].weight[m] * difference;
  }
  for (double& s : sum) s /= side * side;
  return sum;
}

template class LatticeFit<2>;
template class LatticeFit<3>;

}  // namespace shellmatch
