#include "alignment/pairs/find_pairs.h"

#include "alignment/functional_map/map_search.h"
#include "alignment/pairs/confident_pairs.h"
#include "alignment/spectrum/alike_components.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>

namespace shellmatch {

namespace {

constexpr std::size_t n_most_landmarks = 200;
// Orders that differ by less than this factor do not tell maps apart.
constexpr double tie = 1.02;
// Shapes that are symmetric themselves are as good mirrored, and are to stay as they are.
constexpr double mirrored_penalty = 1.1;

/// Candidates of one handedness, with pairs in the coordinates of the prepared surfaces. \param mirrored_gain of the
/// maps, set
std::vector<PairCandidate> candidates_of(const SpectralShape& reference, const SpectralShape& template_shape,
                                         const std::vector<std::pair<Index, Index>>& landmarks,
                                         const AlignmentOptions& options, bool is_mirrored, double& mirrored_gain) {
  const ShapePairSpectra pair = make_shape_pair(reference, template_shape, landmarks);
  FoundMaps all = search_maps(pair, options);
  mirrored_gain = all.mirrored_gain;
  std::vector<MapCandidate>& maps = all.maps;
  std::ranges::stable_sort(maps, {}, [](const MapCandidate& m) { return (m.is_identity ? 1 / tie : 1) * m.order(); });
  std::vector<PairCandidate> candidates(maps.size());
  parallel_for(
      maps.size(),
      [&](std::size_t i) {
        PairCandidate& candidate = candidates[i];
        candidate.score = maps[i].total();
        candidate.order = maps[i].order();
        if (i > 0) candidate.margin = margin_between(pair, maps[0], maps[i]);
        candidate.coarse_score = maps[i].coarse_score;
        candidate.score_parts = maps[i].score;
        candidate.n_landmarks = pair.landmarks.size();
        if (!pair.landmarks.empty()) {
          candidate.landmark_distance = maps[i].score.landmarks;
          candidate.landmark_trust = maps[i].landmark_trust;
        }
        candidate.is_identity = maps[i].is_identity;
        candidate.is_mirrored = is_mirrored;
        if (pair.landmarks.empty() && candidate.order > eligible_order * maps.front().order()) return;
        ConfidentPairs found = confident_pairs(pair, maps[i], options);
        for (auto* pairs : {&found.pairs, &found.contradicting})
          for (CorrespondingPoints& points : *pairs) {
            points.on_reference = reference.in_input_coordinates(points.on_reference);
            points.on_template = template_shape.in_input_coordinates(points.on_template);
          }
        candidate.pairs = std::move(found.pairs);
        candidate.contradicting = std::move(found.contradicting);
        candidate.map = std::move(found.map);
      },
      1);
  return candidates;
}

/// The vertices of a prepared surface that are nearest to points; no_index for a point on a component that was left
/// out.
std::vector<Index> nearest_vertices(const Surface<3>& input, const PreparedSurface& prepared,
                                    const std::vector<Vec<3>>& points) {
  const FacetTree<3> tree(input);
  std::vector<Index> nearest;
  for (const Vec<3>& x : points) {
    const bool is_left_out = !x.allFinite() || prepared.nearest[input.facets[tree.nearest(x)][0]] == no_index;
    const auto& vertices = prepared.surface.vertices;
    nearest.push_back(
        is_left_out ? no_index
                    : static_cast<Index>(std::ranges::min_element(
                                             vertices, {}, [&](const Vec<3>& v) { return (v - x).squaredNorm(); }) -
                                         vertices.begin()));
  }
  return nearest;
}

/// The vertices of the prepared surfaces that are nearest to landmarks; of many landmarks some, evenly through the
/// list.
std::vector<std::pair<Index, Index>> vertex_pairs(std::span<const CorrespondingPoints> landmarks,
                                                  const Surface<3>& reference, const Surface<3>& template_surface,
                                                  const AutomaticPairs& prepared) {
  if (landmarks.empty()) return {};
  std::vector<Vec<3>> points[2];
  for (std::size_t i = 0, n = std::min(landmarks.size(), n_most_landmarks); i < n; ++i) {
    points[0].push_back(landmarks[i * landmarks.size() / n].on_reference);
    points[1].push_back(landmarks[i * landmarks.size() / n].on_template);
  }
  const std::vector<Index> p = nearest_vertices(reference, prepared.reference, points[0]),
                           q = nearest_vertices(template_surface, prepared.template_surface, points[1]);
  std::vector<std::pair<Index, Index>> pairs;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i] != no_index && q[i] != no_index) pairs.emplace_back(p[i], q[i]);
  return pairs;
}

