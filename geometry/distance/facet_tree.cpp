#include "geometry/distance/facet_tree.h"

#include "geometry/surface/facet_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shellmatch {

namespace {

/// Single precision bounds below and above x, by a margin of at least 1e-6 of `scale`.
float below(double x, double scale) {
  return std::nextafter(static_cast<float>(x - 1e-6 * scale), -std::numeric_limits<float>::infinity());
}
float above(double x, double scale) { return -below(-x, scale); }

double inverse_or_zero(double x) { return x > 0 ? 1 / x : 0; }

}  // namespace

/// Builds the tree from the root downwards.
template <int Dim>
struct FacetTree<Dim>::Builder {
  const Surface<Dim>& surface;
  FacetTree& tree;
  std::vector<Index> order;           // facets, those of a subtree consecutively
  std::vector<Vec<Dim>> centre = {};  // of the facets' boxes, times two
  double scale = 0;                   // largest extent of the surface

  using Range = std::span<Index>;

  Box<Dim> box(Range facets) const {
    Box<Dim> box;
    for (const Index f : facets)
      for (const Index v : surface.facets[f]) box.add(surface.vertices[v]);
    return box;
  }

  /// Splits a range along the longest side of the box of the centres. The first part fills complete leaves.
  std::array<Range, 2> split(Range facets) const {
    Box<Dim> box;
    for (const Index f : facets) box.add(centre[f]);
    int axis;
    (box.max - box.min).maxCoeff(&axis);
    const std::size_t n_leaves = (facets.size() + width - 1) / width, middle = (n_leaves / 2) * width;
    std::nth_element(facets.begin(), facets.begin() + static_cast<std::ptrdiff_t>(middle), facets.end(),
                     [&](Index f, Index g) {
                       const double x = centre[f][axis], y = centre[g][axis];
                       return x != y ? x < y : f < g;
                     });
    return {facets.first(middle), facets.subspan(middle)};
  }

  Index add_leaf(Range facets) {
    const auto index = static_cast<Index>(tree.leaves_.size());
    Leaf& leaf = tree.leaves_.emplace_back();
    for (int lane = 0; lane < width; ++lane) {
      const bool filled = static_cast<std::size_t>(lane) < facets.size();
      const Index f = facets[filled ? lane : 0];
      leaf.facet[lane] = f;
      const Vec<Dim>& a = surface.vertices[surface.facets[f][0]];
      std::array<Vec<Dim>, Dim - 1> edge;
      for (int e = 0; e < Dim - 1; ++e) edge[e] = surface.vertices[surface.facets[f][e + 1]] - a;
      for (int i = 0; i < Dim; ++i) {
        leaf.corner[i][lane] = a[i];
        for (int e = 0; e < Dim - 1; ++e) leaf.edge[e][i][lane] = edge[e][i];
      }
      for (int e = 0; e < Dim - 1; ++e)
        leaf.inverse_length2[e][lane] = inverse_or_zero(edge[e].squaredNorm());
      if constexpr (Dim == 3) {
        leaf.inverse_length2[2][lane] = inverse_or_zero((edge[1] - edge[0]).squaredNorm());
        leaf.inverse_normal2[lane] =
            is_degenerate(edge[0], edge[1]) ? 0 : inverse_or_zero(edge[0].cross(edge[1]).squaredNorm());
      }
    }
    return ~index;
  }

  Index add(Range facets) {
    if (facets.size() <= width && !tree.nodes_.empty()) return add_leaf(facets);
    const auto index = static_cast<Index>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    std::vector<Range> parts{facets};
    for (int level = 0; level < 3; ++level) {
      std::vector<Range> halves;
      for (const Range part : parts) {
        if (part.size() <= width) {
          halves.push_back(part);
        } else {
          for (const Range half : split(part)) halves.push_back(half);
        }
      }
      parts = std::move(halves);
    }
    for (int i = 0; i < width; ++i) {
      const bool filled = static_cast<std::size_t>(i) < parts.size();
      const Index child = filled ? add(parts[i]) : 0;
      const Box<Dim> b = filled ? box(parts[i]) : Box<Dim>{};
      Node& node = tree.nodes_[index];  // not earlier: add() may reallocate the nodes
      node.child[i] = child;
      for (int k = 0; k < Dim; ++k) {
        node.min[k][i] = filled ? below(b.min[k], scale) : std::numeric_limits<float>::infinity();
        node.max[k][i] = filled ? above(b.max[k], scale) : std::numeric_limits<float>::infinity();
      }
    }
    return index;
  }
};

