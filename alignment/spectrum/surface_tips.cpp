#include "alignment/spectrum/surface_tips.h"

#include <algorithm>
#include <numeric>

namespace shellmatch {

namespace {

std::vector<double> mean_distances(const EdgeGraph& graph, const std::vector<Index>& samples) {
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

std::vector<SurfaceTip> surface_tips(const EdgeGraph& graph, const std::vector<Index>& samples, std::size_t n,
                                     double least_prominence) {
  const std::vector<double> height = mean_distances(graph, samples);
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
  if (tips.size() > n) tips.resize(n);
  for (SurfaceTip& tip : tips) tip.distances = graph.distances_from(tip.vertex);
  return tips;
}

}  // namespace shellmatch
