#include "alignment/functional_map/map_score.h"

#include "base/decompositions.h"
#include "geometry/distance/surface_distance.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// Up to this score maps are as exact as 5000 vertices let them be; gorilla to man scores 0.8, with twice the errors.
constexpr double isometric_score = 0.6;
// Exact landmarks and such maps: 0.010 to 0.016 measured; landmarks with noise of 2 % of a diagonal: 0.033 to 0.042.
constexpr double explained_noise = 0.025;

/// Smoothed coordinates of all pairs' points on surface s, as columns.
Eigen::Matrix3Xd smooth_points(const ShapePairSpectra& pair, const std::vector<std::pair<Index, Index>>& pairs, int s,
                               int k) {
  const Columns4& coordinates = pair.smoothed[s].with(k).coordinates;
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Index v = s == 0 ? pairs[i].first : pairs[i].second;
    points.col(static_cast<Eigen::Index>(i)) = coordinates.col(v).head<3>().cast<double>();
  }
  return points;
}

/// All pairs' points on surface s, with k functions.
VertexSet end_points(const ShapePairSpectra& pair, const std::vector<std::pair<Index, Index>>& pairs, int s, int k) {
  VertexSet set{{}, Features(k, static_cast<Eigen::Index>(pairs.size()))};
  for (const auto& [p, q] : pairs) {
    const Index v = s == 0 ? p : q;
    set.functions.col(static_cast<Eigen::Index>(set.size())) = pair.functions[s].col(v).head(k);
    set.vertices.push_back(v);
  }
  return set;
}

/// The images of the tips of surface s: those of the samples next to them.
std::vector<Index> tip_images(const ShapePairSpectra& pair, const VertexMatches& matches, int s) {
  std::vector<Index> images;
  for (const SurfaceTip& tip : pair.shapes[s]->tips) {
    const auto nearest = std::ranges::min_element(matches.from[s], {}, [&](Index v) { return tip.distances[v]; });
    images.push_back(matches.to[s][static_cast<std::size_t>(nearest - matches.from[s].begin())]);
  }
  return images;
}

Mat<3> rotation_between(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  const Mat<3> covariance = to * from.transpose();
  const Svd<Mat<3>> svd = jacobi_svd(covariance);
  Vec<3> signs = Vec<3>::Ones();
  signs[2] = (svd.u * svd.v.transpose()).determinant() < 0 ? -1 : 1;
  return svd.u * signs.asDiagonal() * svd.v.transpose();
}

}  // namespace

double error_growth(double total_score) { return std::max(1.0, std::pow(total_score / isometric_score, 3)); }

double landmark_trust(double total_score, double landmark_noise) {
  const double ratio = landmark_noise / (explained_noise * error_growth(total_score));
  return std::exp(-4 * std::max(0.0, ratio * ratio - 1));
}

Mat<3> proper_rotation(const ShapePairSpectra& pair, const VertexMatches& matches, int k) {
  const auto pairs = pairs_of(matches);
  Eigen::Matrix3Xd from = smooth_points(pair, pairs, 0, k), to = smooth_points(pair, pairs, 1, k);
  from.colwise() -= from.rowwise().mean().eval();
  to.colwise() -= to.rowwise().mean().eval();
  return rotation_between(from, to);
}

MapScore score_samples(const ShapePairSpectra& pair, const VertexMatches& matches, const Eigen::MatrixXd& c) {
  const auto k = static_cast<int>(c.rows());
  const auto pairs = pairs_of(matches);
  const Embedding embedding = spectral_embedding(pair, {end_points(pair, pairs, 0, k), end_points(pair, pairs, 1, k)},
                                                 c, embedded_normal_weight);
  MapScore score;
  double squares = 0, sum = 0, weights = 0;
  // Two pairs of normals of this length stand below the functions.
  constexpr double normal_scale = 0.5 / (embedded_normal_weight * embedded_normal_weight);
  const SpectralShape &shape_1 = *pair.shapes[0], &shape_2 = *pair.shapes[1];
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [p, q] = pairs[i];
    // Means are integrals over the surfaces: meshes have most vertices where the shape says least of the whole, as in a
    // face.
    const double weight = i < matches.from[0].size() ? shape_1.mass[p] : shape_2.mass[q];
    weights += weight;
    const auto a = embedding.on[0].col(static_cast<Eigen::Index>(i)),
               b = embedding.on[1].col(static_cast<Eigen::Index>(i));
    sum += weight * (a.head(k) - b.head(k)).squaredNorm();
    squares += weight * b.head(k).squaredNorm();
    score.orientation +=
        weight * (1 - normal_scale * (a.segment(k, 3).dot(b.segment(k, 3)) + a.tail(3).dot(b.tail(3)))) / 2;
    const auto u = pair.signatures[0].col(p), v = pair.signatures[1].col(q);
    score.signature += weight * ((u - v).cwiseAbs().array() / (u + v).array()).mean();
    score.spin += weight * (shape_1.spin.col(p) - shape_2.spin.col(q)).squaredNorm();
  }
  const auto n = static_cast<double>(pairs.size());
  score.functions = std::sqrt(sum / squares);
  score.signature /= weights;
  score.orientation /= weights;
  score.spin /= weights;
  const int smooth = std::min(k, 24);
  Eigen::Matrix3Xd from = smooth_points(pair, pairs, 0, smooth), to = smooth_points(pair, pairs, 1, smooth);
  from.colwise() -= from.rowwise().mean().eval();
  to.colwise() -= to.rowwise().mean().eval();
  score.pose = std::sqrt((rotation_between(from, to) * from - to).squaredNorm() / n);
  return score;
}

MapScore score_map(const ShapePairSpectra& pair, const VertexMatches& matches, const Eigen::MatrixXd& c) {
  MapScore score = score_samples(pair, matches, c);
  score.tips = tip_disorder(pair.shapes[0]->tips, tip_images(pair, matches, 0), pair.shapes[1]->tips,
                            tip_images(pair, matches, 1));
  if (pair.landmarks.empty()) return score;
  score.landmarks = quantile(landmark_distances(pair, matches), 0.5);
  score.landmark_noise = landmark_noise(pair, matches);
  return score;
}

}  // namespace shellmatch
