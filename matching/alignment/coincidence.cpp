#include "matching/alignment/coincidence.h"

#include "base/parallel.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/distance/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shellmatch {

namespace {

// In diagonals of the smaller shape: twice the voxels that segmentations of one bone differ by.
constexpr double tolerance = 0.01;
constexpr double least_cosine = 0.8;  // of the angle between the normals: a thin plate's other side is no coincidence

constexpr double most_map_error = 5;  // in reaches

// Shares and means need no more; of larger meshes every second, third, ... is taken.
constexpr std::size_t most_facets = 100'000;
std::size_t step_of(std::size_t n_facets) { return 1 + n_facets / most_facets; }

template <int Dim>
Vec<Dim> centre_of(const Surface<Dim>& surface, std::size_t facet) {
  Vec<Dim> centre = Vec<Dim>::Zero();
  for (const Index v : surface.facets[facet]) centre += surface.vertices[v] / Dim;
  return centre;
}

/// Of the distances of the centres of one surface's facets from the other, weighted by area.
template <int Dim>
double mean_square(const Surface<Dim>& from, const Surface<Dim>& to, double most) {
  std::vector<Vec<Dim>> centres;
  const std::size_t step = step_of(from.facets.size());
  for (std::size_t f = 0; f < from.facets.size(); f += step) centres.push_back(centre_of(from, f));
  const std::vector<double> distances = distances_to<Dim>(centres, to);
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double d = std::min(distances[i], most), share = facet_measure(from, static_cast<Index>(i * step));
    sum += share * d * d;
    area += share;
  }
  return sum / area;
}

}  // namespace

template <int Dim>
struct Coincidence<Dim>::Side {
  Surface<Dim> surface;
  SignedDistance<Dim> distance;
  double reach;

  Side(const Surface<Dim>& s, double within) : surface(s), distance(s), reach(within) {}
  bool has(const Vec<Dim>& x, const Vec<Dim>& normal) const {
    const ClosestPoint<Dim> nearest = distance.closest(x);
    return (nearest.point - x).norm() <= reach &&
           facet_normal(surface, nearest.facet).normalized().dot(normal) >= least_cosine;
  }
};

template <int Dim>
Coincidence<Dim>::Coincidence(const ShapePair<Dim>& shapes) {
  const Shape<Dim>* both[2] = {&shapes.reference, &shapes.template_shape};
  double reach = std::numeric_limits<double>::infinity();
  for (const Shape<Dim>* shape : both)
    reach = std::min(reach, tolerance * bounding_box(shape->surface.vertices).diagonal());
  for (int s = 0; s < 2; ++s) sides_[s] = std::make_unique<Side>(both[s]->surface, reach);
  for (int s = 0; s < 2; ++s) {
    // What was made up where a file has gaps lies in the same place only by chance.
    const Surface<Dim>& surface = both[s]->evidence.is_complete() ? both[s]->surface : both[s]->evidence.observed;
    const std::size_t step = step_of(surface.facets.size()), n = (surface.facets.size() + step - 1) / step;
    std::vector<double> areas(n), shared(n);
    parallel_for(n, [&](std::size_t i) {
      const std::size_t f = i * step;
      areas[i] = facet_measure(surface, static_cast<Index>(f));
      const Vec<Dim> normal = facet_normal(surface, static_cast<Index>(f)).normalized();
      if (sides_[1 - s]->has(centre_of(surface, f), normal)) shared[i] = areas[i];
    });
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    if (area > 0) share_ = std::max(share_, std::accumulate(shared.begin(), shared.end(), 0.0) / area);
  }
}

template <int Dim>
Coincidence<Dim>::~Coincidence() = default;

template <int Dim>
void Coincidence<Dim>::keep_others(std::vector<Landmark<Dim>>& pairs) const {
  const auto coincides = [&](const Landmark<Dim>& pair) {
    const Vec<Dim>* ends[2] = {&pair.on_reference, &pair.on_template};
    for (int s = 0; s < 2; ++s) {
      const Index facet = sides_[s]->distance.closest(*ends[s]).facet;
      if (sides_[1 - s]->has(*ends[s], facet_normal(sides_[s]->surface, facet).normalized())) return true;
    }
    return false;
  };
  const auto others = std::stable_partition(pairs.begin(), pairs.end(), coincides);
  std::vector<double> moves;
  for (auto pair = pairs.begin(); pair != others; ++pair)
    moves.push_back((pair->on_template - pair->on_reference).norm());
  // As far as maps err where the shapes are alike; after a turn, the image of a symmetry, they are far larger.
  const bool map_agrees = moves.empty() || quantile(std::move(moves), 0.5) <= most_map_error * sides_[0]->reach;
  pairs.erase(pairs.begin(), map_agrees ? others : pairs.end());
}

template <int Dim>
double distance_after(const ShapePair<Dim>& shapes, const Similarity<Dim>& pose, const std::array<bool, 2>& from) {
  const Surface<Dim>& target = shapes.template_shape.surface;
  const double most = 0.1 * bounding_box(target.vertices).diagonal();
  Surface<Dim> moved = shapes.reference.surface;
  for (Vec<Dim>& x : moved.vertices) x = pose(x);
  double sum = 0;
  if (from[0]) sum += mean_square<Dim>(moved, target, most);
  if (from[1]) sum += mean_square<Dim>(target, moved, most);
  return std::sqrt(sum);
}

template class Coincidence<2>;
template class Coincidence<3>;
SHELLMATCH_2D_3D(distance_after);

}  // namespace shellmatch
