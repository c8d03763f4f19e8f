#include "base/registers.h"
#include "geometry/distance/facet_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace shellmatch {

namespace {

// Of the eight facets or points at once.
constexpr int n_lanes = register_bytes / sizeof(double), n_parts = 8 / n_lanes;
using Lanes = Register<double, n_lanes>;
using IndexLanes = Register<std::int64_t, n_lanes>;
using FloatLanes = Register<float, n_lanes>;

/// Squares of the distances from v to the segments from 0 to e, which may be one or one for each lane.
template <class Edge, int Dim>
Lanes to_segment(const Lanes (&v)[Dim], const Edge (&e)[Dim], const Edge& inverse_length2) {
  const Lanes zero{}, one = zero + 1;
  Lanes along = v[0] * e[0];
  for (int k = 1; k < Dim; ++k) along += v[k] * e[k];
  along *= inverse_length2;
  along = along > zero ? along : zero;
  along = along < one ? along : one;
  Lanes distance2 = zero;
  for (int k = 0; k < Dim; ++k) {
    const Lanes difference = v[k] - along * e[k];
    distance2 += difference * difference;
  }
  return distance2;
}

/// Squares of the distances between facets and points: several facets (Number is Lanes) and one point, or one facet
/// (double) and several points. The case distinctions of closest_point_on_facet(), made by selection. \param w from the
/// first corner to the point
template <class Number, int Dim>
Lanes to_facet(const Lanes (&w)[Dim], const Number (&edge)[Dim - 1][Dim], const Number* inverse_length2,
               const Number& inverse_normal2) {
  Lanes result = to_segment(w, edge[0], inverse_length2[0]);
  if constexpr (Dim == 3) {
    const Number(&e1)[3] = edge[0];
    const Number(&e2)[3] = edge[1];
    const Number e3[3] = {e2[0] - e1[0], e2[1] - e1[1], e2[2] - e1[2]};
    const Lanes w3[3] = {w[0] - e1[0], w[1] - e1[1], w[2] - e1[2]};
    Lanes other = to_segment(w, e2, inverse_length2[1]);
    result = other < result ? other : result;
    other = to_segment(w3, e3, inverse_length2[2]);
    result = other < result ? other : result;

    // Weights of the second and the third corner: (w x e2) . n / |n|^2 and (e1 x w) . n / |n|^2, n = e1 x e2.
    const Number n[3] = {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2], e1[0] * e2[1] - e1[1] * e2[0]};
    const Lanes m[3] = {w[1] * n[2] - w[2] * n[1], w[2] * n[0] - w[0] * n[2], w[0] * n[1] - w[1] * n[0]};
    const Lanes beta = -(m[0] * e2[0] + m[1] * e2[1] + m[2] * e2[2]) * inverse_normal2;
    const Lanes gamma = (m[0] * e1[0] + m[1] * e1[1] + m[2] * e1[2]) * inverse_normal2;
    const Lanes zero{}, one = zero + 1;
    other = zero;
    for (int k = 0; k < 3; ++k) {
      const Lanes difference = w[k] - beta * e1[k] - gamma * e2[k];
      other += difference * difference;
    }
    // A facet without area has weights 0 and is treated as the union of its edges.
    const Lanes alpha = one - (beta + gamma);
    Lanes smallest = beta < gamma ? beta : gamma;
    smallest = alpha < smallest ? alpha : smallest;
    other = smallest > zero ? other : result;
    result = other < result ? other : result;
  }
  return result;
}

/// Squares of the distances of a box from some points, or of some boxes from a point, along one axis.
Lanes to_box(const Lanes& before, const Lanes& after) {
  Lanes gap = before > after ? before : after;
  gap = gap > 0 ? gap : Lanes{};
  return gap * gap;
}

}  // namespace

/// Subtrees still to be visited, the nearest of those added last on top.
template <int Dim>
class FacetTree<Dim>::Stack {
 public:
  struct Entry {
    double distance2;
    Index child, place;  ///< `place` among the children of all nodes
  };
  explicit Stack(const std::vector<Node>& nodes) : nodes_(nodes) {}

  bool is_empty() const { return n_ == 0; }
  Entry pop() { return entries_[--n_]; }

