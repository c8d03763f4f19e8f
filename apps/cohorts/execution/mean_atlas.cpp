#include "apps/cohorts/execution/mean_atlas.h"

#include "geometry/distance/surface_distance.h"

#include <cmath>

namespace shellmatch {

namespace {

// Mean square distance of corresponding points.
template <int Dim>
double square_distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights) {
  double sum = 0;
  for (Eigen::Index p = 0; p < weights.size(); ++p)
    sum += weights[p] * (a.segment<Dim>(Dim * p) - b.segment<Dim>(Dim * p)).squaredNorm();
  return sum;
}

// Root mean square over the surface.
template <int Dim>
double distance_from_surface(const std::vector<Vec<Dim>>& points, const Atlas<Dim>& atlas) {
  const std::vector<double> distances = distances_to(points, atlas.surface);
  double sum = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    sum += atlas.weights[static_cast<Eigen::Index>(v)] * distances[v] * distances[v];
  return std::sqrt(sum);
}

}  // namespace

template <int Dim>
MeanAtlas<Dim> mean_atlas(const Atlas<Dim>& atlas, const PointSets& images, ProcrustesKind kind) {
  const AlignedSets aligned = procrustes(images, atlas.weights, atlas.points, kind);
  MeanAtlas<Dim> mean;
  mean.shape = atlas.shape;
  mean.landmarks = atlas.landmarks;
  Eigen::Index p = 0;
  for (Vec<Dim>& x : mean.shape.vertices) x = aligned.mean.segment<Dim>(Dim * p++);
  for (NamedPoint<Dim>& landmark : mean.landmarks) landmark.point = aligned.mean.segment<Dim>(Dim * p++);
  mean.change = distance_from_surface(mean.shape.vertices, atlas) / atlas.diagonal;
  double sum = 0, least = 0;
  for (Eigen::Index k = 0; k < images.n_sets(); ++k) {
    const double square = square_distance<Dim>(aligned.sets.coordinates.col(k), aligned.mean, atlas.weights);
    sum += square;
    if (k == 0 || square < least) {
      least = square;
      mean.nearest = static_cast<std::size_t>(k);
    }
  }
  mean.spread = std::sqrt(sum / static_cast<double>(images.n_sets())) / atlas.diagonal;
  return mean;
}

template MeanAtlas<2> mean_atlas<2>(const Atlas<2>&, const PointSets&, ProcrustesKind);
template MeanAtlas<3> mean_atlas<3>(const Atlas<3>&, const PointSets&, ProcrustesKind);

}  // namespace shellmatch
