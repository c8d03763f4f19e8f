#pragma once
/// \file
/// Which part of space belongs to what is known of a surface, and which to the rest: what was made up to close it, or
/// lies inside the body.

#include "geometry/distance/facet_tree.h"
#include "geometry/surface/surface.h"

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace shellmatch {

/// The points that are nearer to the observed than to the unobserved part of a surface, whose connected parts are its
/// gaps. Copies share the data.
template <int Dim>
class ObservedPart {
 public:
  /// Of a surface that is observed everywhere: all of space.
  ObservedPart() = default;
  explicit ObservedPart(const Evidence<Dim>& evidence);

  bool is_all() const { return parts_ == nullptr; }

  struct Gap {
    /// Distance to the unobserved part less distance to the observed one: at a point of the observed surface its
    /// distance to the nearest gap, 0 along the edge of a gap, negative beyond, infinite where all is observed. The
    /// Lipschitz constant is 2.
    double margin = std::numeric_limits<double>::infinity();
    /// How far the centres of the facets of the nearest gap reach from the observed part: half of the gap's width or
    /// somewhat less.
    double half_width = 0;
  };
  Gap nearest_gap(const Vec<Dim>& x) const;
  /// The same of several points, faster the nearer they lie to each other. Where the margin is at least `most`, it is
  /// infinite. \param gaps one for each
  void nearest_gaps(std::span<const Vec<Dim>> x, double most, std::span<Gap> gaps) const;
  double margin(const Vec<Dim>& x) const { return nearest_gap(x).margin; }
  /// margin(x), or `most` where it is certain that it is larger: most points are far from all gaps, which is found
  /// out much faster. \param most > 0
  double margin_up_to(const Vec<Dim>& x, double most) const { return is_beyond(x, most) ? most : margin(x); }
  /// Is it certain that the margin is at least this? Beside the limit it may be so where the answer is no.
  bool is_beyond(const Vec<Dim>& x, double least) const;
  /// The same by a lattice alone: faster, but a no even at points well beyond.
  bool is_surely_beyond(const Vec<Dim>& x, double least) const {
    return is_all() || parts_->margin_near(x) - parts_->reach >= least;
  }
  /// Is it certain that the margin is at most this? Likewise.
  bool is_within(const Vec<Dim>& x, double most) const {
    return !is_all() && parts_->margin_near(x) + parts_->reach <= most;
  }

  /// Is the observed part nearer? Points that are nearest to the edge of a gap, up to rounding, belong to the other: a
  /// correspondence with an edge is that of whatever lies beyond it (Turk and Levoy, Zippered polygon meshes from range
  /// images, SIGGRAPH 1994).
  bool contains(const Vec<Dim>& x) const { return is_all() || margin_up_to(x, 2 * least_margin()) > least_margin(); }
  /// What the margin of a point of the observed part exceeds: rounding errors.
  double least_margin() const { return rounding * scale_; }

 private:
  static constexpr double rounding = 1e-9;
  struct Part {
    explicit Part(Surface<Dim> s) : surface(std::move(s)), tree(surface) {}
    struct Nearest {
      Index facet;
      double distance;
    };
    Nearest nearest(const Vec<Dim>& x) const { return at(tree.nearest(x), x); }
    Nearest at(Index facet, const Vec<Dim>& x) const;
    Surface<Dim> surface;
    FacetTree<Dim> tree;
  };
  struct Parts {
    Part observed, unobserved;
    std::vector<double> half_widths;  ///< for each unobserved facet that of its connected part
    /// A lattice of cubes over the surface, for bounds of the margin. It is computed at centres where it is asked for,
    /// up to so many sides of a cube: whatever is farther away need not be found.
    static constexpr double most_margin = 16;
    Vec<Dim> corner;
    double side, reach;  ///< of a cube, and by how much the margin in it differs at most from that at its centre
    std::array<int, Dim> n_cells;
    mutable std::vector<std::atomic<float>> margins;
    void lay_lattice();
    float margin_near(const Vec<Dim>& x) const;
  };
  std::shared_ptr<const Parts> parts_;
  double scale_ = 0;  ///< diagonal of the observed part
};

}  // namespace shellmatch
