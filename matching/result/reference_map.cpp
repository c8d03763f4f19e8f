#include "matching/result/reference_map.h"

#include "base/parallel.h"

#include <utility>

namespace shellmatch {

template <int Dim>
std::vector<Vec<Dim>> ReferenceMap<Dim>::carried(std::vector<Vec<Dim>> points, const Deformation<Dim>& frame,
                                                 const Surface<Dim>& reference) const {
  if (!inverse_) {
    parallel_for(points.size(), [&](std::size_t i) { points[i] = frame.apply(points[i]); });
    return points;
  }
  for (Vec<Dim>& x : points) x = frame.placement(x);
  points = inverse_->carried(points, nearest_normals<Dim>(reference, points));
  for (Vec<Dim>& x : points) x = frame.pose.inverse(frame.placement.inverse(x));
  return points;
}

template class ReferenceMap<2>;
template class ReferenceMap<3>;

}  // namespace shellmatch
