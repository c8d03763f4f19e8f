#include "geometry/implicit/lattice.h"

#include "base/error.h"
#include "base/large_vector.h"
#include "base/parallel.h"
#include "base/stop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace shellmatch {

namespace {

// The neighbours of a site of the body-centred cubic lattice. With the lattice edges between them they form a
// triangulated sphere, the link of the site.
constexpr int n_lattice_neighbours = 14;

// Their offsets in half sides of a cube: 8 across short edges, then 6 across long ones.
constexpr std::array<std::array<int, 3>, n_lattice_neighbours> lattice_neighbour_offsets{{{-1, -1, -1},
                                                                                          {1, -1, -1},
                                                                                          {-1, 1, -1},
                                                                                          {1, 1, -1},
                                                                                          {-1, -1, 1},
                                                                                          {1, -1, 1},
                                                                                          {-1, 1, 1},
                                                                                          {1, 1, 1},
                                                                                          {-2, 0, 0},
                                                                                          {2, 0, 0},
                                                                                          {0, -2, 0},
                                                                                          {0, 2, 0},
                                                                                          {0, 0, -2},
                                                                                          {0, 0, 2}}};

bool are_neighbours(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  int squared = 0;
  for (int k = 0; k < 3; ++k) squared += (a[k] - b[k]) * (a[k] - b[k]);
  return squared == 3 || squared == 4;
}

// Bit r of entry q is set if the neighbours q and r are neighbours of each other.
const std::array<unsigned, n_lattice_neighbours>& links() {
  static const auto table = [] {
    std::array<unsigned, n_lattice_neighbours> t{};
    for (int q = 0; q < n_lattice_neighbours; ++q)
      for (int r = 0; r < n_lattice_neighbours; ++r)
        if (are_neighbours(lattice_neighbour_offsets[q], lattice_neighbour_offsets[r])) t[q] |= 1u << r;
    return t;
  }();
  return table;
}

// True if the set of neighbours (a bit for each) is not empty and connected along lattice edges.
bool connected(unsigned set) {
  unsigned reached = set & (~set + 1);  // its lowest bit
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (int q = 0; q < n_lattice_neighbours; ++q)
      if (before >> q & 1) reached |= links()[q] & set;
  }
  return set != 0 && reached == set;
}

// True if the surface divides the link, whose vertices have these values, into two connected parts. Then the
// surface is a disc near the point, also after the point has been moved onto it.
bool link_is_cut_in_two(const std::array<double, n_lattice_neighbours>& values) {
  unsigned inside = 0, outside = 0;
  for (int q = 0; q < n_lattice_neighbours; ++q) {
    inside |= static_cast<unsigned>(values[q] < 0) << q;
    outside |= static_cast<unsigned>(values[q] > 0) << q;
  }
  constexpr unsigned all = (1u << n_lattice_neighbours) - 1;
  return connected(inside) && connected(outside) && connected(all & ~inside) && connected(all & ~outside);
}

using Site = std::int64_t;  // even: corner of a cube; odd: centre; divided by two: linear index of the cube
constexpr double low = 0.04, high = 0.96;
constexpr double short_threshold = 0.41, long_threshold = 0.25;  // fractions of an edge
constexpr int block = 4;  // cubes along a side of a block; blocks far from the surface are skipped

}  // namespace

class Lattice::Body {
 public:
  Body(const ImplicitFunction& f, double spacing)
      : n_(block * static_cast<int>(std::ceil((high - low) / (block * spacing))) + 1), spacing_(spacing) {
    evaluate(f);
  }

  Surface<3> triangulate() {
    move_close_sites();
    for_each_tetrahedron([this](const std::array<Site, 4>& t) { cut(t); });
    for (const auto& [key, facet] : facets_) surface_.facets.push_back(facet);
    for (const auto& [site, moved] : moved_) values_[site] = moved.value;
    moved_.clear();
    vertices_.clear();
    facets_.clear();
    return std::exchange(surface_, {});
  }

  void keep_points_near(const std::vector<Vec<3>>& places) {
    for (const Vec<3>& x : places) {
      const Vec<3> at = (x - Vec<3>::Constant(low)) / spacing_;
      for (int c = 0; c < 64; ++c) {
        const int i = static_cast<int>(std::floor(at[0])) + c % 4 - 1,
                  j = static_cast<int>(std::floor(at[1])) + c / 4 % 4 - 1,
                  k = static_cast<int>(std::floor(at[2])) + c / 16 - 1;
        if (std::min({i, j, k}) < 0 || std::max({i, j, k}) >= n_) continue;
        kept_.insert(site(i, j, k, false));
        kept_.insert(site(i, j, k, true));
      }
    }
  }
  void keep_all_points() { keeps_all_ = true; }

 private:
  struct Moved {
    Vec<3> to;
    double value;  // where it was
  };

