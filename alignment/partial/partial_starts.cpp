#include "alignment/partial/partial_starts.h"

#include "alignment/partial/consistent_images.h"
#include "base/parallel.h"
#include "geometry/distance/surface_distance.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

// Samples that are placed, and the places for them.
constexpr std::size_t n_anchors = 16, n_places = 500;
constexpr std::size_t n_ways = 2000;  // that are followed
constexpr std::size_t n_starts = 24;
constexpr std::size_t n_queries = 600;
constexpr double off_border = 0.03;  // anchors' least distance from a border, where there are such
constexpr double apart = 0.05;       // least distance of an anchor from the others

struct Anchors {
  std::vector<Index> vertices;
  std::vector<std::vector<double>> distances;  ///< from each to all vertices
};

/// Farthest point samples away from borders; the first is farthest from what lies deepest inside.
Anchors choose_anchors(const PartialShape& part) {
  std::vector<bool> allowed(part.n_vertices());
  std::transform(part.to_border.begin(), part.to_border.end(), allowed.begin(),
                 [](double d) { return d > off_border; });
  if (std::count(allowed.begin(), allowed.end(), true) < static_cast<std::ptrdiff_t>(2 * n_anchors))
    allowed.assign(allowed.size(), true);
  const auto farthest = [&](const std::vector<double>& distances) {
    Index best = no_index;
    for (std::size_t v = 0; v < allowed.size(); ++v)
      if (allowed[v] && (best == no_index || distances[v] > distances[best])) best = static_cast<Index>(v);
    return best;
  };
  Anchors anchors;
  std::vector<double> least(part.n_vertices(), std::numeric_limits<double>::infinity());
  for (Index next = farthest(part.graph.distances_from(farthest(part.to_border))); anchors.vertices.size() < n_anchors;
       next = farthest(least)) {
    if (least[next] < apart) break;
    anchors.vertices.push_back(next);
    anchors.distances.push_back(part.graph.distances_from(next));
    for (std::size_t v = 0; v < least.size(); ++v) least[v] = std::min(least[v], anchors.distances.back()[v]);
  }
  return anchors;
}

SampleDistances sample_distances(const PartialShape& part, const PartialShape& whole, const Anchors& anchors,
                                 const Places& places) {
  const auto m = static_cast<Eigen::Index>(anchors.vertices.size()),
             n = static_cast<Eigen::Index>(places.vertices.size());
  SampleDistances samples{Eigen::MatrixXf(m, m), Eigen::MatrixXf(n, n), Eigen::MatrixXf::Constant(m, n, 2)};
  for (Eigen::Index i = 0; i < n; ++i)
    samples.on_whole.row(i) = places.distances.row(places.vertices[static_cast<std::size_t>(i)]);
  parallel_for(
      anchors.vertices.size(),
      [&](std::size_t a) {
        const auto row = static_cast<Eigen::Index>(a);
        for (Eigen::Index b = 0; b < m; ++b)
          samples.on_part(row, b) =
              static_cast<float>(anchors.distances[a][anchors.vertices[static_cast<std::size_t>(b)]]);
        const Eigen::VectorXf spin = part.spin.col(anchors.vertices[a]);
        for (std::size_t v = 0; v < whole.n_vertices(); ++v) {
          float& least = samples.unlikeness(row, places.nearest[v]);
          least = std::min(least, (whole.spin.col(static_cast<Eigen::Index>(v)) - spin).squaredNorm());
        }
      },
      1);
  return samples;
}

/// The vertex of the whole whose distances from the images of the anchors are those of vertex q from the anchors; the
/// nearer one is, the more it tells.
Index place_by_distances(const Anchors& anchors, const Places& places, const std::vector<int>& images, Index q) {
  constexpr float most = 0.3F, nearness = 0.1F;
  Eigen::ArrayXf cost = Eigen::ArrayXf::Zero(places.distances.rows());
  for (std::size_t a = 0; a < images.size(); ++a) {
    const auto d = static_cast<float>(anchors.distances[a][q]);
    cost += ((places.distances.col(images[a]).array() - d).abs().min(most) / (nearness + d)).square();
  }
  Index best = 0;
  cost.minCoeff(&best);
  return best;
}

std::vector<SampleImages> distinct(const std::vector<SampleImages>& all, const Eigen::MatrixXf& on_whole) {
  std::vector<SampleImages> kept;
  for (const SampleImages& images : all) {
    const auto is_same = [&](const SampleImages& other) {
      std::vector<double> distances;
      for (std::size_t a = 0; a < images.images.size(); ++a)
        distances.push_back(on_whole(images.images[a], other.images[a]));
      return quantile(std::move(distances), nearly_all) < same_map;
    };
    if (std::none_of(kept.begin(), kept.end(), is_same)) kept.push_back(images);
    if (kept.size() == n_starts) break;
  }
  return kept;
}

}  // namespace

Places places_on(const PartialShape& whole) {
  Places places{farthest_point_samples(whole.graph, 0, n_places), {}, std::vector<int>(whole.n_vertices())};
  places.distances.resize(static_cast<Eigen::Index>(whole.n_vertices()),
                          static_cast<Eigen::Index>(places.vertices.size()));
  parallel_for(
      places.vertices.size(),
      [&](std::size_t i) {
        const std::vector<double> d = whole.graph.distances_from(places.vertices[i]);
        places.distances.col(static_cast<Eigen::Index>(i)) =
            Eigen::Map<const Eigen::VectorXd>(d.data(), static_cast<Eigen::Index>(d.size())).cast<float>();
      },
      8);
  for (std::size_t v = 0; v < places.nearest.size(); ++v)
    places.distances.row(static_cast<Eigen::Index>(v)).minCoeff(&places.nearest[v]);
  return places;
}

Index nearest_vertex(const Surface<3>& surface, const Vec<3>& x) {
  return static_cast<Index>(
      std::ranges::min_element(surface.vertices, {}, [&](const Vec<3>& v) { return (v - x).squaredNorm(); }) -
      surface.vertices.begin());
}

PartialStarts partial_starts(const PartialShape& part, const PartialShape& whole, const Places& places) {
  const Anchors anchors = choose_anchors(part);
  const SampleDistances samples = sample_distances(part, whole, anchors, places);
  const std::vector<SampleImages> placed = distinct(consistent_images(samples, n_ways), samples.on_whole);
  PartialStarts starts;
  starts.queries = farthest_point_samples(part.graph, anchors.vertices.front(), n_queries);
  starts.images.resize(placed.size() + 1);
  parallel_for(
      starts.images.size(),
      [&](std::size_t i) {
        for (const Index q : starts.queries)
          starts.images[i].push_back(i < placed.size() ? place_by_distances(anchors, places, placed[i].images, q)
                                                       : nearest_vertex(whole.surface, part.surface.vertices[q]));
      },
      1);
  return starts;
}

}  // namespace shellmatch
