#pragma once
/// \file
/// How often a surface winds about a point. The generalised winding number is 1 inside and 0 outside a closed outward
/// oriented surface, and fractional for an open one: Jacobson, Kavan, Sorkine-Hornung, 'Robust inside-outside
/// segmentation using generalized winding numbers', ACM TOG 32(4), 2013. Counting crossings is fast enough for every
/// facet of a closed mesh.

#include "base/types.h"
#include "geometry/surface/surface.h"

#include <memory>

namespace shellmatch {

/// Winding numbers of a closed surface about points that do not lie on it. Immutable after construction; queries may
/// run in parallel.
class CrossingNumber {
 public:
  /// \pre closed, with facets and finite coordinates; outlives this object
  explicit CrossingNumber(const Surface<3>& surface);
  ~CrossingNumber();

  /// 0 outside of a surface that is oriented outward, 1 within it, 2 where two of its parts overlap: the facets that a
  /// segment from x to the outside leaves through less those through which it enters, by exact predicates. Where the
  /// segment meets edges, others are tried, and winding_number() in the end. \pre x is finite and on no facet
  int operator()(const Vec<3>& x) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// Sum over all facets of the signed angle (plane, over 2 pi) or solid angle (space, over 4 pi) that they
/// subtend at x. Takes time proportional to the number of facets; for checks and small surfaces. For x on a
/// facet, where the winding number is discontinuous, the result is the value of one side or their mean.
template <int Dim>
double winding_number(const Surface<Dim>& surface, const Vec<Dim>& x);

}  // namespace shellmatch
