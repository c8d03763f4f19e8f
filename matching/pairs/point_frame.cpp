#include "matching/pairs/point_frame.h"

#include "base/stop.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <limits>

namespace shellmatch {

namespace {

constexpr double near = 0.05;   // of the diagonal: as far as landmarks.max_distance lets a landmark lie from its shape
constexpr double same = 0.003;  // of the diagonal: distances below tell nothing from one another
constexpr double much_nearer = 1 / 3.0;
constexpr std::size_t most_points = 1000;

double median_distance(const Surface<3>& surface, const FacetTree<3>& tree, const std::vector<Vec<3>>& points,
                       const PointImage& image) {
  std::vector<double> distances;
  for (const Vec<3>& point : points) {
    stop_if_wanted();
    const std::optional<Vec<3>> x = image ? image(point) : point;
    const Index facet = x ? tree.nearest(*x) : no_index;
    distances.push_back(facet == no_index ? std::numeric_limits<double>::infinity()
                                          : (closest_point_on_facet<3>(surface, facet, *x).point - *x).norm());
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::ranges::nth_element(distances, middle);
  return *middle;
}

Space other(Space space) { return space == Space::ras ? Space::lps : Space::ras; }

}  // namespace

Space frame_of_points(const Surface<3>& surface, const std::vector<Vec<3>>& points, Space own,
                      const PointImage& image) {
  if (surface.facets.empty() || points.empty()) return Space::unsaid;
  std::vector<Vec<3>> as_they_are;
  for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / most_points) as_they_are.push_back(points[i]);
  std::vector<Vec<3>> turned = as_they_are;
  change_space(turned, own, other(own));
  const FacetTree<3> tree(surface);
  const double diagonal = bounding_box(surface.vertices).diagonal();
  const double here = median_distance(surface, tree, as_they_are, image) / diagonal,
               there = median_distance(surface, tree, turned, image) / diagonal;
  const auto lie_on_it = [](double distance, double if_turned) {
    return distance <= near && (if_turned > near || (if_turned > same && distance <= much_nearer * if_turned));
  };
  return lie_on_it(here, there) ? own : lie_on_it(there, here) ? other(own) : Space::unsaid;
}

std::vector<Vec<3>> positions_in(Space space, const SlicerPoints& file) {
  std::vector<Vec<3>> points;
  for (const SlicerPoint& point : file.points)
    if (point.has_position) points.push_back(in_space(point.position, point.space, space));
  return points;
}

Space frame_of_points(const Surface<3>& surface, const SlicerPoints& file) {
  return frame_of_points(surface, positions_in(slicer_default_space, file), slicer_default_space);
}

template <int Dim>
Space space_beside(const OriginalShape<Dim>& shape, const std::string& points, Space wanted) {
  if constexpr (Dim == 3) {
    if (shape.space == Space::unsaid && wanted != Space::unsaid) return wanted;
    if (shape.space != Space::unsaid || !is_slicer_file(points)) return shape.space;
    const Space found = frame_of_points(Surface<3>{shape.vertices, triangulate(shape)}, read_slicer_points(points));
    return found == Space::unsaid ? slicer_default_space : found;
  }
  return shape.space;
}

SHELLMATCH_2D_3D(space_beside);

}  // namespace shellmatch
