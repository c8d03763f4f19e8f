#include "alignment/pairs/confident_pairs.h"

#include "alignment/functional_map/nearest_features.h"
#include "base/disjoint_sets.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shellmatch {

std::vector<bool> in_consistent_group(const NeighbourLists& nearest, const std::vector<Vec<3>>& to, double max_stretch,
                                      double error) {
  DisjointSets groups(to.size()), parts(to.size());
  for (std::size_t i = 0; i < to.size(); ++i)
    for (const auto& [distance, j] : nearest[i]) {
      const auto a = static_cast<Index>(i), b = static_cast<Index>(j);
      parts.join(a, b);
      if ((to[j] - to[i]).norm() < max_stretch * (distance + error)) groups.join(a, b);
    }
  std::vector<std::size_t> size(to.size(), 0), largest(to.size(), 0);
  const auto n = static_cast<Index>(to.size());
  for (Index i = 0; i < n; ++i) ++size[groups.find(i)];
  for (Index i = 0; i < n; ++i) largest[parts.find(i)] = std::max(largest[parts.find(i)], size[groups.find(i)]);
  std::vector<bool> consistent(to.size());
  for (Index i = 0; i < n; ++i) consistent[i] = size[groups.find(i)] == largest[parts.find(i)];
  return consistent;
}

namespace {

std::vector<std::vector<Index>> facets_around(const Surface<3>& surface) {
  std::vector<std::vector<Index>> around(surface.vertices.size());
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (const Index v : surface.facets[f]) around[v].push_back(static_cast<Index>(f));
  return around;
}

/// Barycentric coordinates of the point of a triangle nearest to x, in a space of any dimension, searched inside and on
/// the three edges, which include the corners.
Vec<3> nearest_barycentric(const Eigen::VectorXf& x, const Eigen::VectorXf (&corners)[3]) {
  const auto distance = [&](const Vec<3>& b) {
    return (b[0] * corners[0].cast<double>() + b[1] * corners[1].cast<double>() + b[2] * corners[2].cast<double>() -
            x.cast<double>())
        .squaredNorm();
  };
  Vec<3> best = Vec<3>::Unit(0);
  double least = distance(best);
  const auto offer = [&](const Vec<3>& b) {
    const double d = distance(b);
    if (d < least) {
      least = d;
      best = b;
    }
  };
  for (int k = 0; k < 3; ++k) {
    const int a = k, b = (k + 1) % 3;
    const Eigen::VectorXd edge = (corners[b] - corners[a]).cast<double>();
    const double square = edge.squaredNorm();
    const double t = square > 0 ? std::clamp(edge.dot((x - corners[a]).cast<double>()) / square, 0.0, 1.0) : 0;
    offer((1 - t) * Vec<3>::Unit(a) + t * Vec<3>::Unit(b));
  }
  Eigen::MatrixXd edges(x.size(), 2);
  edges.col(0) = (corners[1] - corners[0]).cast<double>();
  edges.col(1) = (corners[2] - corners[0]).cast<double>();
  const Mat<2> gram = edges.transpose() * edges;
  if (gram.determinant() > 1e-12 * gram(0, 0) * gram(1, 1)) {
    const Vec<2> t = gram.inverse() * (edges.transpose() * (x - corners[0]).cast<double>());
    if (t.minCoeff() > 0 && t.sum() < 1) offer({1 - t.sum(), t[0], t[1]});
  }
  return best;
}

/// The factor, or its inverse where that is larger, by which a map changes the distances from a point to those near it:
/// the median, so that one wrong neighbour does no harm.
double local_stretch(const std::vector<std::pair<double, std::size_t>>& near, const std::vector<Vec<3>>& images,
                     std::size_t i) {
  std::vector<double> stretches;
  for (const auto& [distance, j] : near)
    stretches.push_back(std::max((images[j] - images[i]).norm(), 1e-12) / std::max(distance, 1e-12));
  if (stretches.empty()) return 1;
  const std::size_t n = stretches.size();
  std::nth_element(stretches.begin(), stretches.begin() + static_cast<std::ptrdiff_t>(n / 2), stretches.end());
  return std::max(stretches[n / 2], 1 / stretches[n / 2]);
}

}  // namespace

ConfidentPairs confident_pairs(const ShapePairSpectra& pair, const MapCandidate& candidate,
                               const AlignmentOptions& options) {
  const Embedding embedding = dense_embedding(pair, candidate.c, local_weight(pair, candidate.matches, candidate.c));
  ConfidentPairs result;
  result.map = nearest_features(embedding.on[1], embedding.on[0]);
  const std::vector<Index>&there = result.map, back = nearest_features(embedding.on[0], embedding.on[1]);
  const Surface<3>&surface_1 = pair.shapes[0]->surface, &surface_2 = pair.shapes[1]->surface;
  const auto n_samples = static_cast<std::size_t>(options.pairs);
  // The first of many such samples are such samples, too.
  std::vector<Index> samples = pair.shapes[0]->samples;
  if (samples.size() < n_samples) samples = farthest_point_samples(pair.shapes[0]->graph, samples[0], n_samples);
  else samples.resize(n_samples);
  const std::vector<std::vector<Index>> around = facets_around(surface_2);
  std::vector<Vec<3>> points, images_2;
  for (const Index v : samples) points.push_back(surface_1.vertices[v]);
  for (const Index v : samples) {
    const Eigen::VectorXf x = embedding.on[0].col(v);
    double least = std::numeric_limits<double>::infinity();
    Vec<3> point = surface_2.vertices[there[v]];
    for (const Index f : around[there[v]]) {
      const auto& facet = surface_2.facets[f];
      const Eigen::VectorXf corners[3] = {embedding.on[1].col(facet[0]), embedding.on[1].col(facet[1]),
                                          embedding.on[1].col(facet[2])};
      const Vec<3> b = nearest_barycentric(x, corners);
      const double distance = (static_cast<float>(b[0]) * corners[0] + static_cast<float>(b[1]) * corners[1] +
                               static_cast<float>(b[2]) * corners[2] - x)
                                  .squaredNorm();
      if (distance >= least) continue;
      least = distance;
      point.setZero();
      for (int k = 0; k < 3; ++k) point += b[k] * surface_2.vertices[facet[k]];
    }
    images_2.push_back(point);
  }
  const auto nearest = nearest_along(pair.shapes[0]->graph, samples, n_near);
  std::vector<CorrespondingPoints> close;
  std::vector<Index> from;
  std::vector<Vec<3>> to;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Index v = samples[i];
    const double cycle = (surface_1.vertices[back[there[v]]] - points[i]).norm();
    if (cycle >= options.cycle_tolerance || local_stretch(nearest[i], images_2, i) > options.max_stretch) continue;
    const double share = cycle / options.cycle_tolerance;
    close.push_back({points[i], images_2[i], (1 - share * share) * (1 - share * share)});
    from.push_back(v);
    to.push_back(images_2[i]);
  }
  const std::vector<bool> consistent = in_consistent_group(nearest_along(pair.shapes[0]->graph, from, n_near), to,
                                                           options.max_stretch, options.cycle_tolerance);
  for (std::size_t k = 0; k < close.size(); ++k)
    (consistent[k] ? result.pairs : result.contradicting).push_back(close[k]);
  return result;
}

}  // namespace shellmatch
