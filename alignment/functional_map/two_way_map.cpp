#include "alignment/functional_map/two_way_map.h"

#include "base/decompositions.h"
#include "base/error.h"
#include "geometry/distance/surface_distance.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shellmatch {

namespace {

constexpr std::size_t n_coarsest = 600;

VertexSet vertex_set(const SpectralShape& shape, std::vector<Index> vertices, int n_functions) {
  Features functions(n_functions, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    functions.col(static_cast<Eigen::Index>(i)) =
        shape.functions.row(vertices[i]).head(n_functions).transpose().cast<float>();
  std::vector<bool> is_in(shape.n_vertices(), false);
  for (const Index v : vertices) is_in[static_cast<std::size_t>(v)] = true;
  std::vector<std::array<Index, 3>> facets;
  for (const auto& facet : shape.surface.facets)
    if (std::ranges::any_of(facet, [&](Index v) { return is_in[static_cast<std::size_t>(v)]; }))
      facets.push_back(facet);
  std::vector<Index> order = compact_order(functions);
  return {std::move(vertices), std::move(functions), std::move(order), std::move(facets)};
}

/// Vectors at the vertices of a set, times `weight`, as rows `at` to at + 2.
void put_rows(const Columns4& vectors, const VertexSet& set, double weight, Eigen::Index at, Features& features) {
  for (std::size_t i = 0; i < set.size(); ++i)
    features.block<3, 1>(at, static_cast<Eigen::Index>(i)) =
        static_cast<float>(weight) * vectors.col(set.vertices[i]).head<3>();
}

}  // namespace

ShapePairSpectra make_shape_pair(const SpectralShape& shape_1, const SpectralShape& shape_2,
                                 const std::vector<std::pair<Index, Index>>& landmarks) {
  const auto n_functions = static_cast<int>(std::min(shape_1.values.size(), shape_2.values.size()));
  ShapePairSpectra pair{.shapes = {&shape_1, &shape_2},
                        .functions = {},
                        .smoothed = {{shape_1, n_functions}, {shape_2, n_functions}},
                        .local = {},
                        .signatures = {shape_1.signature.transpose(), shape_2.signature.transpose()},
                        .coarsest = {},
                        .coarse = {},
                        .dense = {},
                        .n_functions = n_functions,
                        .landmarks = {}};
  for (const auto& landmark : landmarks)
    if (std::ranges::none_of(pair.landmarks,
                             [&](const auto& l) { return l.first == landmark.first || l.second == landmark.second; }))
      pair.landmarks.push_back(landmark);
  if (pair.landmarks.size() < n_least_landmarks) pair.landmarks.clear();
  constexpr Eigen::Index n_components = 12;  // they hold four fifths of the variance
  const Eigen::MatrixXf* const images[] = {&shape_1.spin, &shape_2.spin};
  const Eigen::VectorXd* const masses[] = {&shape_1.mass, &shape_2.mass};
  const Eigen::MatrixXf components = main_components(images, masses, n_components);
  for (int s = 0; s < 2; ++s) {
    pair.local[s].noalias() = components.transpose() * pair.shapes[s]->spin;
    pair.functions[s] = pair.shapes[s]->functions.leftCols(pair.n_functions).transpose().cast<float>();
    std::vector<Index> all;
    std::vector<bool> is_in(pair.shapes[s]->n_vertices(), false);
    const auto add = [&](Index v) {
      SHELLMATCH_CHECK(v >= 0 && static_cast<std::size_t>(v) < is_in.size(),
                       "landmarks are vertices of their surfaces");
      if (!is_in[v]) all.push_back(v);
      is_in[v] = true;
    };
    for (const auto& [v_1, v_2] : pair.landmarks) add(s == 0 ? v_1 : v_2);
    for (const Index v : pair.shapes[s]->samples) {
      if (all.size() == n_coarsest) pair.coarsest[s] = vertex_set(*pair.shapes[s], all, pair.n_functions);
      add(v);
    }
    pair.coarse[s] = vertex_set(*pair.shapes[s], all, pair.n_functions);
    if (pair.coarsest[s].size() == 0) pair.coarsest[s] = pair.coarse[s];
    for (std::size_t v = 0; v < is_in.size(); ++v) add(static_cast<Index>(v));
    pair.dense[s] = vertex_set(*pair.shapes[s], std::move(all), pair.n_functions);
  }
  return pair;
}

std::vector<std::pair<Index, Index>> pairs_of(const VertexMatches& matches) {
  std::vector<std::pair<Index, Index>> pairs;
  for (std::size_t i = 0; i < matches.from[0].size(); ++i) pairs.emplace_back(matches.from[0][i], matches.to[0][i]);
  for (std::size_t i = 0; i < matches.from[1].size(); ++i) pairs.emplace_back(matches.to[1][i], matches.from[1][i]);
  return pairs;
}

namespace {

/// The first k functions at the points of all pairs, on both surfaces.
struct PairedFunctions {
  Features rows[2];
  double n;
};

PairedFunctions paired_functions(const ShapePairSpectra& pair, const VertexMatches& matches, int k) {
  const auto pairs = pairs_of(matches);
  Features rows[2] = {Features(k, static_cast<Eigen::Index>(pairs.size())),
                      Features(k, static_cast<Eigen::Index>(pairs.size()))};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    rows[0].col(static_cast<Eigen::Index>(i)) = pair.functions[0].col(pairs[i].first).head(k);
    rows[1].col(static_cast<Eigen::Index>(i)) = pair.functions[1].col(pairs[i].second).head(k);
  }
  return {{std::move(rows[0]), std::move(rows[1])}, static_cast<double>(pairs.size())};
}

}  // namespace

