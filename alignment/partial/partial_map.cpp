#include "alignment/partial/partial_map.h"

#include "alignment/spectrum/spin_images.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

std::vector<Index> border_vertices(const Surface<3>& surface) {
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& facet : surface.facets)
    for (int k = 0; k < 3; ++k) edges.emplace_back(facet[k], facet[(k + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::vector<Index> vertices;
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), std::pair(b, a))) vertices.insert(vertices.end(), {a, b});
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

PartialShape make_partial_shape(Surface<3> surface, double unit, const AlignmentOptions& options,
                                const Eigen::MatrixXf& components) {
  for (Vec<3>& x : surface.vertices) x /= unit;
  const SurfaceLaplacian laplacian = surface_laplacian(surface, options.mollification);
  const auto n = static_cast<int>(surface.vertices.size());
  LaplacianEigenpairs spectrum = least_eigenpairs(laplacian, std::min(options.functions, (n - 1) / 2));
  Rows3 coordinates(n, 3);
  for (int v = 0; v < n; ++v) coordinates.row(v) = surface.vertices[v];
  Rows3 coefficients = spectrum.functions.transpose() * laplacian.mass.asDiagonal() * coordinates;
  Eigen::MatrixXf spin = spin_images(surface, laplacian, {&part_spin_radius, 1});
  EdgeGraph graph(surface);
  std::vector<double> to_border(surface.vertices.size(), std::numeric_limits<double>::infinity());
  for (const Index v : border_vertices(surface)) graph.lower_distances(v, to_border);
  Eigen::MatrixXf local;
  if (components.size() > 0) local = components.transpose() * spin;
  return {std::move(surface),      std::move(graph), laplacian.mass,   std::move(spectrum),
          std::move(coefficients), std::move(spin),  std::move(local), std::move(to_border)};
}

PartialWhole make_partial_whole(Surface<3> surface, double unit, const AlignmentOptions& options) {
  constexpr Eigen::Index n_components = 24;
  PartialWhole whole{make_partial_shape(std::move(surface), unit, options), {}};
  const Eigen::MatrixXf* const images[] = {&whole.shape.spin};
  const Eigen::VectorXd* const masses[] = {&whole.shape.mass};
  whole.components = main_components(images, masses, n_components);
  whole.shape.local = whole.components.transpose() * whole.shape.spin;
  return whole;
}

