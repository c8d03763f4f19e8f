#include "alignment/outline/find_outline_pairs.h"

#include "alignment/pairs/order_candidates.h"
#include "alignment/pose/fit_pose.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <complex>
#include <limits>
#include <numbers>

namespace shellmatch {

namespace {

// Scores of outlines and their moved selves, which are sampled from other vertices on, differ by less.
constexpr double score_noise = 0.01;
constexpr double search_smoothing = 0.012, pair_smoothing = 0.003;

Similarity<2> turned_by(double angle) {
  Similarity<2> pose;
  pose.rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return pose;
}

double angle_of(const Similarity<2>& pose) { return std::atan2(pose.rotation(1, 0), pose.rotation(0, 0)); }

/// The poses that fit two curves best, sample i onto sample i + s, for the shifts s that are better than those next to
/// them.
std::vector<Similarity<2>> poses_by_shift(const ClosedCurve& first, const ClosedCurve& second) {
  constexpr std::size_t n_most = 8;
  using Complex = std::complex<double>;
  const std::size_t n = first.size();
  std::vector<Complex> x, y;
  Complex x_mean = 0, y_mean = 0;
  for (std::size_t i = 0; i < n; ++i) {
    x.emplace_back(first.points[i].x(), first.points[i].y());
    y.emplace_back(second.points[i].x(), second.points[i].y());
    x_mean += x[i] / static_cast<double>(n);
    y_mean += y[i] / static_cast<double>(n);
  }
  std::vector<Complex> correlation(n, 0);
  for (std::size_t s = 0; s < n; ++s)
    for (std::size_t i = 0; i < n; ++i) correlation[s] += std::conj(x[i] - x_mean) * (y[(i + s) % n] - y_mean);
  std::vector<std::pair<double, std::size_t>> peaks;
  for (std::size_t s = 0; s < n; ++s)
    if (const double here = std::abs(correlation[s]);
        here >= std::abs(correlation[(s + 1) % n]) && here > std::abs(correlation[(s + n - 1) % n]))
      peaks.emplace_back(-here, s);
  std::sort(peaks.begin(), peaks.end());
  if (peaks.size() > n_most) peaks.resize(n_most);
  std::vector<Similarity<2>> poses;
  for (const auto& [minus_fit, s] : peaks) {
    Similarity<2> pose = turned_by(std::arg(correlation[s]));
    pose.offset = Vec<2>(y_mean.real(), y_mean.imag()) - pose.rotation * Vec<2>(x_mean.real(), x_mean.imag());
    poses.push_back(pose);
  }
  return poses;
}

/// As the outlines lie; those of the longest curve and its likes; all around.
std::vector<Similarity<2>> outline_starts(const NormalizedOutline& first, const NormalizedOutline& second) {
  constexpr int n_around = 12;
  std::vector<Similarity<2>> starts{{}};
  const ClosedCurve& longest = first.curves.front();
  int n_alike = 0;
  for (const ClosedCurve& curve : second.curves) {
    const double ratio = curve.length / longest.length;
    if (curve.is_hole != longest.is_hole || ratio < 0.5 || ratio > 2 || ++n_alike > 3) continue;
    for (const Similarity<2>& pose : poses_by_shift(longest, curve)) starts.push_back(pose);
  }
  for (int k = 1; k < n_around; ++k) starts.push_back(turned_by(2 * std::numbers::pi * k / n_around));
  return starts;
}

/// Mean distance between the images of what both maps map.
double mean_difference(const NormalizedOutline& second, const OutlineMap& a, const OutlineMap& b) {
  double sum = 0;
  std::size_t n = 0;
  for (const CurveMatch& m : a.matches)
    for (const CurveMatch& other : b.matches) {
      if (m.first != other.first) continue;
      std::vector<std::size_t> image(second.curves[other.second].size(), second.curves[other.second].size());
      for (const auto& [i, j] : other.path) image[i] = j;
      for (const auto& [i, j] : m.path)
        if (image[i] < image.size()) {
          sum += (second.curves[m.second].points[j] - second.curves[other.second].points[image[i]]).norm();
          ++n;
        }
    }
  return n > 0 ? sum / static_cast<double>(n) : infinity;
}

/// Distinct maps, by score; the one that began as the outlines lie is among them.
std::vector<OutlineMap> search_outline_maps(const NormalizedOutline& first, const NormalizedOutline& second,
                                            std::size_t n_most) {
  const std::vector<Similarity<2>> starts = outline_starts(first, second);
  std::vector<OutlineMap> maps(starts.size()), distinct;
  parallel_for(
      starts.size(), [&](std::size_t i) { maps[i] = refined_map(first, second, starts[i]); }, 1);
  maps[0].is_identity = true;
  std::erase_if(maps, [](const OutlineMap& map) { return map.matches.empty(); });
  // Not std::stable_sort, whose buffer in g++ ignores that matrices are aligned to 32 bytes.
  std::sort(maps.begin(), maps.end(),
            [](const OutlineMap& a, const OutlineMap& b) { return a.score.total() < b.score.total(); });
  for (const OutlineMap& map : maps) {
    const auto same = std::find_if(distinct.begin(), distinct.end(),
                                   [&](const OutlineMap& other) { return mean_difference(second, map, other) < 0.05; });
    if (same != distinct.end()) same->is_identity |= map.is_identity;
    else if (distinct.size() < n_most || map.is_identity) distinct.push_back(map);
  }
  return distinct;
}

/// Pairs on the outlines themselves, by a second path close to the first, on curves with all but the smallest teeth.
std::vector<CorrespondingPointsIn<2>> dense_pairs(const OutlineMap& map, const NormalizedOutline& coarse,
                                                  const NormalizedOutline& first, const NormalizedOutline& second,
                                                  std::size_t n_pairs) {
  std::vector<CorrespondingPointsIn<2>> pairs;
  for (const CurveMatch& m : map.matches) {
    const ClosedCurve &a = first.curves[m.first], &b = second.curves[m.second];
    const std::size_t n = a.size(), factor = n / coarse.curves[m.first].size(), reach = n / 40;
    const Eigen::MatrixXd costs = pair_costs(a, b, map.pose);
    Eigen::MatrixXd near = Eigen::MatrixXd::Constant(costs.rows(), costs.cols(), infinity);
    for (const auto& [i, j] : m.path)
      for (std::size_t di = 0; di < 2 * reach; ++di)
        for (std::size_t dj = 0; dj < 2 * reach; ++dj) {
          const std::size_t to_i = (factor * i + di + n - reach) % n, to_j = (factor * j + dj + n - reach) % n;
          near(to_i, to_j) = costs(to_i, to_j);
        }
    Eigen::Index i = 0, j = 0;
    near.minCoeff(&i, &j);
    const ElasticPath path =
        closed_elastic_path(near, static_cast<std::size_t>(i), static_cast<std::size_t>(j), path_stretching);
    const double share = a.length / first.length;
    const auto n_here = std::min(
        path.size(), std::max<std::size_t>(8, static_cast<std::size_t>(share * static_cast<double>(n_pairs) + 0.5)));
    for (std::size_t k = 0; !path.empty() && k < n_here; ++k) {
      const auto [from, to] = path[k * path.size() / n_here];
      const double agreement = (map.pose.rotation * a.normals[from]).dot(b.normals[to]);
      // Where one side turns by more than 70 degrees against the other the path only connects its surroundings.
      if (agreement > 0.34) pairs.push_back({a.on_input[from], b.on_input[to], agreement * agreement});
    }
  }
  return pairs;
}

Surface<2> mirrored_outline(Surface<2> outline) {
  for (Vec<2>& x : outline.vertices) x.y() *= -1;
  for (auto& facet : outline.facets) std::swap(facet[0], facet[1]);
  return outline;
}

std::vector<OutlineCandidate> candidates_between(const Surface<2>& reference, const Surface<2>& template_outline,
                                                 const AlignmentOptions& options, bool is_mirrored) {
  const std::size_t n_curves = std::max(closed_polygons(reference).size(), closed_polygons(template_outline).size());
  const std::size_t n = std::clamp<std::size_t>(800 / std::max<std::size_t>(n_curves, 1), 64, 200);
  const Surface<2> shown = is_mirrored ? mirrored_outline(reference) : reference;
  const NormalizedOutline first = normalized_outline(shown, n, search_smoothing),
                          second = normalized_outline(template_outline, n, search_smoothing);
  const NormalizedOutline first_dense = normalized_outline(shown, 4 * n, pair_smoothing),
                          second_dense = normalized_outline(template_outline, 4 * n, pair_smoothing);
  const std::vector<OutlineMap> maps = search_outline_maps(first, second, static_cast<std::size_t>(options.refined));
  std::vector<OutlineCandidate> candidates(maps.size());
  parallel_for(
      maps.size(),
      [&](std::size_t k) {
        OutlineCandidate& candidate = candidates[k];
        candidate.score_parts = maps[k].score;
        candidate.score = maps[k].score.total();
        candidate.is_identity = maps[k].is_identity && !is_mirrored;
        candidate.is_mirrored = is_mirrored;
        candidate.pairs =
            dense_pairs(maps[k], first, first_dense, second_dense, static_cast<std::size_t>(options.pairs));
        if (is_mirrored)
          for (auto& pair : candidate.pairs) pair.on_reference.y() *= -1;
        // Fewer determine no pose.
        if (candidate.pairs.size() < 2) candidate.pairs.clear();
        else
          candidate.pose = fit_planar_pose(candidate.pairs, PoseKind::similarity,
                                           is_mirrored ? Mirroring::always : Mirroring::never);
      },
      1);
  return candidates;
}

/// Whether the poses differ by a motion that carries the template onto itself.
bool differ_by_symmetry(const Surface<2>& outline, const FacetTree<2>& tree, const Similarity<2>& a,
                        const Similarity<2>& b) {
  const double diagonal = bounding_box(outline.vertices).diagonal();
  double sum = 0, weights = 0;
  for (std::size_t f = 0; f < outline.facets.size(); ++f) {
    const auto& [from, to] = outline.facets[f];
    const Vec<2> x = b(a.inverse(0.5 * (outline.vertices[from] + outline.vertices[to])));
    const double weight = facet_measure(outline, static_cast<Index>(f));
    sum += weight * (closest_point_on_facet<2>(outline, tree.nearest(x), x).point - x).norm();
    weights += weight;
  }
  return sum < 0.01 * diagonal * weights;
}

}  // namespace

OutlinePairs find_outline_pairs(const Surface<2>& reference, const Surface<2>& template_outline,
                                const AlignmentOptions& options) {
  OutlinePairs result;
  std::vector<OutlineCandidate>& candidates = result.candidates;
  candidates = candidates_between(reference, template_outline, options, false);
  if (options.mirror)
    for (OutlineCandidate& candidate : candidates_between(reference, template_outline, options, true))
      candidates.push_back(std::move(candidate));
  if (candidates.empty()) candidates.emplace_back().score = infinity;
  order_candidates(candidates, {options.identity_preference, score_noise},
                   [](const OutlineCandidate& c) { return angle_of(c.pose); });
  const FacetTree<2> tree(template_outline);
  result.margin = margin_of_first(candidates, score_noise, [&](const OutlineCandidate& a, const OutlineCandidate& b) {
    return differ_by_symmetry(template_outline, tree, a.pose, b.pose);
  });
  return result;
}

}  // namespace shellmatch