Eigen::MatrixXd orthogonal_map(const ShapePairSpectra& pair, const VertexMatches& matches, int k) {
  const auto [rows, n] = paired_functions(pair, matches, k);
  const Eigen::MatrixXd products = (rows[0] * rows[1].transpose()).cast<double>();
  return nearest_orthogonal(products);
}

std::vector<double> landmark_distances(const ShapePairSpectra& pair, const VertexMatches& matches) {
  std::vector<double> distances;
  for (std::size_t j = 0; j < pair.landmarks.size(); ++j) {
    const auto& [p, q] = pair.landmarks[j];
    distances.push_back(
        std::max((pair.shapes[1]->surface.vertices[matches.to[0][j]] - pair.shapes[1]->surface.vertices[q]).norm(),
                 (pair.shapes[0]->surface.vertices[matches.to[1][j]] - pair.shapes[0]->surface.vertices[p]).norm()));
  }
  return distances;
}

namespace {

/// Two landmarks near each other.
struct Neighbours {
  double distance2;    ///< square of their distance on surface 1
  double difference2;  ///< half the square by which the map's errors at them differ
};

double median_of(std::span<const Neighbours> some, double Neighbours::*member) {
  std::vector<double> values;
  for (const Neighbours& n : some) values.push_back(n.*member);
  return quantile(std::move(values), 0.5);
}

}  // namespace

double landmark_noise(const ShapePairSpectra& pair, const VertexMatches& matches) {
  const std::size_t n = pair.landmarks.size(), n_neighbours = std::min<std::size_t>(5, n - 1);
  const auto place = [&](std::size_t j) { return pair.shapes[0]->surface.vertices[pair.landmarks[j].first]; };
  const auto error = [&](std::size_t j) -> Vec<3> {
    return pair.shapes[1]->surface.vertices[pair.landmarks[j].second] -
           pair.shapes[1]->surface.vertices[matches.to[0][j]];
  };
  const auto by_distance = [](const Neighbours& a, const Neighbours& b) { return a.distance2 < b.distance2; };
  std::vector<Neighbours> all;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<Neighbours> others;
    for (std::size_t i = 0; i < n; ++i)
      if (i != j) others.push_back({(place(i) - place(j)).squaredNorm(), 0.5 * (error(i) - error(j)).squaredNorm()});
    std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(n_neighbours), others.end(),
                      by_distance);
    all.insert(all.end(), others.begin(), others.begin() + static_cast<std::ptrdiff_t>(n_neighbours));
  }
  std::stable_sort(all.begin(), all.end(), by_distance);
  // As the nugget of a variogram: a straight line through the medians of the nearest third and of the farthest, back to
  // no distance.
  const std::span<const Neighbours> near = std::span(all).first((all.size() + 2) / 3),
                                    far = std::span(all).last((all.size() + 2) / 3);
  const double near_distance = median_of(near, &Neighbours::distance2),
               near_difference = median_of(near, &Neighbours::difference2);
  const double gap = median_of(far, &Neighbours::distance2) - near_distance;
  const double rise = gap > 0 ? std::max(0.0, median_of(far, &Neighbours::difference2) - near_difference) / gap : 0;
  return std::sqrt(std::max(0.0, near_difference - rise * near_distance));
}

Eigen::MatrixXd functional_map(const ShapePairSpectra& pair, const VertexMatches& matches, int k,
                               std::span<const double> landmark_weights) {
  const auto [rows, n] = paired_functions(pair, matches, k);
  // Scaled functions have mean square 1, so that the Gram matrices are about n times the identity; the ridge keeps maps
  // that collapse many points into one solvable.
  Eigen::MatrixXd products = (rows[0] * rows[1].transpose()).cast<double>();
  const Eigen::MatrixXd ridge = 1e-6 * n * Eigen::MatrixXd::Identity(k, k);
  Eigen::MatrixXd gram_1 = (rows[0] * rows[0].transpose()).cast<double>() + ridge;
  Eigen::MatrixXd gram_2 = (rows[1] * rows[1].transpose()).cast<double>() + ridge;
  for (std::size_t j = 0; j < landmark_weights.size(); ++j) {
    const auto [p, q] = pair.landmarks[j];
    const double weight = n * landmark_weights[j];
    const Eigen::VectorXd a = pair.functions[0].col(p).head(k).cast<double>(),
                          b = pair.functions[1].col(q).head(k).cast<double>();
    products += weight * a * b.transpose();
    gram_1 += weight * a * a.transpose();
    gram_2 += weight * b * b.transpose();
  }
  const Eigen::MatrixXd from_2 = gram_1.llt().solve(products), from_1 = gram_2.llt().solve(products.transpose());
  return 0.5 * (from_2 + from_1.transpose());
}

