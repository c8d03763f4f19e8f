#include "geometry/repair/flat_triangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace shellmatch {

namespace {

using Facet = std::array<Index, 3>;

// A facet seen from its longest edge, which runs from corner `begin` to the next; `height` is that of the third corner.
struct Profile {
  int begin = 0;
  double longest = 0, shortest = 0, height = 0;
  int shortest_begin = 0;
};

Profile profile_of(const std::vector<Vec<3>>& x, const Facet& facet) {
  Profile p;
  for (int k = 0; k < 3; ++k) {
    const double length = (x[facet[(k + 1) % 3]] - x[facet[k]]).norm();
    if (k == 0 || length > p.longest) {
      p.longest = length;
      p.begin = k;
    }
    if (k == 0 || length <= p.shortest) {
      p.shortest = length;
      p.shortest_begin = k;
    }
  }
  if (!(p.longest > 0)) return p;
  // By the shortest edge, which is another one than the longest: equal ones are the first and the last.
  const Vec<3> e = (x[facet[(p.begin + 1) % 3]] - x[facet[p.begin]]) / p.longest;
  const Vec<3> s = x[facet[(p.shortest_begin + 1) % 3]] - x[facet[p.shortest_begin]];
  p.height = e.cross(s).norm();
  return p;
}

bool is_flat(const Profile& p, double height) { return p.height <= std::max(height, 1e-15 * p.longest); }

class Dissolver {
 public:
  Dissolver(Surface<3>& surface, double height, const std::vector<Index>& flat)
      : x_(surface.vertices),
        facets_(surface.facets),
        height_(height),
        alive_(surface.facets.size(), true),
        around_(surface.vertices.size()) {
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (const Index v : facets_[f]) around_[v].push_back(static_cast<Index>(f));
    for (const Index f : flat) look_at(f);
  }

  // Longest edges first: each step leaves flat triangles with shorter ones, or fewer. The bound is for those that turn
  // in a circle.
  void run(std::size_t most_steps) {
    for (std::size_t step = 0; step < most_steps && !todo_.empty(); ++step) {
      const auto [length, f] = todo_.top();
      todo_.pop();
      if (!alive_[f]) continue;
      const Profile p = profile_of(x_, facets_[f]);
      if (p.longest != length || !is_flat(p, height_)) continue;  // it has changed since
      if (p.shortest <= height_) merge(facets_[f][p.shortest_begin], facets_[f][(p.shortest_begin + 1) % 3]);
      else split_neighbour(f, p.begin);
    }
    std::size_t n = 0;
    for (std::size_t f = 0; f < facets_.size(); ++f)
      if (alive_[f]) facets_[n++] = facets_[f];
    facets_.resize(n);
  }

 private:
  void look_at(Index f) {
    const Profile p = profile_of(x_, facets_[f]);
    if (is_flat(p, height_)) todo_.emplace(p.longest, f);
  }

  bool has(Index f, Index v) const { return alive_[f] && std::ranges::find(facets_[f], v) != facets_[f].end(); }

  void replace(Index f, Index before, Index after) {
    std::replace(facets_[f].begin(), facets_[f].end(), before, after);
    around_[after].push_back(f);
  }

  // The vertex with fewer facets goes: the hub of a fan of very many stays.
  void merge(Index v, Index w) {
    if (around_[v].size() < around_[w].size()) std::swap(v, w);
    for (const Index f : std::exchange(around_[w], {})) {
      if (!has(f, w)) continue;
      if (has(f, v)) {
        alive_[f] = false;
      } else {
        replace(f, w, v);
        look_at(f);
      }
    }
  }

  // Another triangle at the edge a -> c: one with area and opposite direction where there is any.
  Index beyond(Index f, Index a, Index c) const {
    Index best = no_index;
    int best_score = -1;
    for (const Index g : around_[around_[a].size() < around_[c].size() ? a : c]) {
      if (g == f || !has(g, a) || !has(g, c)) continue;
      const auto at = std::ranges::find(facets_[g], c);
      const Index after_c = facets_[g][static_cast<std::size_t>(at - facets_[g].begin() + 1) % 3];
      const int score = (after_c == a ? 2 : 0) + (is_flat(profile_of(x_, facets_[g]), height_) ? 0 : 1);
      if (score > best_score) {
        best_score = score;
        best = g;
      }
    }
    return best;
  }

  void split_neighbour(Index f, int begin) {
    const Index a = facets_[f][begin], c = facets_[f][(begin + 1) % 3], b = facets_[f][(begin + 2) % 3];
    const Index g = beyond(f, a, c);
    alive_[f] = false;
    if (g == no_index) return;
    if (has(g, b)) {  // the same three corners
      alive_[g] = false;
      return;
    }
    const auto h = static_cast<Index>(facets_.size());
    facets_.push_back(facets_[g]);
    alive_.push_back(true);
    for (const Index v : facets_[h]) around_[v].push_back(h);
    replace(g, c, b);
    replace(h, a, b);
    look_at(g);
    look_at(h);
  }

  const std::vector<Vec<3>>& x_;
  std::vector<Facet>& facets_;
  double height_;
  std::vector<bool> alive_;
  std::vector<std::vector<Index>> around_;  ///< facets of each vertex, and some that have left it
  std::priority_queue<std::pair<double, Index>> todo_;
};

}  // namespace

double negligible_length(const std::vector<Vec<3>>& vertices) {
  const Box<3> box = bounding_box(vertices);
  return std::min(std::ldexp(box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff(), -22), 1e-6 * box.diagonal());
}

std::vector<Index> flat_triangles(const Surface<3>& surface, double height) {
  std::vector<Index> flat;
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (is_flat(profile_of(surface.vertices, surface.facets[f]), height)) flat.push_back(static_cast<Index>(f));
  return flat;
}

std::size_t dissolve_flat_triangles(Surface<3>& surface, double height) {
  const std::vector<Index> flat = flat_triangles(surface, height);
  if (flat.empty() || flat.size() == surface.facets.size()) return 0;
  Dissolver(surface, height, flat).run(100 * flat.size() + 1000);
  remove_folded_pairs(surface);
  take_apart(surface);
  return flat.size();
}

std::size_t remove_folded_pairs(Surface<3>& surface) {
  struct Turned {
    Facet corners;
    bool even;
    std::size_t facet;
    auto operator<=>(const Turned&) const = default;
  };
  std::vector<Turned> all;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    Facet c = surface.facets[f];
    const bool even = (c[0] < c[1]) + (c[1] < c[2]) + (c[2] < c[0]) == 2;
    std::sort(c.begin(), c.end());
    all.push_back({c, even, f});
  }
  std::sort(all.begin(), all.end());
  std::vector<bool> goes(all.size(), false);
  for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
    std::size_t middle = i;  // the first that is even
    for (j = i; j < all.size() && all[j].corners == all[i].corners; ++j) middle += all[j].even ? 0 : 1;
    for (std::size_t k = 0; k < std::min(middle - i, j - middle); ++k)
      goes[all[i + k].facet] = goes[all[middle + k].facet] = true;
  }
  std::vector<Facet> kept;
  for (std::size_t f = 0; f < goes.size(); ++f)
    if (!goes[f]) kept.push_back(surface.facets[f]);
  const std::size_t n = goes.size() - kept.size();
  if (n > 0) surface.facets = std::move(kept);
  return n;
}

}  // namespace shellmatch