  Site site(int i, int j, int k, bool centre) const {
    return 2 * ((static_cast<Site>(k) * n_ + j) * n_ + i) + (centre ? 1 : 0);
  }
  Vec<3> rest_position(Site s) const {
    const Site c = s / 2;
    const Vec<3> corner(static_cast<double>(c % n_), static_cast<double>(c / n_ % n_),
                        static_cast<double>(c / (static_cast<Site>(n_) * n_)));
    return Vec<3>::Constant(low) + spacing_ * (corner + Vec<3>::Constant(s % 2 ? 0.5 : 0.0));
  }
  Vec<3> position(Site s) const {
    const auto moved = moved_.find(s);
    return moved == moved_.end() ? rest_position(s) : moved->second.to;
  }

  // A block, with a margin of one cube, has one sign if |f| at its centre exceeds the Lipschitz constant 2
  // times half its diagonal. All its sites then get the value of the centre.
  void evaluate(const ImplicitFunction& f) {
    const int n_blocks = (n_ + block - 1) / block;
    values_.resize(2 * static_cast<std::size_t>(n_) * n_ * n_);
    std::vector<char> active(static_cast<std::size_t>(n_blocks) * n_blocks * n_blocks);
    parallel_for(
        active.size(),
        [&](std::size_t b) {
          const int first[3] = {static_cast<int>(b) % n_blocks * block,
                                static_cast<int>(b) / n_blocks % n_blocks * block,
                                static_cast<int>(b) / (n_blocks * n_blocks) * block};
          const Vec<3> middle =
              rest_position(site(first[0], first[1], first[2], false)) + Vec<3>::Constant(0.5 * block * spacing_);
          const double far = f(middle);
          active[b] = std::abs(far) < 2 * std::sqrt(3.0) * (0.5 * block + 1) * spacing_;
          for (int k = first[2]; k < std::min(first[2] + block, n_); ++k)
            for (int j = first[1]; j < std::min(first[1] + block, n_); ++j)
              for (int i = first[0]; i < std::min(first[0] + block, n_); ++i)
                for (const bool centre : {false, true}) {
                  const Site s = site(i, j, k, centre);
                  // An exact zero would be a vertex that belongs to no cut; it is treated as barely outside.
                  const double value = active[b] ? f(rest_position(s)) : far;
                  values_[s] = value == 0 ? 1e-300 : value;
                }
        },
        1);
    for (std::size_t b = 0; b < active.size(); ++b)
      if (active[b])
        blocks_.push_back({static_cast<int>(b) % n_blocks * block, static_cast<int>(b) / n_blocks % n_blocks * block,
                           static_cast<int>(b) / (n_blocks * n_blocks) * block});
  }

  void for_each_cube(auto&& body) {
    for (const auto& first : blocks_) {
      stop_if_wanted();
      for (int k = first[2]; k < std::min(first[2] + block, n_ - 1); ++k)
        for (int j = first[1]; j < std::min(first[1] + block, n_ - 1); ++j)
          for (int i = first[0]; i < std::min(first[0] + block, n_ - 1); ++i) body(std::array<int, 3>{i, j, k});
    }
  }

  // Each of the three upper faces of a cube lies between two centres, which form a tetrahedron with every
  // edge of the face.
  void for_each_tetrahedron(auto&& body) {
    for_each_cube([&](const std::array<int, 3>& c) {
      for (int axis = 0; axis < 3; ++axis) {
        std::array<int, 3> next = c;
        if (++next[axis] >= n_ - 1) continue;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<Site, 4> ring;
        for (int q = 0; q < 4; ++q) {
          std::array<int, 3> corner = next;
          corner[u] += q == 1 || q == 2;
          corner[v] += q >= 2;
          ring[q] = site(corner[0], corner[1], corner[2], false);
        }
        const Site lower = site(c[0], c[1], c[2], true), upper = site(next[0], next[1], next[2], true);
        // Nearly everywhere all four tetrahedra lie on one side.
        const auto all = [&](const auto& is_there) {
          return is_there(lower) && is_there(upper) && std::all_of(ring.begin(), ring.end(), is_there);
        };
        if (all([&](Site s) { return values_[s] > 0; }) || all([&](Site s) { return values_[s] < 0; })) continue;
        for (int q = 0; q < 4; ++q) body({lower, upper, ring[q], ring[(q + 1) % 4]});
      }
    });
  }

  // The site at `offset`, in half sides of a cube, from the site s of the cube c; -1 beyond the lattice.
  Site neighbour(const std::array<int, 3>& c, bool centre, const std::array<int, 3>& offset) const {
    const bool other = offset[0] % 2 != 0;
    std::array<int, 3> d;
    for (int k = 0; k < 3; ++k) {
      const int twice = 2 * c[k] + (centre ? 1 : 0) + offset[k];
      if (twice < 0 || twice >= 2 * n_) return -1;
      d[k] = twice / 2;
    }
    return site(d[0], d[1], d[2], centre != other);
  }

