#include "alignment/functional_map/two_way_map.h"

#include "base/svd.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <numeric>

namespace shellmatch {

namespace {

VertexSet vertex_set(const SpectralShape& shape, std::vector<Index> vertices, int n_functions) {
  Features functions(n_functions, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    functions.col(static_cast<Eigen::Index>(i)) =
        shape.functions.row(vertices[i]).head(n_functions).transpose().cast<float>();
  return {std::move(vertices), std::move(functions)};
}

/// Rows of `rows` at the vertices of a set, times `weight`, as columns.
void put_rows(const Rows3& rows, const VertexSet& set, double weight, Eigen::Index at, Features& features) {
  for (std::size_t i = 0; i < set.size(); ++i)
    features.block(at, static_cast<Eigen::Index>(i), 3, 1) =
        (weight * rows.row(set.vertices[i])).transpose().cast<float>();
}

}  // namespace

ShapePairSpectra make_shape_pair(const SpectralShape& shape_1, const SpectralShape& shape_2) {
  ShapePairSpectra pair;
  pair.shapes[0] = &shape_1;
  pair.shapes[1] = &shape_2;
  pair.n_functions = static_cast<int>(std::min(shape_1.values.size(), shape_2.values.size()));
  for (int s = 0; s < 2; ++s) {
    pair.functions[s] = pair.shapes[s]->functions.leftCols(pair.n_functions).transpose().cast<float>();
    std::vector<Index> all = pair.shapes[s]->samples;
    std::vector<bool> is_sample(pair.shapes[s]->n_vertices(), false);
    for (const Index v : all) is_sample[v] = true;
    for (std::size_t v = 0; v < is_sample.size(); ++v)
      if (!is_sample[v]) all.push_back(static_cast<Index>(v));
    pair.coarse[s] = vertex_set(*pair.shapes[s], pair.shapes[s]->samples, pair.n_functions);
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
  Features rows[2] = {Features(k, static_cast<Eigen::Index>(pairs.size())), Features(k, static_cast<Eigen::Index>(pairs.size()))};
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
  const Svd<Eigen::MatrixXd> svd = jacobi_svd(products);
  return svd.u * svd.v.transpose();
}

Eigen::MatrixXd functional_map(const ShapePairSpectra& pair, const VertexMatches& matches, int k) {
  const auto [rows, n] = paired_functions(pair, matches, k);
  // Scaled functions have mean square 1, so that the Gram matrices are about n times the identity; the ridge keeps maps that
  // collapse many points into one solvable.
  const Eigen::MatrixXd products = (rows[0] * rows[1].transpose()).cast<double>();
  const Eigen::MatrixXd ridge = 1e-6 * n * Eigen::MatrixXd::Identity(k, k);
  const Eigen::MatrixXd gram_1 = (rows[0] * rows[0].transpose()).cast<double>() + ridge;
  const Eigen::MatrixXd gram_2 = (rows[1] * rows[1].transpose()).cast<double>() + ridge;
  const Eigen::MatrixXd from_2 = gram_1.llt().solve(products), from_1 = gram_2.llt().solve(products.transpose());
  return 0.5 * (from_2 + from_1.transpose());
}

Embedding spectral_embedding(const ShapePairSpectra& pair, const VertexSet (&sets)[2], const Eigen::MatrixXd& c,
                             double normal_weight) {
  const Eigen::Index k = c.rows();
  const bool with_normals = normal_weight > 0;
  Embedding embedding;
  for (int s = 0; s < 2; ++s) {
    const SpectralShape &shape = *pair.shapes[s], &other = *pair.shapes[1 - s];
    Features& features = embedding.on[s];
    features.resize(k + (with_normals ? 6 : 0), static_cast<Eigen::Index>(sets[s].size()));
    if (s == 0)
      features.topRows(k).noalias() = c.transpose().cast<float>() * sets[s].functions.topRows(k);
    else
      features.topRows(k) = sets[s].functions.topRows(k);
    if (!with_normals) continue;
    const Rows3 through = s == 0 ? Rows3(c * other.coefficients.topRows(k)) : Rows3(c.transpose() * other.coefficients.topRows(k));
    const Rows3 own = vertex_normals(shape.surface.facets, shape.functions.leftCols(k) * shape.coefficients.topRows(k));
    const Rows3 pulled_back = vertex_normals(shape.surface.facets, shape.functions.leftCols(k) * through);
    put_rows(own, sets[s], normal_weight, s == 0 ? k : k + 3, features);
    put_rows(pulled_back, sets[s], normal_weight, s == 0 ? k + 3 : k, features);
  }
  return embedding;
}

Embedding dense_embedding(const ShapePairSpectra& pair, const Eigen::MatrixXd& c) {
  VertexSet all[2];
  for (int s = 0; s < 2; ++s) {
    all[s].functions = pair.functions[s];
    all[s].vertices.resize(pair.shapes[s]->n_vertices());
    std::iota(all[s].vertices.begin(), all[s].vertices.end(), 0);
  }
  return spectral_embedding(pair, all, c, embedded_normal_weight);
}

VertexMatches match_vertices(const VertexSet (&sets)[2], const Embedding& embedding, std::size_t n_queries) {
  VertexMatches matches;
  for (int s = 0; s < 2; ++s) {
    const auto n = static_cast<Eigen::Index>(std::min(n_queries, sets[s].size()));
    const std::vector<Index> nearest = nearest_features(embedding.on[1 - s], embedding.on[s].leftCols(n));
    matches.from[s].assign(sets[s].vertices.begin(), sets[s].vertices.begin() + n);
    for (const Index at : nearest) matches.to[s].push_back(sets[1 - s].vertices[at]);
  }
  return matches;
}

}  // namespace shellmatch