/// Moves points of the pairs onto the component that was prepared, as it was given, where it was simplified.
void project(Surface<3> input, const PreparedSurface& prepared, Vec<3> CorrespondingPoints::*side,
             std::vector<PairCandidate>& candidates) {
  if (prepared.surface.vertices.size() == input.vertices.size()) return;
  std::erase_if(input.facets, [&](const auto& facet) { return prepared.nearest[facet[0]] == no_index; });
  const FacetTree<3> tree(input);
  for (PairCandidate& candidate : candidates)
    for (auto* pairs : {&candidate.pairs, &candidate.contradicting})
      parallel_for(pairs->size(), [&](std::size_t i) {
        Vec<3>& x = (*pairs)[i].*side;
        x = closest_point_on_facet<3>(input, tree.nearest(x), x).point;
      });
}

}  // namespace

Index AutomaticPairs::image(Index reference_vertex) const {
  const Index nearest = reference.nearest[reference_vertex];
  return nearest == no_index ? no_index : candidates.front().map[nearest];
}

AutomaticPairs find_pairs(const Surface<3>& reference, const Surface<3>& template_surface,
                          const AlignmentOptions& options, std::span<const CorrespondingPoints> landmarks) {
  AutomaticPairs result;
  const std::array<std::size_t, 2> ranks = alike_components(reference, template_surface, options);
  for_both([&](int s) {
    PreparedSurface& prepared = s == 0 ? result.reference : result.template_surface;
    prepared = prepare_surface(s == 0 ? reference : template_surface, options, ranks[static_cast<std::size_t>(s)]);
    result.spectra[s] = std::make_shared<const SpectralShape>(make_spectral_shape(prepared.surface, options));
  });
  const auto& shapes = result.spectra;
  const std::vector<std::pair<Index, Index>> known = vertex_pairs(landmarks, reference, template_surface, result);
  result.candidates = candidates_of(*shapes[0], *shapes[1], known, options, false, result.mirrored_gain);
  if (options.mirror) {
    const SpectralShape mirrored = mirrored_shape(*shapes[0]);
    double of_mirrored = 0;
    for (PairCandidate& candidate : candidates_of(mirrored, *shapes[1], known, options, true, of_mirrored))
      result.candidates.push_back(std::move(candidate));
  }
  const auto key = [&](const PairCandidate& c) {
    return (c.is_mirrored ? mirrored_penalty : c.is_identity ? 1 / tie : 1) * c.order;
  };
  std::stable_sort(result.candidates.begin(), result.candidates.end(),
                   [&](const PairCandidate& a, const PairCandidate& b) { return key(a) < key(b); });
  result.is_ambiguous = are_ambiguous(*shapes[0], *shapes[1]);
  result.margin = result.is_ambiguous ? 1 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < result.candidates.size(); ++i)
    if (result.candidates[i].is_mirrored == result.candidates[0].is_mirrored)
      result.margin = std::min(result.margin, result.candidates[i].margin);
  project(reference, result.reference, &CorrespondingPoints::on_reference, result.candidates);
  project(template_surface, result.template_surface, &CorrespondingPoints::on_template, result.candidates);
  return result;
}

bool fits_mirrored(const SpectralShape& reference, const SpectralShape& template_shape, const AlignmentOptions& options,
                   double most_score, double most_order) {
  const SpectralShape mirrored = mirrored_shape(reference);
  const std::optional<MapCandidate> best =
      best_map_within(make_shape_pair(mirrored, template_shape), options, most_order);
  return best && best->order() < most_order && best->total() < most_score;
}

}  // namespace shellmatch
