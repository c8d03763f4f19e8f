#include "alignment/spectrum/surface_tips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

// In roots of the area: fingers and ears have less.
constexpr double least_prominence = 0.05;
// Ends that are nearer are those of one limb.
constexpr double least_distance = 0.2;
// Mean of |log| of the ratios of distances of twins: more is no symmetry. A tip without a twin counts as much as
// stretch of 0.03, so that all legs are twins, and yet head and tail are not.
constexpr double most_stretch = 0.08, per_single_tip = 0.03;
// An image this far from all tips is that of no tip; within half of it there is no doubt which tip is meant.
constexpr double far_from_tips = 0.4;
constexpr double hit = 0.25;

std::vector<double> mean_distances(const EdgeGraph& graph, std::span<const Index> samples) {
  std::vector<double> mean(graph.n_vertices(), 0);
  for (const Index sample : samples) {
    const std::vector<double> distances = graph.distances_from(sample);
    for (std::size_t v = 0; v < mean.size(); ++v) mean[v] += distances[v] / static_cast<double>(samples.size());
  }
  return mean;
}

/// The highest vertex of the part above the present height that a vertex belongs to.
class Peaks {
 public:
  explicit Peaks(std::size_t n) : parent_(n, no_index) {}
  bool has(Index v) const { return parent_[v] != no_index; }
  void add(Index v) { parent_[v] = v; }
  Index of(Index v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(Index lower, Index higher) { parent_[lower] = higher; }

 private:
  std::vector<Index> parent_;
};

}  // namespace

std::vector<SurfaceTip> surface_tips(const EdgeGraph& graph, std::span<const Index> samples, std::size_t n) {
  const std::vector<double> height = mean_distances(graph, samples.first(std::min(n_tip_samples, samples.size())));
  std::vector<Index> descending(height.size());
  std::iota(descending.begin(), descending.end(), 0);
  std::stable_sort(descending.begin(), descending.end(), [&](Index a, Index b) { return height[a] > height[b]; });
  Peaks peaks(height.size());
  std::vector<SurfaceTip> tips;
  for (const Index v : descending) {
    peaks.add(v);
    graph.for_each_neighbour(v, [&](Index w) {
      if (!peaks.has(w)) return;
      Index low = peaks.of(v), high = peaks.of(w);
      if (low == high) return;
      if (height[low] > height[high] || (height[low] == height[high] && low < high)) std::swap(low, high);
      if (height[low] - height[v] >= least_prominence) tips.push_back({low, height[low] - height[v], {}});
      peaks.join(low, high);
    });
  }
  if (!descending.empty())
    tips.push_back({descending.front(), height[descending.front()] - height[descending.back()], {}});
  std::stable_sort(tips.begin(), tips.end(),
                   [](const SurfaceTip& a, const SurfaceTip& b) { return a.prominence > b.prominence; });
  std::vector<SurfaceTip> kept;
  for (SurfaceTip& tip : tips) {
    if (kept.size() == n) break;
    if (std::ranges::any_of(kept, [&](const SurfaceTip& k) { return k.distances[tip.vertex] < least_distance; }))
      continue;
    tip.distances = graph.distances_from(tip.vertex);
    kept.push_back(std::move(tip));
  }
  tips = std::move(kept);
  const std::vector<int> twins = twins_of_tips(tips);
  for (std::size_t i = 0; i < tips.size(); ++i) tips[i].twin = twins[i];
  return tips;
}

namespace {

/// Goes through all involutions of the tips.
class TwinSearch {
 public:
  explicit TwinSearch(const std::vector<SurfaceTip>& tips) : tips_(tips), twins_(tips.size(), -1), best_(tips.size()) {
    std::iota(best_.begin(), best_.end(), 0);
  }

  std::vector<int> run() {
    decide(0);
    return std::move(best_);
  }

 private:
  void decide(std::size_t i) {
    if (i == tips_.size()) return finish();
    if (twins_[i] >= 0) return decide(i + 1);
    for (std::size_t j = i; j < tips_.size(); ++j) {
      if (twins_[j] >= 0) continue;
      twins_[i] = static_cast<int>(j);
      twins_[j] = static_cast<int>(i);
      decide(i + 1);
      twins_[i] = twins_[j] = -1;
    }
  }

  double distance(std::size_t i, std::size_t j) const { return tips_[i].distances[tips_[j].vertex]; }

  void finish() {
    double stretch = 0;
    int n = 0, n_single = 0;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      const auto a = static_cast<std::size_t>(twins_[i]);
      n_single += a == i;
      for (std::size_t j = i + 1; j < tips_.size(); ++j) {
        const auto b = static_cast<std::size_t>(twins_[j]);
        if ((a == i && b == j) || (a == j && b == i)) continue;
        stretch += std::abs(std::log(distance(i, j) / distance(a, b)));
        ++n;
      }
    }
    if (n == 0 || stretch > most_stretch * n) return;
    const double cost = stretch / n + per_single_tip * n_single;
    if (cost >= least_) return;
    best_ = twins_;
    least_ = cost;
  }

  const std::vector<SurfaceTip>& tips_;
  std::vector<int> twins_, best_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<int> twins_of_tips(const std::vector<SurfaceTip>& tips) { return TwinSearch(tips).run(); }

namespace {

/// What tip_disorder() adds up of the tips of one surface.
void add_disorder(const std::vector<SurfaceTip>& tips, const std::vector<Index>& images,
                  const std::vector<SurfaceTip>& others, double& sum, double& weights) {
  std::vector<int> hits;
  std::vector<double> misses;
  for (const Index image : images) {
    const auto nearest = std::ranges::min_element(others, {}, [&](const SurfaceTip& t) { return t.distances[image]; });
    hits.push_back(static_cast<int>(nearest - others.begin()));
    const double miss = nearest->distances[image] / far_from_tips;
    misses.push_back(std::min(1.0, miss * miss));
  }
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const auto twin = static_cast<std::size_t>(tips[i].twin);
    const bool breaks_symmetry =
        misses[i] < hit && misses[twin] < hit && hits[twin] != others[static_cast<std::size_t>(hits[i])].twin;
    sum += tips[i].prominence * (misses[i] + 2 * breaks_symmetry);
    weights += tips[i].prominence;
  }
}

}  // namespace

double tip_disorder(const std::vector<SurfaceTip>& tips_1, const std::vector<Index>& images_1,
                    const std::vector<SurfaceTip>& tips_2, const std::vector<Index>& images_2) {
  // A round shape has one tip, wherever its mesh says; two tell no limbs.
  constexpr std::size_t n_telling = 3;
  if (tips_1.size() < n_telling || tips_2.size() < n_telling) return 0;
  double sum = 0, weights = 0;
  add_disorder(tips_1, images_1, tips_2, sum, weights);
  add_disorder(tips_2, images_2, tips_1, sum, weights);
  return weights > 0 ? sum / weights : 0;
}

}  // namespace shellmatch
