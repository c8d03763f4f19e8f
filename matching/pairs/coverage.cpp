#include "matching/pairs/coverage.h"

#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/morton_curve.h"
#include "geometry/surface/subdivision.h"
#include "grid/fields/interpolation.h"
#include "matching/level/deformation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace shellmatch {

template <int Dim>
std::vector<SurfaceSample<Dim>> sample_vertices(const Surface<Dim>& surface, std::size_t most,
                                                const std::function<bool(const Vec<Dim>&)>& contains) {
  const auto n = static_cast<Index>(surface.vertices.size());
  const std::vector<Vec<Dim>> normals = vertex_normals(surface);
  const std::vector<double> area = vertex_measures(surface);
  std::vector<Index> order;
  double total = 0;
  for (Index v = 0; v < n; ++v)
    if (area[v] > 0 && !normals[v].isZero(0) && contains(surface.vertices[v])) {
      order.push_back(v);
      total += area[v];
    }
  std::vector<SurfaceSample<Dim>> samples;
  if (order.size() <= most) {
    for (const Index v : order) samples.push_back({v, surface.vertices[v], normals[v], area[v]});
    return samples;
  }
  std::vector<std::uint64_t> number(surface.vertices.size());
  for (const Index v : order) number[v] = morton_number<Dim>(surface.vertices[v]);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return number[a] < number[b]; });
  const double each = total / static_cast<double>(most);
  double passed = 0, next = 0.5 * each;
  for (const Index v : order) {
    passed += area[v];
    if (passed < next) continue;
    const double count = std::floor((passed - next) / each) + 1;  // a vertex may stand for several shares
    samples.push_back({v, surface.vertices[v], normals[v], count * each});
    next += count * each;
  }
  return samples;
}

SHELLMATCH_2D_3D(sample_vertices);

namespace {

/// What the corners of facet f have, at the point with these barycentric coordinates.
template <int Dim>
Vec<Dim> interpolated(const Surface<Dim>& surface, Index f, const std::array<double, Dim>& b,
                      const std::vector<Vec<Dim>>& at_vertices) {
  Vec<Dim> value = Vec<Dim>::Zero();
  for (int k = 0; k < Dim; ++k) value += b[k] * at_vertices[surface.facets[f][k]];
  return value;
}

/// Facets that are larger than samples are apart have samples within, and bend with phi.
template <int Dim>
Surface<Dim> resolved(const Surface<Dim>& surface, double side, const CoverageOptions& options) {
  return subdivided(surface, std::max(side, std::pow(surface_measure(surface) / options.samples, 1.0 / (Dim - 1))));
}

/// pair(i), of weight 0 where there is none, for i < n, appended in their order.
template <int Dim, class Pair>
void append_pairs(std::size_t n, const Pair& pair, std::vector<PointPair<Dim>>& found) {
  std::vector<PointPair<Dim>> made(n);
  parallel_for(
      n, [&](std::size_t i) { made[i] = pair(i); }, 64);
  for (const PointPair<Dim>& p : made)
    if (p.weight > 0) found.push_back(p);
}

}  // namespace

template <int Dim>
Coverage<Dim>::Coverage(const Surface<Dim>& reference, const SignedDistance<Dim>& template_shape, double side,
                        const CoverageOptions& options, const ObservedPair<Dim>& observed)
    : template_(&template_shape),
      options_(options),
      reference_(resolved(reference, side, options)),
      side_(side),
      tolerance_(options.tolerance * bounding_box(template_shape.surface().vertices).diagonal()) {
  const auto most = static_cast<std::size_t>(options.samples);
  on_reference_ =
      sample_vertices<Dim>(reference_, most, [&](const Vec<Dim>& x) { return observed.reference.contains(x); });
  on_template_ = sample_vertices<Dim>(resolved(template_shape.surface(), side, options), most,
                                      [&](const Vec<Dim>& x) { return observed.template_shape.contains(x); });
}

