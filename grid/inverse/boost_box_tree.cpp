#include "grid/inverse/box_tree.h"

// The R-tree includes a header of Boost's that tells every build that it is deprecated.
#define BOOST_ALLOW_DEPRECATED_HEADERS

#include <boost/geometry/algorithms/disjoint.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>

namespace shellmatch {

namespace {

template <int Dim>
using BoostPoint = boost::geometry::model::point<double, Dim, boost::geometry::cs::cartesian>;

BoostPoint<2> boost_point(const Vec<2>& x) { return {x[0], x[1]}; }
BoostPoint<3> boost_point(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

}  // namespace

template <int Dim>
struct BoxTree<Dim>::Tree {
  using Entry = std::pair<boost::geometry::model::box<BoostPoint<Dim>>, Index>;
  boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> boxes;
};

template <int Dim>
BoxTree<Dim>::BoxTree(const std::vector<std::pair<Vec<Dim>, Vec<Dim>>>& boxes) {
  std::vector<typename Tree::Entry> entries;
  entries.reserve(boxes.size());
  for (const auto& [low, high] : boxes)
    entries.push_back({{boost_point(low), boost_point(high)}, static_cast<Index>(entries.size())});
  tree_ = std::make_unique<Tree>(Tree{decltype(Tree::boxes)(entries)});  // packed: all at once
}

template <int Dim>
BoxTree<Dim>::~BoxTree() = default;
template <int Dim>
BoxTree<Dim>::BoxTree(BoxTree&&) noexcept = default;

template <int Dim>
std::vector<Index> BoxTree<Dim>::containing(const Vec<Dim>& x) const {
  std::vector<Index> found;
  for (auto it = tree_->boxes.qbegin(boost::geometry::index::intersects(boost_point(x))); it != tree_->boxes.qend();
       ++it)
    found.push_back(it->second);
  std::sort(found.begin(), found.end());
  return found;
}

template class BoxTree<2>;
template class BoxTree<3>;

}  // namespace shellmatch