template <int Dim>
FacetTree<Dim>::FacetTree(const Surface<Dim>& surface) {
  Builder builder{surface, *this, std::vector<Index>(surface.facets.size())};
  std::iota(builder.order.begin(), builder.order.end(), 0);
  for (Index& f : builder.order) {
    const Box<Dim> box = builder.box({&f, 1});
    builder.centre.push_back(box.min + box.max);
  }
  const Box<Dim> all = builder.box(builder.order);
  builder.scale = (all.max - all.min).maxCoeff();
  builder.add(builder.order);
}

template <int Dim>
void FacetTree<Dim>::squared_distances(const Node& node, const Vec<Dim>& x, Lanes& result) {
  Lanes sum{};
  for (int k = 0; k < Dim; ++k) {
    const Lanes before = __builtin_convertvector(node.min[k], Lanes) - x[k];
    const Lanes after = x[k] - __builtin_convertvector(node.max[k], Lanes);
    Lanes gap = before > after ? before : after;
    gap = gap > 0 ? gap : Lanes{};
    sum += gap * gap;
  }
  result = sum;
}

// The case distinctions of closest_point_on_facet(), made by selection.
template <int Dim>
void FacetTree<Dim>::squared_distances(const Leaf& leaf, const Vec<Dim>& x, Lanes& result) {
  const Lanes zero{}, one = zero + 1;
  // Square of the distance from v to the segment from 0 to e.
  const auto to_segment = [&](const Lanes(&v)[Dim], const Lanes(&e)[Dim], const Lanes& inverse_length2,
                              Lanes& distance2) {
    Lanes along = v[0] * e[0];
    for (int k = 1; k < Dim; ++k) along += v[k] * e[k];
    along *= inverse_length2;
    along = along > zero ? along : zero;
    along = along < one ? along : one;
    distance2 = zero;
    for (int k = 0; k < Dim; ++k) {
      const Lanes difference = v[k] - along * e[k];
      distance2 += difference * difference;
    }
  };
  Lanes w[Dim];
  for (int k = 0; k < Dim; ++k) w[k] = x[k] - leaf.corner[k];
  to_segment(w, leaf.edge[0], leaf.inverse_length2[0], result);
  if constexpr (Dim == 3) {
    const Lanes(&e1)[3] = leaf.edge[0];
    const Lanes(&e2)[3] = leaf.edge[1];
    const Lanes e3[3] = {e2[0] - e1[0], e2[1] - e1[1], e2[2] - e1[2]};
    const Lanes w3[3] = {w[0] - e1[0], w[1] - e1[1], w[2] - e1[2]};
    Lanes other;
    to_segment(w, e2, leaf.inverse_length2[1], other);
    result = other < result ? other : result;
    to_segment(w3, e3, leaf.inverse_length2[2], other);
    result = other < result ? other : result;

    // Weights of the second and the third corner: (w x e2) . n / |n|^2 and (e1 x w) . n / |n|^2, n = e1 x e2.
    const Lanes n[3] = {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2],
                        e1[0] * e2[1] - e1[1] * e2[0]};
    const Lanes m[3] = {w[1] * n[2] - w[2] * n[1], w[2] * n[0] - w[0] * n[2], w[0] * n[1] - w[1] * n[0]};
    const Lanes beta = -(m[0] * e2[0] + m[1] * e2[1] + m[2] * e2[2]) * leaf.inverse_normal2;
    const Lanes gamma = (m[0] * e1[0] + m[1] * e1[1] + m[2] * e1[2]) * leaf.inverse_normal2;
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
}

template <int Dim>
Index FacetTree<Dim>::nearest(const Vec<Dim>& x) const {
  struct Entry {
    double distance2;
    Index child;
  };
  // A balanced tree over 32-bit facet numbers has at most eleven levels, and each leaves at most seven
  // entries.
  std::array<Entry, 96> stack;
  int n_entries = 0;
  stack[n_entries++] = {0, 0};
  double best = std::numeric_limits<double>::max();
  Index facet = no_index;

  const auto visit_leaf = [&](const Leaf& leaf) {
    Lanes distances;
    squared_distances(leaf, x, distances);
    for (int i = 0; i < width; ++i)
      if (distances[i] < best || (distances[i] == best && leaf.facet[i] < facet))
        best = distances[i], facet = leaf.facet[i];
  };

  while (n_entries > 0) {
    const Entry entry = stack[--n_entries];
    if (entry.distance2 > best) continue;
    if (entry.child < 0) {
      visit_leaf(leaves_[~entry.child]);
      continue;
    }
    const Node& node = nodes_[entry.child];
    Lanes distances;
    squared_distances(node, x, distances);
    const int first = n_entries;
    for (int i = 0; i < width; ++i) {
      if (!(distances[i] <= best)) continue;
      int place = n_entries++;
      for (; place > first && stack[place - 1].distance2 < distances[i]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {distances[i], node.child[i]};
    }
  }
  return facet;
}

template class FacetTree<2>;
template class FacetTree<3>;

}  // namespace shellmatch
