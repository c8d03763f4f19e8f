#include "matching/pair_level.h"

#include "base/error.h"
#include "base/stop.h"
#include "grid/octree/constraints.h"
#include "matching/alignment/known_pairs.h"
#include "matching/cascade/cascade.h"
#include "matching/cascade/size_estimate.h"
#include "matching/level/level_energy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

/// Ends a cascade before its last level.
struct LevelReached {};

template <int Dim>
bool same_place(const Similarity<Dim>& a, const Similarity<Dim>& b) {
  return std::abs(a.scale - b.scale) <= 1e-9 * b.scale && (a.rotation - b.rotation).norm() <= 1e-9 &&
         (a.offset - b.offset).norm() <= 1e-9 * (1 + b.offset.norm());
}

template <int Dim>
bool same_bend(const SurfaceBend<Dim>* a, const SurfaceBend<Dim>* b) {
  if (a == nullptr || b == nullptr) return a == b;
  const auto same = [](const Surface<Dim>& x, const Surface<Dim>& y) {
    return std::ranges::equal(x.vertices, y.vertices, [](const Vec<Dim>& p, const Vec<Dim>& q) {
      return (p - q).norm() <= 1e-9 * (1 + q.norm());
    });
  };
  return a->surface().facets == b->surface().facets && same(a->surface(), b->surface()) && same(a->bent(), b->bent());
}

}  // namespace

template <int Dim>
PairLevel<Dim>::PairLevel(ShapePair<Dim> shapes, std::vector<Landmark<Dim>> landmarks, const ExperimentOptions& options,
                          int level, Observer& observer, const std::function<void(const MapFrame<Dim>&)>& prepared)
    : options_(options), number_(level), shapes_(std::move(shapes)), landmarks_(std::move(landmarks)), grid_(1) {
  prepared_ = prepare_pair(shapes_, landmarks_, options_, observer);
  options_ = cascade_options(options_, prepared_.alignment);
  if (prepared) prepared(prepared_.frame());
  if (prepared_.is_backward()) {  // the energy is that of the map from template to reference
    std::swap(shapes_.reference, shapes_.template_shape);
    landmarks_ = exchanged(std::move(landmarks_));
  }
  check_size<Dim>(refined_measures(shapes_.reference.surface, shapes_.template_shape.surface, options_),
                  options_.cascade.min_level, number_, "");
  grid_ = Octree<Dim>(options_.cascade.min_level);  // not before its size is known to fit
  observer.stage("coefficients");
  d1_.emplace(shapes_.reference.surface, shapes_.reference.crossing);
  d2_.emplace(shapes_.template_shape.surface, shapes_.template_shape.crossing);
  fields_.emplace(*d1_, *d2_, options_);
  fields_->compute_distances(grid_);
  for (int l = options_.cascade.min_level;; ++l) {
    sizes_.push_back(
        {l, grid_.n_nodes(), static_cast<Index>(grid_.free_nodes().size()), static_cast<Index>(grid_.leaves().size())});
    if (l == number_) break;
    observer.stage(fmt::format("level {}", l + 1));
    fields_->refine(grid_);
    fields_->compute_distances(grid_);
  }
  const ObservedPair<Dim> observed = observed_pair(shapes_.reference, shapes_.template_shape);
  level_.emplace(grid_, fields_->geometry(grid_), options_, observed);
  points_.emplace(known_pairs(landmarks_, prepared_.alignment, options_, prepared_.placement, *d1_, *d2_),
                  shapes_.reference.surface, *d2_, options_, observed);
  points_->add_to(*level_);
}

template <int Dim>
std::vector<Vec<Dim>> PairLevel<Dim>::coarser_result(Observer& observer) const {
  if (number_ == options_.cascade.min_level) return identity();
  std::optional<Deformation<Dim>> coarser;
  const auto finished = [&](const LevelResult& result, const LevelState<Dim>& state) {
    if (result.start.level != number_ - 1) return;
    coarser = Deformation<Dim>{prepared_.frame(), state.grid, state.phi};
    throw LevelReached();
  };
  observer.stage("matching");
  PhaseSeconds seconds;
  try {
    run_cascade<Dim>(*d1_, *d2_, options_, observer, finished, seconds, {}, points_->known(),
                     observed_pair(shapes_.reference, shapes_.template_shape));
  } catch (const LevelReached&) {
  }
  if (!coarser) throw Stopped("stopped before the level below was done; it is the start that was asked for");
  return sampled(*coarser);
}

template <int Dim>
std::vector<Vec<Dim>> PairLevel<Dim>::sampled(const Deformation<Dim>& map) const {
  return sampled_map(map, grid_);
}

template <int Dim>
bool same_frame(const MapFrame<Dim>& a, const MapFrame<Dim>& b) {
  return a.is_backward == b.is_backward && same_bend(a.bend.get(), b.bend.get()) &&
         same_place(a.placement, b.placement) && same_place(a.pose, b.pose);
}

template <int Dim>
LevelProblem<Dim> PairLevel<Dim>::problem(const SolverOptions& solver, const std::vector<Vec<Dim>>& phi) {
  return LevelProblem<Dim>(level_->unknowns, level_->energy, level_->hessian, weights(), level_->unknown_mass(), phi,
                           [this, solver](Metric metric) { return level_metric(*level_, solver, weights(), metric); });
}

SHELLMATCH_2D_3D(same_frame);
template class PairLevel<2>;
template class PairLevel<3>;

}  // namespace shellmatch
