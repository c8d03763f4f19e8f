#include "geometry/distance/facet_tree.h"

#include "base/stop.h"
#include "geometry/surface/facet_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

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
  // Small, and side by side: splitting large surfaces takes as long as memory does. Rounding the centres changes the
  // tree, not what it finds.
  struct Entry {
    std::array<float, Dim> centre;  // of the facet's box, in [-1, 1]
    Index facet;
  };
  using Range = std::span<Entry>;

  const Surface<Dim>& surface;
  FacetTree& tree;
  std::vector<Entry> order = {};  // those of a subtree consecutively
  double scale = 0;               // largest extent of the surface

  Box<Dim> box(Index f) const {
    Box<Dim> box;
    for (const Index v : surface.facets[f]) box.add(surface.vertices[v]);
    return box;
  }
  Box<Dim> box(Range facets) const {
    Box<Dim> all;
    for (const Entry& e : facets)
      for (const Index v : surface.facets[e.facet]) all.add(surface.vertices[v]);
    return all;
  }

  /// Splits a range along the longest side of the box of the centres. The first part fills complete leaves.
  std::array<Range, 2> split(Range facets) const {
    std::array<float, Dim> low = facets.front().centre, high = low;
    for (const Entry& e : facets)
      for (int k = 0; k < Dim; ++k) {
        low[k] = std::min(low[k], e.centre[k]);
        high[k] = std::max(high[k], e.centre[k]);
      }
    int axis = 0;
    for (int k = 1; k < Dim; ++k)
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    const std::size_t n_leaves = (facets.size() + width - 1) / width, middle = (n_leaves / 2) * width;
    std::nth_element(facets.begin(), facets.begin() + static_cast<std::ptrdiff_t>(middle), facets.end(),
                     [axis](const Entry& a, const Entry& b) {
                       const float x = a.centre[axis], y = b.centre[axis];
                       return x != y ? x < y : a.facet < b.facet;
                     });
    return {facets.first(middle), facets.subspan(middle)};
  }

  Index add_leaf(Range facets) {
    const auto index = static_cast<Index>(tree.leaves_.size());
    Leaf& leaf = tree.leaves_.emplace_back();
    for (int lane = 0; lane < width; ++lane) {
      const bool filled = static_cast<std::size_t>(lane) < facets.size();
      const Index f = facets[filled ? lane : 0].facet;
      leaf.facet[lane] = f;
      const Vec<Dim>& a = surface.vertices[surface.facets[f][0]];
      std::array<Vec<Dim>, Dim - 1> edge;
      for (int e = 0; e < Dim - 1; ++e) edge[e] = surface.vertices[surface.facets[f][e + 1]] - a;
      for (int i = 0; i < Dim; ++i) {
        leaf.corner[i][lane] = a[i];
        for (int e = 0; e < Dim - 1; ++e) leaf.edge[e][i][lane] = edge[e][i];
      }
      for (int e = 0; e < Dim - 1; ++e) leaf.inverse_length2[e][lane] = inverse_or_zero(edge[e].squaredNorm());
      if constexpr (Dim == 3) {
        leaf.inverse_length2[2][lane] = inverse_or_zero((edge[1] - edge[0]).squaredNorm());
        leaf.inverse_normal2[lane] =
            is_degenerate(edge[0], edge[1]) ? 0 : inverse_or_zero(edge[0].cross(edge[1]).squaredNorm());
      }
    }
    return ~index;
  }

  /// \param bounds takes the box of the facets
  Index add(Range facets, Box<Dim>& bounds) {
    if (facets.size() <= width && !tree.nodes_.empty()) {
      bounds = box(facets);
      return add_leaf(facets);
    }
    if (facets.size() > 4096) stop_if_wanted();
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
      Box<Dim> b;
      const Index child = filled ? add(parts[i], b) : 0;
      if (filled) {
        bounds.add(b.min);
        bounds.add(b.max);
      }
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
  Builder builder{surface, *this};
  builder.order.reserve(surface.facets.size());
  leaves_.reserve((surface.facets.size() + width - 1) / width);
  const Box<Dim> all = bounding_box(surface.vertices);
  builder.scale = (all.max - all.min).maxCoeff();
  const double per_length = inverse_or_zero(builder.scale);
  StopCheck stop_check;
  for (Index f = 0; f < static_cast<Index>(surface.facets.size()); ++f) {
    stop_check();
    const Box<Dim> box = builder.box(f);
    auto& entry = builder.order.emplace_back();
    for (int k = 0; k < Dim; ++k)
      entry.centre[k] = static_cast<float>((box.min[k] - all.min[k] + box.max[k] - all.max[k]) * per_length);
    entry.facet = f;
  }
  Box<Dim> bounds;
  builder.add(builder.order, bounds);
}

template FacetTree<2>::FacetTree(const Surface<2>&);
template FacetTree<3>::FacetTree(const Surface<3>&);

}  // namespace shellmatch