template <int Dim>
void Coverage<Dim>::add_from_template(const Surface<Dim>& deformed, const std::vector<Vec<Dim>>& normals,
                                      const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                      std::vector<PointPair<Dim>>& found) const {
  const double far = options_.point_distance * grid.finest_side();
  const FacetTree<Dim> tree(deformed);
  append_pairs<Dim>(
      on_template_.size(),
      [&](std::size_t i) {
        const SurfaceSample<Dim>& sample = on_template_[i];
        PointPair<Dim> pair{Vec<Dim>::Zero(), sample.x, 0, sample.normal};
        const Index f = tree.nearest(pair.y);
        if (f == no_index) return pair;
        // On an edge rounding chooses the facet: what is asked of the point must not depend on it.
        const std::array<double, Dim> b =
            barycentric_coordinates(deformed, f, closest_point_on_facet(deformed, f, pair.y));
        if (interpolated<Dim>(deformed, f, b, normals).dot(sample.normal) <= 0) return pair;
        pair.p = interpolated<Dim>(deformed, f, b, reference_.vertices);
        // Planes along a thin part have no component towards its tip: beyond this distance the point itself pulls. The
        // distance is that of phi(p), which lies beside the facet through the moved vertices where phi bends it.
        if ((evaluate(grid, phi, pair.p) - pair.y).norm() > far) pair.normal.setZero();
        pair.weight = sample.area;
        return pair;
      },
      found);
}

template <int Dim>
void Coverage<Dim>::add_from_reference(const Surface<Dim>& deformed, const std::vector<Vec<Dim>>& normals,
                                       std::vector<PointPair<Dim>>& found) const {
  append_pairs<Dim>(
      on_reference_.size(),
      [&](std::size_t i) {
        const SurfaceSample<Dim>& sample = on_reference_[i];
        PointPair<Dim> pair{sample.x, Vec<Dim>::Zero(), 0};
        const ClosestPoint<Dim> nearest = template_->closest(deformed.vertices[sample.vertex]);
        pair.y = nearest.point;
        pair.normal = template_->pseudonormal(nearest);
        if (pair.normal.dot(normals[sample.vertex]) <= 0) return pair;
        pair.weight = sample.area;
        return pair;
      },
      found);
}

template <int Dim>
PointPairs<Dim> Coverage<Dim>::pairs(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                                     const BandMask<Dim>* mask) const {
  const Surface<Dim> deformed = deformed_surface(reference_, grid, phi);
  PointPairs<Dim> result;
  const std::vector<Vec<Dim>> normals = vertex_normals(deformed);
  add_from_template(deformed, normals, grid, phi, result.pairs);
  add_from_reference(deformed, normals, result.pairs);
  if (mask) {
    parallel_chunks(result.pairs.size(), 64, [&](const Chunk& chunk) {
      std::vector<Vec<Dim>> p, y;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        p.push_back(result.pairs[i].p);
        y.push_back(result.pairs[i].y);
      }
      const std::vector<double> weights = mask->weights(p, y);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) result.pairs[i].weight *= weights[i - chunk.begin];
    });
    std::erase_if(result.pairs, [](const PointPair<Dim>& pair) { return !(pair.weight > 0); });
  }
  const bool is_coarse = grid.finest_side() > side_;
  result.tolerance = is_coarse ? std::max(tolerance_, options_.coarse_tolerance * grid.finest_side()) : tolerance_;
  result.loss = RobustLoss::huber;
  result.scale = options_.loss_scale * grid.finest_side();
  return result;
}

template <int Dim>
PointTerms<Dim>::PointTerms(std::vector<PairSet<Dim>> known, const Surface<Dim>& reference,
                            const SignedDistance<Dim>& template_shape, const ExperimentOptions& options,
                            const ObservedPair<Dim>& observed)
    : options_(&options), known_(std::move(known)) {
  if (has_coverage(options))
    coverage_.emplace(reference, template_shape, std::ldexp(1.0, -options.cascade.max_level), options.coverage,
                      observed);
}

template <int Dim>
void PointTerms<Dim>::add_to(LevelEnergy<Dim>& level) const {
  for (const PairSet<Dim>& set : known_)
    level.terms->add(set.name, PairTerm<Dim>(level.grid, set.pairs),
                     [weight = set.factor / options_->cascade.nu](const TermScales&) { return weight; });
  if (!coverage_) return;
  const bool acts = covers(*options_, level.grid.finest_level());
  typename EnergyTerms<Dim>::Renewal renewal;
  if (acts)
    renewal = [&level, &coverage = *coverage_](const std::vector<Vec<Dim>>& phi) {
      return PairTerm<Dim>(level.grid, coverage.pairs(level.grid, phi, level.mask ? &*level.mask : nullptr));
    };
  level.terms->add(
      "coverage", PairTerm<Dim>(),
      [factor = acts ? options_->coverage.weight : 0](const TermScales& s) { return factor / s.nu; }, renewal);
}

template class PointTerms<2>;
template class PointTerms<3>;
template class Coverage<2>;
template class Coverage<3>;

}  // namespace shellmatch