  /// Adds the children of a node whose boxes are not farther from x than sqrt(most2).
  void add_children(Index index, const Vec<Dim>& x, double most2) {
    const Node& node = nodes_[index];
    double distances[width];
    for (int i = 0; i < width; i += n_lanes) {
      Lanes sum{};
      for (int k = 0; k < Dim; ++k)
        sum += to_box(widened(load<FloatLanes>(&node.min[k][i])) - x[k],
                      x[k] - widened(load<FloatLanes>(&node.max[k][i])));
      store(sum, &distances[i]);
    }
    const int first = n_;
    for (int i = 0; i < width; ++i) {
      if (!(distances[i] <= most2)) continue;
      int place = n_++;
      for (; place > first && entries_[place - 1].distance2 < distances[i]; --place)
        entries_[place] = entries_[place - 1];
      entries_[place] = {distances[i], node.child[i], width * index + i};
    }
  }

 private:
  const std::vector<Node>& nodes_;
  // A balanced tree over 32-bit facet numbers has at most eleven levels, and each leaves at most seven
  // entries.
  std::array<Entry, 96> entries_;
  int n_ = 0;
};

template <int Dim>
Index FacetTree<Dim>::nearest(const Vec<Dim>& x) const {
  return nearer(x, std::numeric_limits<double>::max(), no_index);
}

template <int Dim>
Index FacetTree<Dim>::nearer(const Vec<Dim>& x, double best, Index facet) const {
  return this->search(x, best, facet, false);
}

template <int Dim>
Index FacetTree<Dim>::some_near(const Vec<Dim>& x) const {
  return this->search(x, std::numeric_limits<double>::max(), no_index, true);
}

template <int Dim>
bool FacetTree<Dim>::reaches(const Vec<Dim>& x, double distance) const {
  return this->search(x, distance * distance, no_index, true) != no_index;
}

template <int Dim>
Index FacetTree<Dim>::search(const Vec<Dim>& x, double best, Index facet, bool any_suffices) const {
  const auto visit = [&](const Leaf& leaf) {
    double distances[width];
    for (int i = 0; i < width; i += n_lanes) {
      Lanes w[Dim], edge[Dim - 1][Dim], inverse_length2[Dim == 2 ? 1 : 3];
      for (int k = 0; k < Dim; ++k) {
        w[k] = x[k] - load<Lanes>(&leaf.corner[k][i]);
        for (int e = 0; e < Dim - 1; ++e) edge[e][k] = load<Lanes>(&leaf.edge[e][k][i]);
      }
      for (int e = 0; e < (Dim == 2 ? 1 : 3); ++e) inverse_length2[e] = load<Lanes>(&leaf.inverse_length2[e][i]);
      store(to_facet(w, edge, inverse_length2, load<Lanes>(&leaf.inverse_normal2[i])), &distances[i]);
    }
    for (int i = 0; i < width; ++i)
      if (distances[i] < best || (distances[i] == best && leaf.facet[i] < facet)) {
        best = distances[i];
        facet = leaf.facet[i];
      }
  };
  Stack stack(nodes_);
  stack.add_children(0, x, best);
  while (!stack.is_empty()) {
    const auto [distance2, child, place] = stack.pop();
    if (distance2 > best) continue;
    if (child < 0) visit(leaves_[~child]);
    else stack.add_children(child, x, best);
    if (any_suffices && facet != no_index) break;
  }
  return facet;
}