double local_weight(const ShapePairSpectra& pair, const VertexMatches& matches, const Eigen::MatrixXd& c) {
  // Smaller factors leave some heads turned; with larger ones the weight grows with the errors that it causes.
  constexpr double per_residual = 2, most_weight = 8;
  // Histograms of few vertices are noise: the square of the weight grows with their number up to that of large
  // surfaces.
  constexpr double many_vertices = 5000;
  const auto n = static_cast<double>(std::min(pair.shapes[0]->n_vertices(), pair.shapes[1]->n_vertices()));
  const double most = most_weight * std::sqrt(std::min(1.0, n / many_vertices));
  const Features transposed = c.transpose().cast<float>();
  double functions = 0, local = 0;
  for (const auto& [p, q] : pairs_of(matches)) {
    functions +=
        (transposed * pair.functions[0].col(p).head(c.rows()) - pair.functions[1].col(q).head(c.rows())).squaredNorm();
    local += (pair.local[0].col(p) - pair.local[1].col(q)).squaredNorm();
  }
  return local > 0 ? std::min(most, per_residual * std::sqrt(functions / local)) : most;
}

Embedding spectral_embedding(const ShapePairSpectra& pair, const VertexSet (&sets)[2], const Eigen::MatrixXd& c,
                             double normal_weight, double local_weight) {
  const Eigen::Index k = c.rows(), n_local = local_weight > 0 ? pair.local[0].rows() : 0;
  const bool with_normals = normal_weight > 0;
  Embedding embedding;
  for (int s = 0; s < 2; ++s) {
    Features& features = embedding.on[s];
    features.resize(k + (with_normals ? 6 : 0) + n_local, static_cast<Eigen::Index>(sets[s].size()));
    if (s == 0) features.topRows(k).noalias() = c.transpose().cast<float>() * sets[s].functions.topRows(k);
    else features.topRows(k) = sets[s].functions.topRows(k);
    for (std::size_t i = 0; n_local > 0 && i < sets[s].size(); ++i)
      features.col(static_cast<Eigen::Index>(i)).tail(n_local) =
          static_cast<float>(local_weight) * pair.local[s].col(sets[s].vertices[i]);
    if (!with_normals) continue;
    const Rows3 of_other = pair.shapes[1 - s]->coefficients.topRows(k);
    const SmoothedSurface& own = pair.smoothed[s].with(static_cast<int>(k));
    const std::vector<std::array<Index, 3>>& facets = sets[s].facets;
    const SmoothedSurface pulled_back =
        pair.smoothed[s].combined(s == 0 ? Rows3(c * of_other) : Rows3(c.transpose() * of_other),
                                  facets.empty() ? pair.shapes[s]->surface.facets : facets);
    put_rows(own.normals, sets[s], normal_weight, s == 0 ? k : k + 3, features);
    put_rows(pulled_back.normals, sets[s], normal_weight, s == 0 ? k + 3 : k, features);
  }
  return embedding;
}

Embedding dense_embedding(const ShapePairSpectra& pair, const Eigen::MatrixXd& c, double local_weight) {
  VertexSet all[2];
  for (int s = 0; s < 2; ++s) {
    all[s].functions = pair.functions[s];
    all[s].vertices.resize(pair.shapes[s]->n_vertices());
    std::iota(all[s].vertices.begin(), all[s].vertices.end(), 0);
  }
  return spectral_embedding(pair, all, c, embedded_normal_weight, local_weight);
}

VertexMatches match_vertices(const VertexSet (&sets)[2], const Embedding& embedding, std::size_t n_queries) {
  VertexMatches matches;
  for (int s = 0; s < 2; ++s) {
    const auto n = static_cast<Eigen::Index>(std::min(n_queries, sets[s].size()));
    const std::vector<Index> nearest =
        nearest_features(embedding.on[1 - s], embedding.on[s].leftCols(n), sets[1 - s].order);
    matches.from[s].assign(sets[s].vertices.begin(), sets[s].vertices.begin() + n);
    for (const Index at : nearest) matches.to[s].push_back(sets[1 - s].vertices[at]);
  }
  return matches;
}

}  // namespace shellmatch
