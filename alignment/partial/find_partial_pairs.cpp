#include "alignment/partial/find_partial_pairs.h"

#include "alignment/clear_margin.h"
#include "alignment/functional_map/two_way_map.h"
#include "alignment/pairs/confident_pairs.h"
#include "alignment/partial/partial_map.h"
#include "alignment/partial/partial_starts.h"
#include "alignment/spectrum/alike_components.h"
#include "base/parallel.h"
#include "geometry/distance/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

constexpr std::size_t n_searched = 5000;
constexpr std::size_t n_completed = 12;  // maps of all vertices

const std::vector<Index>& images_of(const PartialMap& map) { return map.images; }
const std::vector<Index>& images_of(const SampledMap& map) { return map.last_images; }
double order_of(const PartialMap& map) { return map.order(); }
double order_of(const SampledMap& map) { return map.order; }

/// The best of those that are the same, the best first.
template <class Map>
std::vector<Map> distinct(std::vector<Map> maps, const PartialShape& whole) {
  std::ranges::stable_sort(maps, {}, [](const Map& map) { return order_of(map); });
  std::vector<Map> kept;
  for (Map& map : maps) {
    const auto is_same = [&](const Map& other) {
      std::vector<double> apart;
      for (std::size_t i = 0; i < images_of(map).size(); ++i)
        apart.push_back(
            (whole.surface.vertices[images_of(map)[i]] - whole.surface.vertices[images_of(other)[i]]).norm());
      return quantile(std::move(apart), nearly_all) < same_map;
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

/// The whole, with what does not depend on the part.
struct SearchedWhole {
  explicit SearchedWhole(const Surface<3>& surface, const AlignmentOptions& options)
      : unit(std::sqrt(surface_measure(surface))),
        of_whole(make_partial_whole(surface, unit, options)),
        places(places_on(of_whole.shape)),
        samples(farthest_point_samples(of_whole.shape.graph, places.vertices.front(), n_searched)) {}
  const PartialShape& shape() const { return of_whole.shape; }
  double unit;
  PartialWhole of_whole;
  Places places;
  std::vector<Index> samples;
};

/// Distinct maps of the part after it has been scaled, the best first.
struct ScaledSearch {
  double scale;
  PartialShape part;
  std::vector<PartialMap> maps;

  double order() const { return maps.front().order(); }
};

ScaledSearch search_scaled(const Surface<3>& surface, double scale, const SearchedWhole& whole,
                           const AlignmentOptions& options) {
  ScaledSearch search{scale, make_partial_shape(surface, whole.unit / scale, options, whole.of_whole.components), {}};
  PartialStarts starts = partial_starts(search.part, whole.shape(), whole.places);
  constexpr std::size_t n_schedules = std::size(partial_schedules);
  std::vector<SampledMap> sampled(n_schedules * starts.images.size());
  parallel_for(
      sampled.size(),
      [&](std::size_t k) {
        sampled[k] = refine_partial_map(search.part, whole.shape(), starts.queries, starts.images[k / n_schedules],
                                        whole.samples, partial_schedules[k % n_schedules]);
      },
      1);
  sampled = distinct(std::move(sampled), whole.shape());
  sampled.resize(std::min(sampled.size(), n_completed));
  search.maps.resize(sampled.size());
  parallel_for(
      sampled.size(),
      [&](std::size_t i) { search.maps[i] = complete_map(search.part, whole.shape(), starts.queries, sampled[i]); }, 1);
  search.maps = distinct(std::move(search.maps), whole.shape());
  return search;
}

/// The least margin_between() the first map and others; infinite without.
double margin_of(const ScaledSearch& search, const PartialShape& whole) {
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < search.maps.size(); ++i)
    margin = std::min(margin, margin_between(search.part, whole, search.maps[0], search.maps[i], same_map));
  return margin;
}

/// The median of lengths on the whole over those on the part, between samples near each other and their images.
double stretch_of(const ScaledSearch& search, const PartialShape& whole) {
  constexpr std::size_t n_samples = 120;
  constexpr double nearest = 0.15, farthest = 0.4;
  const PartialShape& part = search.part;
  const std::vector<Index>& images = search.maps.front().images;
  const std::vector<Index> samples = farthest_point_samples(part.graph, 0, n_samples);
  std::vector<std::vector<double>> ratios(samples.size());
  parallel_for(
      samples.size(),
      [&](std::size_t i) {
        const std::vector<double> on_part = part.graph.distances_from(samples[i]),
                                  on_whole = whole.graph.distances_from(images[samples[i]]);
        for (const Index v : samples)
          if (on_part[v] > nearest && on_part[v] < farthest) ratios[i].push_back(on_whole[images[v]] / on_part[v]);
      },
      8);
  std::vector<double> all;
  for (const auto& some : ratios) all.insert(all.end(), some.begin(), some.end());
  return all.empty() ? 1 : quantile(std::move(all), 0.5);
}

/// Begins at a scale, and goes on with those that maps suggest as long as that is better.
ScaledSearch search_from(double scale, const Surface<3>& surface, const SearchedWhole& whole,
                         const AlignmentOptions& options) {
  constexpr int n_most = 4;
  constexpr double same_scale = 1.04;
  ScaledSearch best = search_scaled(surface, scale, whole, options);
  for (int k = 1; k < n_most; ++k) {
    const double stretch = stretch_of(best, whole.shape());
    if (!(stretch > 0) || std::max(stretch, 1 / stretch) < same_scale) break;
    ScaledSearch next = search_scaled(surface, best.scale * stretch, whole, options);
    if (!(next.order() < best.order())) break;
    best = std::move(next);
  }
  return best;
}

/// The power of ten that makes the part about as large as the whole, where no part of it could be so large or small:
/// files are in millimetres, centimetres or metres.
double scale_of_unit(const Surface<3>& part, const Surface<3>& whole) {
  constexpr double least = 0.02, most = 3, typical = 0.6;
  const double ratio = bounding_box(part.vertices).diagonal() / bounding_box(whole.vertices).diagonal();
  return ratio > least && ratio < most ? 1 : std::pow(10, std::round(std::log10(typical / ratio)));
}

}  // namespace

PartialPairs find_partial_pairs(const Surface<3>& part_surface, const Surface<3>& whole_surface,
                                const AlignmentOptions& options, std::span<const CorrespondingPoints> landmarks) {
  // Other individuals are larger or smaller.
  constexpr double other_scales[] = {1.25, 0.8};
  PartialPairs result;
  const std::array<std::size_t, 2> ranks = alike_components(part_surface, whole_surface, options);
  for_both([&](int s) {
    (s == 0 ? result.part : result.whole) =
        prepare_surface(s == 0 ? part_surface : whole_surface, options, ranks[static_cast<std::size_t>(s)]);
  });
  const SearchedWhole whole(result.whole.surface, options);
  const double unit_scale = scale_of_unit(result.part.surface, result.whole.surface);
  ScaledSearch best = search_from(unit_scale, result.part.surface, whole, options);
  if (margin_of(best, whole.shape()) < clear_margin_of_part)
    for (const double scale : other_scales)
      if (ScaledSearch other = search_from(scale * unit_scale, result.part.surface, whole, options);
          other.order() < best.order())
        best = std::move(other);
  const double unit_of_part = whole.unit / best.scale;
  result.scale = best.scale;
  const auto landmark_distance = [&](const PartialMap& map) {
    std::vector<double> distances;
    for (const CorrespondingPoints& l : landmarks) {
      const Index image = map.images[nearest_vertex(result.part.surface, l.on_reference)];
      distances.push_back((result.whole.surface.vertices[image] - l.on_template).norm() / whole.unit);
    }
    return quantile(std::move(distances), 0.5);
  };
  const bool by_landmarks = landmarks.size() >= n_least_landmarks;
  if (by_landmarks) std::ranges::stable_sort(best.maps, {}, landmark_distance);
  result.margin = margin_of(best, whole.shape());
  for (const PartialMap& map : best.maps) {
    PartialCandidate& candidate = result.candidates.emplace_back(map.total(), map.order());
    candidate.map = map.images;
    candidate.pairs = confident_pairs_of(best.part, whole.shape(), map, options);
    for (CorrespondingPoints& pair : candidate.pairs) {
      pair.on_reference *= unit_of_part;
      pair.on_template *= whole.unit;
    }
    if (by_landmarks) candidate.landmark_distance = landmark_distance(map);
  }
  return result;
}

}  // namespace shellmatch
