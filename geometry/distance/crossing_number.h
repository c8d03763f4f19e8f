#pragma once
/// \file
/// How often a closed surface winds about a point, by counting crossings: fast enough for every facet of a mesh.

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

}  // namespace shellmatch
