#include "grid/fields/fast_marching.h"

#include "base/error.h"
#include "base/parallel.h"
#include "grid/octree/constraints.h"
#include "grid/octree/nodal_incidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace shellmatch {

namespace {

// Smaller decreases of a value, in sides of the domain, are rounding errors.
constexpr double least_improvement = 1e-13;

// A neighbour along an axis: its value and its distance.
struct Leg {
  double value, length;
};

// The u with sum_k max((u - value_k)/length_k, 0)^2 = 1; infinite where all values are. Sorts the legs.
template <int Dim>
double solve_upwind(std::array<Leg, Dim>& legs) {
  std::sort(legs.begin(), legs.end(), [](const Leg& a, const Leg& b) { return a.value < b.value; });
  double u = legs[0].value + legs[0].length;
  // The quadratic a u^2 - 2 b u + c = 1 of the legs so far. Values are relative to the least, against
  // cancellation.
  const double origin = legs[0].value;
  double a = 1 / (legs[0].length * legs[0].length), b = 0, c = 0;
  for (int k = 1; k < Dim && legs[k].value < u; ++k) {
    const double value = legs[k].value - origin, weight = 1 / (legs[k].length * legs[k].length);
    a += weight;
    b += weight * value;
    c += weight * value * value;
    u = origin + (b + std::sqrt(std::max(0.0, b * b - a * (c - 1)))) / a;
  }
  return u;
}

// The leaves that may meet the surface, found from the root through the cells that may meet it.
template <int Dim>
std::vector<Index> leaves_at_surface(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& distance) {
  std::vector<Index> found, level{0};
  while (!level.empty()) {
    std::vector<char> is_met(level.size());
    parallel_for(
        level.size(),
        [&](std::size_t i) {
          const double half_diagonal = 0.5 * std::sqrt(double(Dim)) * grid.cell(level[i]).side();
          // The tolerance keeps a surface that passes exactly through a corner.
          is_met[i] = std::abs(distance(grid.cell_centre(level[i]))) <= half_diagonal * (1 + 1e-9);
        },
        256);
    std::vector<Index> next;
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (!is_met[i]) continue;
      const auto& cell = grid.cell(level[i]);
      if (cell.is_leaf()) found.push_back(level[i]);
      else
        for (int c = 0; c < n_corners<Dim>; ++c) next.push_back(cell.first_child + c);
    }
    level = std::move(next);
  }
  return found;
}

template <int Dim>
class March {
 public:
  March(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& distance)
      : grid_(grid), incidence_(grid), nodes_(grid.n_nodes()) {
    const auto hanging = grid.hanging_nodes();
    first_child_.assign(static_cast<std::size_t>(grid.n_nodes()) + 1, 0);
    for (std::size_t h = 0; h < hanging.size(); ++h) {
      nodes_[hanging[h].node].hanging = static_cast<Index>(h);
      for (int p = 0; p < hanging[h].n_parents; ++p) ++first_child_[hanging[h].parents[p] + 1];
    }
    for (std::size_t i = 1; i < first_child_.size(); ++i) first_child_[i] += first_child_[i - 1];
    children_.resize(first_child_.back());
    std::vector<std::size_t> next(first_child_.begin(), first_child_.end() - 1);
    for (const HangingNode<Dim>& h : hanging)
      for (int p = 0; p < h.n_parents; ++p) children_[next[h.parents[p]]++] = h.node;
    find_start(distance);
  }

  // Marches from the starting nodes of one sign. No other leaf has nodes of both signs, so neither march
  // reads or writes what the other one writes.
  void run(signed char sign) {
    Queue queue;
    for (Index n = 0; n < grid_.n_nodes(); ++n)
      if (nodes_[n].is_start && nodes_[n].sign * sign >= 0) queue.push({nodes_[n].size, n});
    while (!queue.empty()) {
      const auto [value, node] = queue.top();
      queue.pop();
      if (value > nodes_[node].size) continue;  // an outdated entry: the value has decreased since
      pass_on(node, sign, queue);
      for (std::size_t c = first_child_[node]; c < first_child_[node + 1]; ++c)
        if (!nodes_[children_[c]].is_start) pass_on(children_[c], sign, queue);
    }
  }