namespace {

constexpr int steps[] = {12, 16, 20, 25, 32, 40, 50, 64, 80, 100};  // functions of the whole
constexpr double n_least_functions = 4;                             // of the part
// Where a function has mean square 1.
constexpr float normal_weight = 2, spin_weight = 5;

Features columns(const Features& features, const std::vector<Index>& at) {
  Features some(features.rows(), static_cast<Eigen::Index>(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i) some.col(static_cast<Eigen::Index>(i)) = features.col(at[i]);
  return some;
}

/// Functions, normals and spin images of a surface, one below the other.
Features features_of(const PartialShape& shape, const Eigen::MatrixXd& functions, const Rows3& coordinates) {
  Features features(functions.cols() + 3 + shape.local.rows(), functions.rows());
  features.topRows(functions.cols()) = functions.transpose().cast<float>();
  features.middleRows(functions.cols(), 3) =
      normal_weight * vertex_normals(shape.surface.facets, coordinates).transpose().cast<float>();
  features.bottomRows(shape.local.rows()) = spin_weight * shape.local;
  return features;
}

/// With the first k functions of the whole, and `share` as in PartialSchedule.
void embed(const PartialShape& part, const PartialShape& whole, const std::vector<Index>& queries,
           const std::vector<Index>& images, Eigen::Index k, double share, PartialMap& map) {
  const Eigen::VectorXd& values = part.spectrum.values;
  const auto below = std::upper_bound(values.begin(), values.end(), whole.spectrum.values[k - 1]) - values.begin();
  const Eigen::Index n_part = std::min(
      static_cast<Eigen::Index>(std::max(share * static_cast<double>(below), n_least_functions)), values.size());
  const auto n = static_cast<Eigen::Index>(queries.size());
  Eigen::MatrixXd of_part(n, n_part), of_whole(n, k);
  for (Eigen::Index i = 0; i < n; ++i) {
    of_part.row(i) = part.spectrum.functions.row(queries[static_cast<std::size_t>(i)]).head(n_part);
    of_whole.row(i) = whole.spectrum.functions.row(images[static_cast<std::size_t>(i)]).head(k);
  }
  // Functions have mean square 1 over the area; the ridge keeps maps that collapse many points into one solvable.
  const double ridge = 1e-4 * static_cast<double>(n) / part.mass.sum();
  const Eigen::MatrixXd gram = of_part.transpose() * of_part + ridge * Eigen::MatrixXd::Identity(n_part, n_part);
  const Eigen::MatrixXd c = gram.llt().solve(of_part.transpose() * of_whole);
  const Eigen::MatrixXd carried = part.spectrum.functions.leftCols(n_part) * c,
                        own = whole.spectrum.functions.leftCols(k);
  map.on_part = features_of(part, carried, carried * whole.coefficients.topRows(k));
  map.on_whole = features_of(whole, own, own * whole.coefficients.topRows(k));
}

/// Nearer a border than the radius of spin images, these lack what was cut away.
double trust_near_border(const PartialShape& part, Index v) {
  return std::clamp(part.to_border[v] / part_spin_radius, 0.125, 1.0);
}

/// Sums over points of the part and their images, of which a PartialMap has the means.
class ScoreSums {
 public:
  ScoreSums(const PartialShape& part, const PartialShape& whole, const PartialMap& map)
      : part_(part), whole_(whole), map_(map), k_(whole.spectrum.values.size()) {}

  void add(double weight, Index v, Index image, double misorientation) {
    const auto on_part = map_.on_part.col(v).head(k_), on_whole = map_.on_whole.col(image).head(k_);
    weights_ += weight;
    difference_ += weight * (on_part - on_whole).squaredNorm();
    squares_ += weight * on_whole.squaredNorm();
    spin_ += weight * (part_.spin.col(v) - whole_.spin.col(image)).squaredNorm();
    orientation_ += weight * misorientation;
  }
  void set_means(PartialMap& map) const {
    map.functions = std::sqrt(difference_ / squares_);
    map.spin = spin_ / weights_;
    map.orientation = orientation_ / weights_;
  }

 private:
  const PartialShape &part_, &whole_;
  const PartialMap& map_;
  Eigen::Index k_;
  double difference_ = 0, squares_ = 0, weights_ = 0, spin_ = 0, orientation_ = 0;
};

/// Over the vertices v of the part for which is_counted(v).
void score(const PartialShape& part, const PartialShape& whole, const auto& is_counted, PartialMap& map) {
  Rows3 mapped(static_cast<Eigen::Index>(part.n_vertices()), 3),
      coordinates(static_cast<Eigen::Index>(whole.n_vertices()), 3);
  for (std::size_t v = 0; v < part.n_vertices(); ++v)
    mapped.row(static_cast<Eigen::Index>(v)) = whole.surface.vertices[map.images[v]];
  for (std::size_t v = 0; v < whole.n_vertices(); ++v)
    coordinates.row(static_cast<Eigen::Index>(v)) = whole.surface.vertices[v];
  const Rows3 through = vertex_normals(part.surface.facets, mapped),
              normals = vertex_normals(whole.surface.facets, coordinates);
  ScoreSums sums(part, whole, map);
  for (std::size_t i = 0; i < part.n_vertices(); ++i) {
    if (!is_counted(i)) continue;
    const auto v = static_cast<Index>(i);
    sums.add(part.mass[v] * trust_near_border(part, v), v, map.images[i],
             (1 - through.row(v).dot(normals.row(map.images[i]))) / 2);
  }
  sums.set_means(map);
}

/// The order of a map that is known at samples alone.
double order_of_samples(const PartialShape& part, const PartialShape& whole, const std::vector<Index>& queries,
                        const std::vector<Index>& images, const PartialMap& map) {
  const Eigen::Index k = whole.spectrum.values.size();
  ScoreSums sums(part, whole, map);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto normal = map.on_part.col(queries[i]).segment(k, 3), other = map.on_whole.col(images[i]).segment(k, 3);
    sums.add(trust_near_border(part, queries[i]), queries[i], images[i],
             (normal - other).squaredNorm() / (4 * normal_weight * normal_weight));
  }
  PartialMap sampled;
  sums.set_means(sampled);
  return sampled.order();
}

}  // namespace

SampledMap refine_partial_map(const PartialShape& part, const PartialShape& whole, const std::vector<Index>& queries,
                              std::vector<Index> images, const std::vector<Index>& samples,
                              const PartialSchedule& schedule) {
  PartialMap map;
  const auto n_functions = static_cast<int>(whole.spectrum.values.size());
  const auto next_images = [&](int k) {
    embed(part, whole, queries, images, std::min(k, n_functions), schedule.share, map);
    const std::vector<Index> nearest = nearest_features(columns(map.on_whole, samples), columns(map.on_part, queries));
    std::vector<Index> next;
    for (const Index at : nearest) next.push_back(samples[at]);
    return next;
  };
  for (const int step : steps)
    if (step >= schedule.first) images = next_images(step);
  std::vector<Index> last_images = next_images(n_functions);
  const double order = order_of_samples(part, whole, queries, last_images, map);
  return {std::move(images), std::move(last_images), schedule.share, order};
}

PartialMap complete_map(const PartialShape& part, const PartialShape& whole, const std::vector<Index>& queries,
                        const SampledMap& sampled) {
  PartialMap map;
  embed(part, whole, queries, sampled.images, whole.spectrum.values.size(), sampled.share, map);
  map.images = nearest_features(map.on_whole, map.on_part);
  score(
      part, whole, [](std::size_t) { return true; }, map);
  return map;
}

double margin_between(const PartialShape& part, const PartialShape& whole, const PartialMap& first,
                      const PartialMap& other, double apart) {
  const auto is_apart = [&](std::size_t v) {
    return (whole.surface.vertices[first.images[v]] - whole.surface.vertices[other.images[v]]).norm() > apart;
  };
  PartialMap of_first = first, of_other = other;
  score(part, whole, is_apart, of_first);
  score(part, whole, is_apart, of_other);
  return std::sqrt(other.order() / first.order() * of_other.order() / of_first.order());
}

}  // namespace shellmatch
