#include "alignment/outline/outline_map.h"

#include "alignment/pose/fit_pose.h"
#include "base/error.h"

#include <algorithm>
#include <tuple>

namespace shellmatch {

namespace {

constexpr std::size_t n_most_curves = 24;

/// Partners of curves that lie on each other, the best first. Outer curves and holes do not mix.
std::vector<CurveMatch> partners(const NormalizedOutline& first, const NormalizedOutline& second,
                                 const Similarity<2>& pose) {
  const auto middle = [](const ClosedCurve& curve) {
    Vec<2> sum = Vec<2>::Zero();
    for (const Vec<2>& x : curve.points) sum += x;
    return Vec<2>(sum / static_cast<double>(curve.size()));
  };
  std::vector<std::tuple<double, std::size_t, std::size_t>> choices;
  for (std::size_t i = 0; i < first.curves.size(); ++i)
    for (std::size_t j = 0; j < second.curves.size(); ++j) {
      const ClosedCurve &a = first.curves[i], &b = second.curves[j];
      if (a.is_hole != b.is_hole) continue;
      const double cost = (pose(middle(a)) - middle(b)).norm() + 0.5 * std::abs(std::log(a.length / b.length));
      // Farther apart than the outline is wide, or of very different sizes: rather without a partner.
      if (cost < 1) choices.emplace_back(cost, i, j);
    }
  std::sort(choices.begin(), choices.end());
  std::vector<CurveMatch> matches;
  for (const auto& [cost, i, j] : choices)
    if (std::none_of(matches.begin(), matches.end(),
                     [&](const CurveMatch& m) { return m.first == i || m.second == j; }))
      matches.push_back({i, j, {}});
  return matches;
}

std::vector<CorrespondingPointsIn<2>> pairs_of(const NormalizedOutline& first, const NormalizedOutline& second,
                                               const std::vector<CurveMatch>& matches) {
  std::vector<CorrespondingPointsIn<2>> pairs;
  for (const CurveMatch& m : matches) {
    const ClosedCurve &a = first.curves[m.first], &b = second.curves[m.second];
    for (const auto& [i, j] : m.path)
      pairs.push_back({a.points[i], b.points[j], a.length / static_cast<double>(m.path.size())});
  }
  return pairs;
}

OutlineScore score_of(const NormalizedOutline& first, const NormalizedOutline& second, const OutlineMap& map) {
  OutlineScore score;
  double matched_first = 0, matched_second = 0;
  for (const CurveMatch& m : map.matches) {
    const ClosedCurve &a = first.curves[m.first], &b = second.curves[m.second];
    const std::size_t n = a.size();
    double square = 0, normals = 0, turning = 0, stretching = 0;
    for (std::size_t k = 0; k < m.path.size(); ++k) {
      const auto [i, j] = m.path[k];
      const auto [last_i, last_j] = m.path[(k + m.path.size() - 1) % m.path.size()];
      const auto steps_i = static_cast<double>((i + n - last_i) % n),
                 steps_j = static_cast<double>((j + n - last_j) % n);
      square += (map.pose(a.points[i]) - b.points[j]).squaredNorm();
      normals += 0.5 * (1 - (map.pose.rotation * a.normals[i]).dot(b.normals[j]));
      for (std::size_t s = 0; s < a.turning.size(); ++s)
        turning += std::abs(a.turning[s][i] - b.turning[s][j]) / static_cast<double>(a.turning.size());
      stretching += std::pow(std::log(steps_i / steps_j), 2);
    }
    const double weight = a.length / static_cast<double>(m.path.size());
    score.pose += weight * square;
    score.orientation += weight * normals;
    score.turning += weight * turning;
    score.stretching += weight * stretching;
    matched_first += a.length;
    matched_second += b.length;
  }
  if (matched_first > 0) {
    score.pose = std::sqrt(score.pose / matched_first);
    score.orientation /= matched_first;
    score.turning /= matched_first;
    score.stretching = 0.5 * std::sqrt(score.stretching / matched_first);
  }
  score.unmatched = std::max(0.0, 1 - 0.5 * (matched_first / first.length + matched_second / second.length));
  return score;
}

}  // namespace

NormalizedOutline normalized_outline(const Surface<2>& outline, std::size_t n, double smoothing) {
  NormalizedOutline result;
  struct Polygon {
    std::vector<Vec<2>> points;
    double length = 0;
  };
  std::vector<Polygon> polygons;
  for (const std::vector<Index>& vertices : closed_polygons(outline)) {
    Polygon& polygon = polygons.emplace_back();
    for (const Index v : vertices) polygon.points.push_back(outline.vertices[v]);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      polygon.length += (polygon.points[(i + 1) % vertices.size()] - polygon.points[i]).norm();
  }
  // By their lengths before smoothing, so that curves have the same numbers whatever is smoothed.
  std::stable_sort(polygons.begin(), polygons.end(),
                   [](const Polygon& a, const Polygon& b) { return a.length > b.length; });
  const double longest = polygons.empty() ? 0 : polygons.front().length;
  std::erase_if(polygons,
                [&](const Polygon& polygon) { return !(polygon.length > 0 && polygon.length >= 0.02 * longest); });
  if (polygons.empty()) throw_input_error("an outline has no closed curve");
  if (polygons.size() > n_most_curves) polygons.resize(n_most_curves);
  for (const Polygon& polygon : polygons) result.curves.push_back(smoothed_curve(polygon.points, n, smoothing));
  Vec<2> centre = Vec<2>::Zero();
  double length = 0, square = 0;
  for (const ClosedCurve& curve : result.curves) {
    for (const Vec<2>& x : curve.points) centre += curve.length / static_cast<double>(n) * x;
    length += curve.length;
  }
  centre /= length;
  for (const ClosedCurve& curve : result.curves)
    for (const Vec<2>& x : curve.points) square += curve.length / static_cast<double>(n) * (x - centre).squaredNorm();
  const double radius = std::sqrt(square / length);
  for (ClosedCurve& curve : result.curves) {
    for (Vec<2>& x : curve.points) x = (x - centre) / radius;
    curve.length /= radius;
  }
  for (const ClosedCurve& curve : result.curves) result.length += curve.length;
  return result;
}

Eigen::MatrixXd pair_costs(const ClosedCurve& first, const ClosedCurve& second, const Similarity<2>& pose) {
  // Places tell limbs from each other, normals and turning what belongs together on them.
  constexpr double normal_weight = 0.3, turning_weight = 1.5;
  Eigen::MatrixXd costs(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Vec<2> x = pose(first.points[i]), normal = pose.rotation * first.normals[i];
    for (std::size_t j = 0; j < second.size(); ++j) {
      double cost = (x - second.points[j]).squaredNorm() + normal_weight * 0.5 * (1 - normal.dot(second.normals[j]));
      for (std::size_t s = 0; s < first.turning.size(); ++s)
        cost += turning_weight * std::pow(first.turning[s][i] - second.turning[s][j], 2);
      costs(i, j) = cost;
    }
  }
  return costs;
}

OutlineMap refined_map(const NormalizedOutline& first, const NormalizedOutline& second, const Similarity<2>& start) {
  constexpr int n_sweeps = 4;
  OutlineMap map;
  map.pose = start;
  for (int sweep = 0; sweep < n_sweeps; ++sweep) {
    std::vector<CurveMatch> matches = partners(first, second, map.pose);
    if (matches.empty()) break;
    for (CurveMatch& m : matches) {
      const Eigen::MatrixXd costs = pair_costs(first.curves[m.first], second.curves[m.second], map.pose);
      Eigen::Index i = 0, j = 0;
      costs.minCoeff(&i, &j);
      m.path = closed_elastic_path(costs, static_cast<std::size_t>(i), static_cast<std::size_t>(j), path_stretching);
    }
    map.matches = std::move(matches);
    map.pose = fit_planar_pose(pairs_of(first, second, map.matches), PoseKind::rigid);
  }
  map.score = score_of(first, second, map);
  return map;
}

}  // namespace shellmatch