  std::vector<double> signed_values() const {
    std::vector<double> values(nodes_.size(), 0.0);
    for (const Index n : grid_.free_nodes()) {
      SHELLMATCH_CHECK(nodes_[n].size < infinity, "fast marching did not reach a node");
      values[n] = nodes_[n].sign < 0 ? -nodes_[n].size : nodes_[n].size;
    }
    distribute(grid_, values);
    return values;
  }

 private:
  using Entry = std::pair<double, Index>;  // value and node; the node breaks ties
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  void find_start(const std::function<double(const Vec<Dim>&)>& distance) {
    const std::vector<Index> leaves = leaves_at_surface(grid_, distance);
    SHELLMATCH_CHECK(!leaves.empty(), "the surface whose distance is asked for does not meet the grid");
    for (const Index leaf : leaves)
      for (const Index node : grid_.cell(leaf).nodes) {
        nodes_[node].is_start = true;
        // Otherwise a node that hangs on a coarser leaf at the surface would average values of both sides.
        if (const Index h = nodes_[node].hanging; h != no_index)
          for (int p = 0; p < grid_.hanging_nodes()[h].n_parents; ++p)
            nodes_[grid_.hanging_nodes()[h].parents[p]].is_start = true;
      }
    for (const HangingNode<Dim>& h : grid_.hanging_nodes())
      if (std::all_of(h.parents.begin(), h.parents.begin() + h.n_parents, [&](Index p) { return nodes_[p].is_start; }))
        nodes_[h.node].is_start = true;
    std::vector<Index> nodes;
    for (Index n = 0; n < grid_.n_nodes(); ++n)
      if (nodes_[n].is_start) nodes.push_back(n);
    parallel_for(
        nodes.size(),
        [&](std::size_t i) {
          const double d = distance(grid_.node_position(nodes[i]));
          nodes_[nodes[i]].size = std::abs(d);
          nodes_[nodes[i]].sign = d > 0 ? 1 : d < 0 ? -1 : 0;
        },
        256);
  }

  // The value and distance with which `neighbour`, at the other end of an edge of a leaf, enters the scheme
  // at x.
  Leg leg(Index x, Index neighbour, double side) const {
    const Index h = nodes_[neighbour].hanging;
    if (h == no_index || nodes_[neighbour].is_start) return {nodes_[neighbour].size, side};
    const HangingNode<Dim>& hanging = grid_.hanging_nodes()[h];
    double sum = 0;
    for (int p = 0; p < hanging.n_parents; ++p) {
      // The neighbour is then the midpoint of an edge that ends at x, and it has two parents.
      if (hanging.parents[p] == x) return {nodes_[hanging.parents[1 - p]].size, 2 * side};
      sum += nodes_[hanging.parents[p]].size;
    }
    return {sum / hanging.n_parents, side};
  }

  // Updates the neighbours of `node`, whose value (or that of a parent, if it hangs) has changed.
  void pass_on(Index node, signed char sign, Queue& queue) {
    const double value = leg(no_index, node, 0).value;
    for (const auto& [position, corner] : incidence_.leaves_at(node)) {
      const auto& cell = grid_.cell(grid_.leaves()[position]);
      for (int k = 0; k < Dim; ++k) {
        const int c = corner ^ (1 << k);
        const Index x = cell.nodes[c];
        Node& at_x = nodes_[x];
        if (at_x.is_start || at_x.hanging != no_index || at_x.size <= value) continue;
        std::array<Leg, Dim> legs;
        for (int j = 0; j < Dim; ++j) legs[j] = leg(x, cell.nodes[c ^ (1 << j)], cell.side());
        const double u = solve_upwind<Dim>(legs);
        if (!(u < at_x.size - least_improvement)) continue;
        at_x.size = u;
        at_x.sign = sign;
        queue.push({u, x});
      }
    }
  }

  struct Node {
    double size = infinity;    // absolute value of the distance; infinite where not yet reached
    Index hanging = no_index;  // position in grid_.hanging_nodes()
    signed char sign = 0;
    bool is_start = false;
  };

  const Octree<Dim>& grid_;
  NodalIncidence<Dim> incidence_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> first_child_;  // children_[first_child_[i], first_child_[i + 1]) hang on node i
  std::vector<Index> children_;
};

}  // namespace

template <int Dim>
std::vector<double> march_distance(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& distance) {
  March<Dim> march(grid, distance);
  parallel_for(
      2, [&](std::size_t side) { march.run(side == 0 ? 1 : -1); }, 1);
  return march.signed_values();
}

SHELLMATCH_2D_3D(march_distance);

}  // namespace shellmatch
