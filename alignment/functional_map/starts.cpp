#include "alignment/functional_map/starts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

// Cost where all pairs break symmetries; less where distances, which then tell more, differ by little.
constexpr double all_broken = 0.3, little = 0.05;

/// Goes through all assignments, deciding for each tip of surface 1 in turn.
class TipSearch {
 public:
  TipSearch(const std::vector<SurfaceTip>& tips_1, const std::vector<SurfaceTip>& tips_2, std::size_t n)
      : tips_{&tips_1, &tips_2}, n_(n), is_used_(tips_2.size(), false) {
    for (const auto* tips : tips_)
      for (const SurfaceTip& tip : *tips) all_prominences_ += tip.prominence;
  }

  std::vector<TipAssignment> run() {
    decide(0, 0, 0);
    std::sort_heap(best_.begin(), best_.end(), is_cheaper);
    return std::move(best_);
  }

 private:
  static bool is_cheaper(const TipAssignment& a, const TipAssignment& b) {
    return std::pair(a.cost, a.pairs) < std::pair(b.cost, b.pairs);
  }

  /// Pairs that break the symmetries of the surfaces: their twins are not a pair.
  int n_broken() const {
    int n = 0;
    for (const auto& [i, j] : pairs_) {
      const int a = tip(0, i).twin, b = tip(1, j).twin;
      const auto of_twin = std::ranges::find(pairs_, a, &std::pair<int, int>::first);
      n += of_twin != pairs_.end() ? of_twin->second != b : (a == i) != (b == j);
    }
    return n;
  }

  const SurfaceTip& tip(int s, int i) const { return (*tips_[s])[static_cast<std::size_t>(i)]; }

  // \param stretch sum of |log| of the ratios of distances so far, \param prominence of the tips in pairs, of both
  // surfaces
  void decide(int i, double stretch, double prominence) {
    if (i == static_cast<int>(tips_[0]->size())) return finish(stretch, prominence);
    decide(i + 1, stretch, prominence);
    for (int j = 0; j < static_cast<int>(tips_[1]->size()); ++j) {
      if (is_used_[static_cast<std::size_t>(j)]) continue;
      double added = 0;
      for (const auto& [a, b] : pairs_)
        added += std::abs(std::log(tip(0, i).distances[tip(0, a).vertex] / tip(1, j).distances[tip(1, b).vertex]));
      is_used_[static_cast<std::size_t>(j)] = true;
      pairs_.emplace_back(i, j);
      decide(i + 1, stretch + added, prominence + tip(0, i).prominence + tip(1, j).prominence);
      pairs_.pop_back();
      is_used_[static_cast<std::size_t>(j)] = false;
    }
  }

  void finish(double stretch, double prominence) {
    if (pairs_.size() < 3) return;
    const auto m = static_cast<double>(pairs_.size());
    const double mean = stretch / (m * (m - 1) / 2);
    double cost = mean + 1 - prominence / all_prominences_;
    const auto is_too_dear = [&] { return best_.size() == n_ && cost >= best_.front().cost; };
    if (is_too_dear()) return;
    cost += std::min(1.0, mean / little) * all_broken * n_broken() / m;
    if (is_too_dear()) return;
    best_.push_back({pairs_, cost});
    std::push_heap(best_.begin(), best_.end(), is_cheaper);
    if (best_.size() <= n_) return;
    std::pop_heap(best_.begin(), best_.end(), is_cheaper);
    best_.pop_back();
  }

  const std::vector<SurfaceTip>* tips_[2];
  std::size_t n_;
  double all_prominences_ = 0;
  std::vector<bool> is_used_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<TipAssignment> best_;  // a heap, the dearest first
};

}  // namespace

std::vector<TipAssignment> assign_tips(const std::vector<SurfaceTip>& tips_1, const std::vector<SurfaceTip>& tips_2,
                                       std::size_t n) {
  return TipSearch(tips_1, tips_2, n).run();
}

Features tip_features(const SpectralShape& shape, const TipAssignment& assignment, int s) {
  Features features(static_cast<Eigen::Index>(assignment.pairs.size()), static_cast<Eigen::Index>(shape.n_vertices()));
  const auto tip = [&](const std::pair<int, int>& p) -> const SurfaceTip& {
    return shape.tips[static_cast<std::size_t>(s == 0 ? p.first : p.second)];
  };
  for (std::size_t k = 0; k < assignment.pairs.size(); ++k) {
    const std::vector<double>& distances = tip(assignment.pairs[k]).distances;
    double sum = 0;
    for (const auto& other : assignment.pairs) sum += distances[tip(other).vertex];
    for (std::size_t v = 0; v < distances.size(); ++v)
      features(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(v)) = static_cast<float>(distances[v] / sum);
  }
  return features;
}

namespace {

/// All orders of 0 to n that swap disjoint neighbours i, i + 1 with is_close[i].
std::vector<std::vector<int>> swapped_orders(int n, const std::vector<bool>& is_close) {
  std::vector<int> identity(static_cast<std::size_t>(n) + 1);
  std::iota(identity.begin(), identity.end(), 0);
  std::vector<std::vector<int>> orders = {identity};
  for (int i = 1; i < n; ++i) {
    if (!is_close[i]) continue;
    const std::size_t before = orders.size();
    for (std::size_t k = 0; k < before; ++k) {
      if (orders[k][i] != i) continue;
      orders.push_back(orders[k]);
      std::swap(orders.back()[i], orders.back()[i + 1]);
    }
  }
  return orders;
}

}  // namespace

std::vector<Eigen::MatrixXd> start_maps(const Eigen::VectorXd& values_1, const Eigen::VectorXd& values_2, int n,
                                        double swap_ratio) {
  std::vector<bool> is_close(static_cast<std::size_t>(n) + 1, false);
  for (int i = 1; i < n; ++i)
    is_close[i] = std::min(values_1[i + 1] / values_1[i], values_2[i + 1] / values_2[i]) < swap_ratio;
  std::vector<Eigen::MatrixXd> starts;
  for (const std::vector<int>& order : swapped_orders(n, is_close))
    for (int signs = 0; signs < 1 << n; ++signs) {
      Eigen::MatrixXd c = Eigen::MatrixXd::Zero(n + 1, n + 1);
      c(0, 0) = 1;
      for (int i = 1; i <= n; ++i) c(i, order[i]) = (signs >> (i - 1)) & 1 ? -1 : 1;
      starts.push_back(std::move(c));
    }
  return starts;
}

// Triangulated spheres: 1.0001; animals and people: 2 and more; the cube's three agree exactly.
bool has_no_axes(const Eigen::VectorXd& values) { return values[3] < 1.02 * values[1]; }

}  // namespace shellmatch