// The subtrees that the sphere around all points of the group reaches are visited in the order of their distance from
// its centre. Where they are many, the points lie too far apart to be treated together.
template <int Dim>
void FacetTree<Dim>::nearest_of_group(std::span<const Vec<Dim>> points, std::span<const double> limits,
                                      Index* facets) const {
  Lanes x[n_parts][Dim];
  Box<Dim> box;
  for (std::size_t i = 0; i < width; ++i) {
    const Vec<Dim>& point = points[std::min(i, points.size() - 1)];
    box.add(point);
    for (int k = 0; k < Dim; ++k) x[i / n_lanes][k][i % n_lanes] = point[k];
  }
  const Vec<Dim> centre = 0.5 * (box.min + box.max);
  double radius = 0;
  for (const Vec<Dim>& point : points) radius = std::max(radius, (point - centre).norm());
  constexpr double infinite = std::numeric_limits<double>::max();
  const auto limit2 = [&](std::size_t i) {
    return limits.empty() ? infinite : std::min(infinite, limits[i] * limits[i]);
  };
  if (!centre.allFinite() || !(radius < 1e150)) {  // squares would not be finite for the others, either
    for (std::size_t i = 0; i < points.size(); ++i) facets[i] = nearer(points[i], limit2(i), no_index);
    return;
  }
  constexpr int most_leaves = 24;
  Lanes best[n_parts];
  IndexLanes nearest[n_parts];
  double most2 = infinite;
  const auto set_reach = [&] {
    double farthest = best[0][0];
    for (int i = 1; i < width; ++i) farthest = std::max(farthest, best[i / n_lanes][i % n_lanes]);
    const double reach = std::sqrt(farthest) + radius;
    most2 = std::min(infinite, reach * reach);
  };
  for (int p = 0; p < n_parts; ++p) nearest[p] = IndexLanes{} + no_index;
  for (std::size_t i = 0; i < width; ++i) best[i / n_lanes][i % n_lanes] = limit2(std::min(i, points.size() - 1));
  set_reach();
  const auto visit = [&](const Leaf& leaf) {
    for (int f = 0; f < width; ++f) {
      double edge[Dim - 1][Dim], inverse_length2[Dim == 2 ? 1 : 3];
      for (int k = 0; k < Dim; ++k)
        for (int e = 0; e < Dim - 1; ++e) edge[e][k] = leaf.edge[e][k][f];
      for (int e = 0; e < (Dim == 2 ? 1 : 3); ++e) inverse_length2[e] = leaf.inverse_length2[e][f];
      const IndexLanes facet = IndexLanes{} + leaf.facet[f];
      for (int p = 0; p < n_parts; ++p) {
        Lanes w[Dim];
        for (int k = 0; k < Dim; ++k) w[k] = x[p][k] - leaf.corner[k][f];
        const Lanes distances = to_facet<double, Dim>(w, edge, inverse_length2, leaf.inverse_normal2[f]);
        const auto is_nearer = (distances < best[p]) | ((distances == best[p]) & (facet < nearest[p]));
        best[p] = is_nearer ? distances : best[p];
        nearest[p] = is_nearer ? facet : nearest[p];
      }
    }
    set_reach();
  };
  const auto may_be_nearer = [&](const Node& node, int place) {
    IndexLanes nearer{};
    for (int p = 0; p < n_parts; ++p) {
      Lanes sum{};
      for (int k = 0; k < Dim; ++k)
        sum += to_box(static_cast<double>(node.min[k][place]) - x[p][k],
                      x[p][k] - static_cast<double>(node.max[k][place]));
      nearer |= sum <= best[p];
    }
    std::int64_t any = 0;
    for (int i = 0; i < n_lanes; ++i) any |= nearer[i];
    return any != 0;
  };
  int n_leaves = 0;
  Stack stack(nodes_);
  stack.add_children(0, centre, most2);
  while (!stack.is_empty() && n_leaves < most_leaves) {
    const auto [distance2, child, place] = stack.pop();
    if (distance2 > most2 || !may_be_nearer(nodes_[place / width], place % width)) continue;
    if (child < 0) {
      visit(leaves_[~child]);
      ++n_leaves;
    } else stack.add_children(child, centre, most2);
  }
  const bool is_complete = stack.is_empty();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto facet = static_cast<Index>(nearest[i / n_lanes][i % n_lanes]);
    facets[i] = is_complete ? facet : nearer(points[i], best[i / n_lanes][i % n_lanes], facet);
  }
}

template <int Dim>
void FacetTree<Dim>::nearest(std::span<const Vec<Dim>> points, std::span<Index> facets) const {
  for (std::size_t i = 0; i < points.size(); i += width)
    nearest_of_group(points.subspan(i, std::min<std::size_t>(width, points.size() - i)), {}, &facets[i]);
}

template <int Dim>
void FacetTree<Dim>::nearest_within(std::span<const Vec<Dim>> points, std::span<const double> limits,
                                    std::span<Index> facets) const {
  for (std::size_t i = 0; i < points.size(); i += width) {
    const std::size_t n = std::min<std::size_t>(width, points.size() - i);
    nearest_of_group(points.subspan(i, n), limits.subspan(i, n), &facets[i]);
  }
}

template Index FacetTree<2>::nearest(const Vec<2>&) const;
template Index FacetTree<3>::nearest(const Vec<3>&) const;
template Index FacetTree<2>::some_near(const Vec<2>&) const;
template Index FacetTree<3>::some_near(const Vec<3>&) const;
template bool FacetTree<2>::reaches(const Vec<2>&, double) const;
template bool FacetTree<3>::reaches(const Vec<3>&, double) const;
template void FacetTree<2>::nearest(std::span<const Vec<2>>, std::span<Index>) const;
template void FacetTree<3>::nearest(std::span<const Vec<3>>, std::span<Index>) const;
template void FacetTree<2>::nearest_within(std::span<const Vec<2>>, std::span<const double>, std::span<Index>) const;
template void FacetTree<3>::nearest_within(std::span<const Vec<3>>, std::span<const double>, std::span<Index>) const;

}  // namespace shellmatch
