#pragma once
/// \file
/// Which of many boxes contain a point.

#include "base/types.h"

#include <memory>
#include <utility>
#include <vector>

namespace shellmatch {

/// A packed R-tree of axis-parallel boxes (Boost.Geometry).
template <int Dim>
class BoxTree {
 public:
  /// \param boxes lower and upper corners, finite
  explicit BoxTree(const std::vector<std::pair<Vec<Dim>, Vec<Dim>>>& boxes);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;

  /// Numbers of the boxes that contain x, boundary included, ascending.
  std::vector<Index> containing(const Vec<Dim>& x) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace shellmatch