  // Sites are moved one by one in a fixed order. A moved site lies on the surface, and its edges are no
  // longer cut. If two sheets of the surface pass close to a site, moving it would connect them; a site is
  // therefore moved only if the surface divides the sphere of its neighbours into two connected parts.
  void move_close_sites() {
    if (keeps_all_) return;
    for_each_cube([&](const std::array<int, 3>& c) {
      for (const bool centre : {false, true}) {
        const Site s = site(c[0], c[1], c[2], centre);
        if (kept_.contains(s)) continue;
        const Vec<3> x = rest_position(s);
        double least = std::numeric_limits<double>::infinity();
        Vec<3> target;
        std::array<double, n_lattice_neighbours> around;
        bool complete = true;
        for (int q = 0; q < n_lattice_neighbours && complete; ++q) {
          const Site t = neighbour(c, centre, lattice_neighbour_offsets[q]);
          complete = t >= 0;
          if (!complete) break;
          around[q] = values_[t];
          if (values_[s] * values_[t] >= 0) continue;
          const double fraction = values_[s] / (values_[s] - values_[t]);
          const Vec<3> way = fraction * (rest_position(t) - x);
          if (fraction < (q < 8 ? short_threshold : long_threshold) && way.norm() < least) {
            least = way.norm();
            target = x + way;
          }
        }
        if (complete && std::isfinite(least) && link_is_cut_in_two(around)) {
          moved_.emplace(s, Moved{target, values_[s]});
          values_[s] = 0;
        }
      }
    });
  }

  // The vertex on the edge from a to b, or on the site a where b == a.
  Index vertex(Site a, Site b) {
    if (a > b) std::swap(a, b);
    const auto key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
    const auto [entry, is_new] = vertices_.try_emplace(key, static_cast<Index>(surface_.vertices.size()));
    if (is_new) {
      const Vec<3> pa = position(a);
      const double fraction = a == b ? 0 : values_[a] / (values_[a] - values_[b]);
      surface_.vertices.push_back(pa + fraction * (position(b) - pa));
    }
    return entry->second;
  }

  void add_facet(Index a, Index b, Index c, const Vec<3>& outward) {
    const std::vector<Vec<3>>& x = surface_.vertices;
    if ((x[b] - x[a]).cross(x[c] - x[a]).dot(outward) < 0) std::swap(b, c);
    std::array<Index, 3> key{a, b, c};
    std::sort(key.begin(), key.end());
    // Two tetrahedra inside the body may share a face of three moved sites. Both report this face, and it is
    // not part of the surface.
    if (!facets_.emplace(key, std::array<Index, 3>{a, b, c}).second) facets_.erase(key);
  }

  void cut(const std::array<Site, 4>& t) {
    std::array<Site, 4> inside, outside, on;
    int n_inside = 0, n_outside = 0, n_on = 0;
    Vec<3> outward = Vec<3>::Zero();
    for (const Site s : t) {
      if (values_[s] < 0) inside[n_inside++] = s;
      if (values_[s] > 0) outside[n_outside++] = s;
      if (values_[s] == 0) on[n_on++] = s;
    }
    if (n_inside == 0 || (n_outside == 0 && n_on < 3)) return;
    for (int i = 0; i < n_inside; ++i) outward -= position(inside[i]) / n_inside;
    if (n_outside == 0) {
      outward += (position(on[0]) + position(on[1]) + position(on[2])) / 3;
    } else {
      for (int i = 0; i < n_outside; ++i) outward += position(outside[i]) / n_outside;
    }
    std::array<Index, 4> corners;
    int n = 0;
    for (int i = 0; i < n_on; ++i) corners[n++] = vertex(on[i], on[i]);
    for (int i = 0; i < n_inside; ++i)
      // Reversed for the second corner inside, so that four cuts are in cyclic order.
      for (int j = 0; j < n_outside; ++j) corners[n++] = vertex(inside[i], outside[i % 2 ? n_outside - 1 - j : j]);
    if (n == 3) {
      add_facet(corners[0], corners[1], corners[2], outward);
      return;
    }
    SHELLMATCH_CHECK(n == 4, "a tetrahedron is cut in a triangle or a quadrilateral");
    const std::vector<Vec<3>>& x = surface_.vertices;
    const int first = (x[corners[0]] - x[corners[2]]).norm() < (x[corners[1]] - x[corners[3]]).norm() ? 0 : 1;
    add_facet(corners[first], corners[first + 1], corners[first + 2], outward);
    add_facet(corners[first], corners[first + 2], corners[(first + 3) % 4], outward);
  }

  int n_;  // sites along an axis
  double spacing_;
  LargeVector<double> values_;
  std::vector<std::array<int, 3>> blocks_;
  std::unordered_map<Site, Moved> moved_;
  std::unordered_set<Site> kept_;  // never moved
  bool keeps_all_ = false;
  std::unordered_map<std::uint64_t, Index> vertices_;
  std::map<std::array<Index, 3>, std::array<Index, 3>> facets_;  // by sorted corners, which fixes the order
  Surface<3> surface_;
};

Lattice::Lattice(const ImplicitFunction& f, double spacing) : body_(std::make_unique<Body>(f, spacing)) {}
Lattice::~Lattice() = default;
Surface<3> Lattice::triangulate() { return body_->triangulate(); }
void Lattice::keep_points_near(const std::vector<Vec<3>>& places) { body_->keep_points_near(places); }
void Lattice::keep_all_points() { body_->keep_all_points(); }

}  // namespace shellmatch
