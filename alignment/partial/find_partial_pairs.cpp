#include "alignment/partial/find_partial_pairs.h"

#include "alignment/functional_map/two_way_map.h"
#include "alignment/pairs/confident_pairs.h"
#include "alignment/partial/consistent_images.h"
#include "alignment/partial/partial_map.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

// Samples that are placed, and the places for them.
constexpr std::size_t n_anchors = 16, n_places = 500;
constexpr std::size_t n_ways = 2000;  // that are followed
constexpr std::size_t n_refined = 24;
constexpr std::size_t n_queries = 600, n_searched = 5000;
// Starts and maps that differ by less at nearly all points, in roots of the whole's area, are one: those with one wrong
// limb are cheap, too.
constexpr double same = 0.2, nearly_all = 0.9;
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

/// The whole with samples of it, and distances from them.
struct Places {
  std::vector<Index> vertices;
  Eigen::MatrixXf distances;  ///< n_vertices x places
  std::vector<int> nearest;   ///< of each vertex
};

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

Index nearest_vertex(const Surface<3>& surface, const Vec<3>& x) {
  return static_cast<Index>(
      std::ranges::min_element(surface.vertices, {}, [&](const Vec<3>& v) { return (v - x).squaredNorm(); }) -
      surface.vertices.begin());
}

template <class Distance>
double quantile_of(std::size_t n, double share, const Distance& distance) {
  std::vector<double> d(n);
  for (std::size_t i = 0; i < n; ++i) d[i] = distance(i);
  const auto at = d.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(n));
  std::nth_element(d.begin(), at, d.end());
  return *at;
}

template <class Distance>
double median_of(std::size_t n, const Distance& distance) {
  return quantile_of(n, 0.5, distance);
}

std::vector<SampleImages> distinct(const std::vector<SampleImages>& all, const Eigen::MatrixXf& on_whole) {
  std::vector<SampleImages> kept;
  for (const SampleImages& images : all) {
    const auto is_same = [&](const SampleImages& other) {
      return quantile_of(images.images.size(), nearly_all,
                         [&](std::size_t a) { return on_whole(images.images[a], other.images[a]); }) < same;
    };
    if (std::none_of(kept.begin(), kept.end(), is_same)) kept.push_back(images);
    if (kept.size() == n_refined) break;
  }
  return kept;
}

std::vector<PartialMap> distinct(std::vector<PartialMap> maps, const PartialShape& whole) {
  std::stable_sort(maps.begin(), maps.end(),
                   [](const PartialMap& a, const PartialMap& b) { return a.order() < b.order(); });
  std::vector<PartialMap> kept;
  for (PartialMap& map : maps) {
    const auto is_same = [&](const PartialMap& other) {
      return quantile_of(map.images.size(), nearly_all, [&](std::size_t v) {
               return (whole.surface.vertices[map.images[v]] - whole.surface.vertices[other.images[v]]).norm();
             }) < same;
    };
    if (std::none_of(kept.begin(), kept.end(), is_same)) kept.push_back(std::move(map));
  }
  return kept;
}

/// As confident_pairs(), away from borders.
std::vector<CorrespondingPoints> confident_pairs_of(const PartialShape& part, const PartialShape& whole,
                                                    const PartialMap& map, const AlignmentOptions& options) {
  const std::vector<Index> samples = farthest_point_samples(part.graph, 0, static_cast<std::size_t>(options.pairs));
  Features images(map.on_whole.rows(), static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    images.col(static_cast<Eigen::Index>(i)) = map.on_whole.col(map.images[samples[i]]);
  const std::vector<Index> back = nearest_features(map.on_part, images);
  std::vector<CorrespondingPoints> close;
  std::vector<Index> from;
  std::vector<Vec<3>> to;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec<3>&x = part.surface.vertices[samples[i]], &y = whole.surface.vertices[map.images[samples[i]]];
    const double share = (part.surface.vertices[back[i]] - x).norm() / options.cycle_tolerance;
    if (share >= 1) continue;
    close.push_back({x, y, (1 - share * share) * (1 - share * share)});
    from.push_back(samples[i]);
    to.push_back(y);
  }
  const std::vector<bool> is_consistent =
      in_consistent_group(nearest_along(part.graph, from, n_near), to, options.max_stretch, options.cycle_tolerance);
  std::vector<CorrespondingPoints> pairs;
  for (std::size_t i = 0; i < close.size(); ++i)
    if (is_consistent[i]) pairs.push_back(close[i]);
  return pairs;
}

}  // namespace

PartialPairs find_partial_pairs(const Surface<3>& part_surface, const Surface<3>& whole_surface,
                                const AlignmentOptions& options, std::span<const CorrespondingPoints> landmarks) {
  PartialPairs result;
  std::optional<PartialShape> shapes[2];
  result.whole = prepare_surface(whole_surface, options);
  const double unit = std::sqrt(surface_measure(result.whole.surface));
  for_both([&](int s) {
    if (s == 0) result.part = prepare_surface(part_surface, options);
    shapes[s].emplace(make_partial_shape(s == 0 ? result.part.surface : result.whole.surface, unit, options));
  });
  const PartialShape &part = *shapes[0], &whole = *shapes[1];
  const Anchors anchors = choose_anchors(part);
  const Places places = places_on(whole);
  const SampleDistances samples = sample_distances(part, whole, anchors, places);
  const std::vector<SampleImages> starts = distinct(consistent_images(samples, n_ways), samples.on_whole);
  const std::vector<Index> queries = farthest_point_samples(part.graph, anchors.vertices.front(), n_queries);
  const std::vector<Index> searched = farthest_point_samples(whole.graph, places.vertices.front(), n_searched);
  // The last start is the surfaces as they lie.
  constexpr std::size_t n_schedules = std::size(partial_schedules);
  std::vector<PartialMap> maps(n_schedules * (starts.size() + 1));
  parallel_for(
      maps.size(),
      [&](std::size_t k) {
        const std::size_t i = k / n_schedules;
        std::vector<Index> images;
        for (const Index q : queries)
          images.push_back(i < starts.size() ? place_by_distances(anchors, places, starts[i].images, q)
                                             : nearest_vertex(whole.surface, part.surface.vertices[q]));
        maps[k] =
            refine_partial_map(part, whole, queries, std::move(images), searched, partial_schedules[k % n_schedules]);
      },
      1);
  maps = distinct(std::move(maps), whole);
  const auto landmark_distance = [&](const PartialMap& map) {
    return median_of(landmarks.size(), [&](std::size_t i) {
      const Index image = map.images[nearest_vertex(result.part.surface, landmarks[i].on_reference)];
      return (result.whole.surface.vertices[image] - landmarks[i].on_template).norm() / unit;
    });
  };
  if (landmarks.size() >= n_least_landmarks) std::ranges::stable_sort(maps, {}, landmark_distance);
  result.margin = std::numeric_limits<double>::infinity();
  for (const PartialMap& map : maps) {
    PartialCandidate& candidate = result.candidates.emplace_back(map.total(), map.order());
    candidate.map = map.images;
    candidate.pairs = confident_pairs_of(part, whole, map, options);
    for (CorrespondingPoints& pair : candidate.pairs) {
      pair.on_reference *= unit;
      pair.on_template *= unit;
    }
    if (landmarks.size() >= n_least_landmarks) candidate.landmark_distance = landmark_distance(map);
    if (&map != &maps[0]) result.margin = std::min(result.margin, margin_between(part, whole, maps[0], map, same));
  }
  return result;
}

}  // namespace shellmatch
