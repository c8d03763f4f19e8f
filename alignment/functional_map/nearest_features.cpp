#include "alignment/functional_map/nearest_features.h"

#include "base/registers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

// As many as a register of the machine has. Results do not depend on it.
constexpr Eigen::Index width = register_bytes / sizeof(float);
using Lanes = Register<float, width>;

constexpr float infinity = std::numeric_limits<float>::infinity();

// A loop over the lanes would take them apart one by one.
template <Eigen::Index n>
float least_of_lanes(const Register<float, n>& v) {
  if constexpr (n <= 4) {
    return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
  } else {
    Register<float, n / 2> halves[2];
    std::memcpy(halves, &v, sizeof v);
    return least_of_lanes<n / 2>(halves[0] < halves[1] ? halves[0] : halves[1]);
  }
}

float least_of(const Lanes& v) { return least_of_lanes<width>(v); }

/// Squares of a matrix' columns, halved.
Eigen::VectorXf half_squares(const Features& features) { return 0.5f * features.colwise().squaredNorm().transpose(); }

/// All targets, `width` side by side. |t - q|^2 / 2 = |q|^2 / 2 + (|t|^2 / 2 - t . q), so that the nearest target
/// has the least bracket.
class AllTargets {
 public:
  explicit AllTargets(const Features& targets)
      : n_rows_(targets.rows()),
        values_(static_cast<std::size_t>((targets.cols() + width - 1) / width * (n_rows_ + 1)), Lanes{} + infinity) {
    const Eigen::VectorXf squares = half_squares(targets);
    for (Eigen::Index t = 0; t < targets.cols(); t += width) {
      const Eigen::Index n = std::min(width, targets.cols() - t);
      Lanes* group = &values_[static_cast<std::size_t>(t / width * (n_rows_ + 1))];
      for (Eigen::Index i = 0; i < n; ++i) group[0][i] = squares[t + i];
      for (Eigen::Index r = 0; r < n_rows_; ++r) {
        group[1 + r] = Lanes{};
        for (Eigen::Index i = 0; i < n; ++i) group[1 + r][i] = targets(r, t + i);
      }
    }
  }

  void search(const Features& queries, std::vector<Index>& nearest) const {
    std::vector<std::array<float, block>> values(static_cast<std::size_t>(n_rows_));
    for (Eigen::Index q = 0; q < queries.cols(); q += block) {
      const Eigen::Index n = std::min(block, queries.cols() - q);
      for (Eigen::Index j = 0; j < block; ++j)
        for (Eigen::Index r = 0; r < n_rows_; ++r)
          values[static_cast<std::size_t>(r)][static_cast<std::size_t>(j)] = queries(r, q + std::min(j, n - 1));
      search_block(values, {&nearest[static_cast<std::size_t>(q)], static_cast<std::size_t>(n)});
    }
  }

 private:
  using IndexLanes = Register<std::int32_t, width>;
  static constexpr Eigen::Index block = 8;  // queries at once

  void search_block(const std::vector<std::array<float, block>>& queries, std::span<Index> nearest) const {
    Lanes best[block];
    IndexLanes at[block] = {};  // group
    for (Lanes& b : best) b = Lanes{} + infinity;
    const auto n_groups = static_cast<std::int32_t>(values_.size() / static_cast<std::size_t>(n_rows_ + 1));
    const Lanes* values = values_.data();
    for (std::int32_t g = 0; g < n_groups; ++g) {
      Lanes brackets[block];
      for (Lanes& b : brackets) b = *values;
      ++values;
      for (const auto& query : queries) {
        for (std::size_t j = 0; j < block; ++j) brackets[j] -= *values * query[j];
        ++values;
      }
      for (std::size_t j = 0; j < block; ++j) {
        const auto is_less = brackets[j] < best[j];
        best[j] = is_less ? brackets[j] : best[j];
        at[j] = is_less ? IndexLanes{} + g : at[j];
      }
    }
    for (std::size_t j = 0; j < nearest.size(); ++j) {
      std::pair<float, Index> first(infinity, 0);
      for (Index i = 0; i < width; ++i)
        first = std::min(first, {best[j][i], static_cast<Index>(at[j][i]) * Index{width} + i});
      nearest[j] = first.second;
    }
  }

  Eigen::Index n_rows_;
  std::vector<Lanes> values_;  // of each group: half squares, then row by row; unused: infinity
};

/// Targets in clusters of `width`, each with its centre and the radius of a ball that holds it.
class TargetClusters {
 public:
  TargetClusters(const Features& targets, std::span<const Index> order)
      : n_rows_(targets.rows()),
        n_clusters_((targets.cols() + width - 1) / width),
        n_groups_((n_clusters_ + width - 1) / width),
        members_(static_cast<std::size_t>(n_clusters_)),
        values_(static_cast<std::size_t>(n_clusters_ * n_rows_), Lanes{} + infinity),
        centres_(static_cast<std::size_t>(n_groups_ * n_rows_), Lanes{} + infinity),
        radii_(static_cast<std::size_t>(n_groups_), Lanes{}) {
    for (Eigen::Index c = 0; c < n_clusters_; ++c) add_cluster(targets, order, c);
  }

  void search(const Features& queries, std::vector<Index>& nearest) {
    distances_.resize(static_cast<std::size_t>(query_block * n_groups_));
    for (Eigen::Index q = 0; q < queries.cols(); q += query_block) {
      const Eigen::Index n = std::min(query_block, queries.cols() - q);
      const float* block[query_block];
      for (Eigen::Index j = 0; j < query_block; ++j) block[j] = &queries(0, q + std::min(j, n - 1));
      measure_centres(block);
      for (Eigen::Index j = 0; j < n; ++j)
        nearest[static_cast<std::size_t>(q + j)] =
            nearest_to(block[j], &distances_[static_cast<std::size_t>(j * n_groups_)]);
    }
  }

 private:
  static constexpr Eigen::Index query_block = 4;
  // More than the error of a distance in single precision.
  static constexpr float slack = 1.001f;

  struct Best {
    float distance2 = infinity;
    Index target = 0;
  };

  void add_cluster(const Features& targets, std::span<const Index> order, Eigen::Index c) {
    const Eigen::Index begin = c * width, n = std::min(width, targets.cols() - begin);
    Eigen::VectorXf centre = Eigen::VectorXf::Zero(n_rows_);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Index target = order[static_cast<std::size_t>(begin + i)];
      members_[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] = target;
      centre += targets.col(target);
      for (Eigen::Index r = 0; r < n_rows_; ++r)
        values_[static_cast<std::size_t>(c * n_rows_ + r)][i] = targets(r, target);
    }
    centre /= static_cast<float>(n);
    for (Eigen::Index r = 0; r < n_rows_; ++r)
      centres_[static_cast<std::size_t>(c / width * n_rows_ + r)][c % width] = centre[r];
    const Lanes distances2 = distances2_in(c, centre.data(), infinity);
    float radius = 0;
    for (Eigen::Index i = 0; i < n; ++i) radius = std::max(radius, std::sqrt(distances2[i]));
    radii_[static_cast<std::size_t>(c / width)][c % width] = radius;
  }

  /// Squares of the distances of a cluster's members from x; of all members that are farther than sqrt(most2),
  /// lower bounds may be returned instead.
  Lanes distances2_in(Eigen::Index c, const float* x, float most2) const {
    constexpr Eigen::Index n_at_once = 16;
    const Lanes* values = &values_[static_cast<std::size_t>(c * n_rows_)];
    Lanes sums[4] = {};  // additions that do not wait for each other
    const auto add = [&](Eigen::Index r, int k) {
      const Lanes difference = values[r] - x[r];
      sums[k] += difference * difference;
    };
    // The last rows, of normals and local features, differ most within a cluster.
    Eigen::Index r = n_rows_;
    for (; r >= n_at_once; r -= n_at_once) {
      for (int k = 1; k <= n_at_once; ++k) add(r - k, k % 4);
      const Lanes so_far = (sums[0] + sums[1]) + (sums[2] + sums[3]);
      if (least_of(so_far) > most2) return so_far;
    }
    while (r > 0) add(--r, 0);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }

  /// Squares of the distances of all centres from the queries of a block.
  void measure_centres(const float* const (&block)[query_block]) {
    for (Eigen::Index g = 0; g < n_groups_; ++g) {
      const Lanes* values = &centres_[static_cast<std::size_t>(g * n_rows_)];
      Lanes sums[query_block] = {};
      for (Eigen::Index r = 0; r < n_rows_; ++r)
        for (Eigen::Index j = 0; j < query_block; ++j) {
          const Lanes difference = values[r] - block[j][r];
          sums[j] += difference * difference;
        }
      for (Eigen::Index j = 0; j < query_block; ++j) distances_[static_cast<std::size_t>(j * n_groups_ + g)] = sums[j];
    }
  }

  Index nearest_to(const float* query, const Lanes* to_centres) const {
    Best best;
    const Eigen::Index first = nearest_centre(to_centres);
    visit(query, first, best);
    for (Eigen::Index g = 0; g < n_groups_; ++g) {
      const Lanes most = (radii_[static_cast<std::size_t>(g)] + std::sqrt(best.distance2)) * slack;
      const Lanes excess = to_centres[g] - most * most;
      if (least_of(excess) > 0) continue;
      for (Eigen::Index i = 0, end = std::min(width, n_clusters_ - g * width); i < end; ++i)
        if (!(excess[i] > 0) && g * width + i != first) visit(query, g * width + i, best);
    }
    return best.target;
  }

  Eigen::Index nearest_centre(const Lanes* to_centres) const {
    Eigen::Index group = 0;
    float least = infinity;
    for (Eigen::Index g = 0; g < n_groups_; ++g)
      if (const float here = least_of(to_centres[g]); here < least) least = here, group = g;
    for (Eigen::Index i = 0; i < width; ++i)
      if (to_centres[group][i] == least) return group * width + i;
    return 0;
  }

  void visit(const float* query, Eigen::Index c, Best& best) const {
    const Lanes distances2 = distances2_in(c, query, best.distance2);
    if (least_of(distances2) > best.distance2) return;
    const auto& members = members_[static_cast<std::size_t>(c)];
    for (Eigen::Index i = 0; i < width; ++i) {
      const Index target = members[static_cast<std::size_t>(i)];
      const bool is_nearer =
          distances2[i] < best.distance2 || (distances2[i] == best.distance2 && target < best.target);
      if (is_nearer) best = {distances2[i], target};
    }
  }

  Eigen::Index n_rows_, n_clusters_, n_groups_;
  std::vector<std::array<Index, width>> members_;  // of each cluster
  std::vector<Lanes> values_;                      // of each cluster's members, row by row; unused: infinity
  std::vector<Lanes> centres_;                     // of `width` clusters each, row by row; unused: infinity
  std::vector<Lanes> radii_;                       // of `width` clusters each
  std::vector<Lanes> distances_;                   // from all centres, for each query of a block
};

/// Sorts `some` into clusters of near columns: the larger half of the range is a whole number of them.
void sort_compactly(const Features& features, std::span<Index> some) {
  constexpr Eigen::Index most_rows = 12;
  const auto n = static_cast<Eigen::Index>(some.size());
  if (n <= width) return;
  const Eigen::Index n_rows = std::min(most_rows, features.rows());
  Eigen::VectorXf low = features.col(some[0]).head(n_rows), high = low;
  for (const Index i : some) {
    low = low.cwiseMin(features.col(i).head(n_rows));
    high = high.cwiseMax(features.col(i).head(n_rows));
  }
  Eigen::Index row = 0;
  (high - low).maxCoeff(&row);
  const Eigen::Index half = (n / width + 1) / 2 * width;
  std::ranges::nth_element(some, some.begin() + half, {}, [&](Index i) {
    const float value = features(row, i);
    return std::pair(std::isnan(value) ? infinity : value, i);
  });
  sort_compactly(features, some.first(static_cast<std::size_t>(half)));
  sort_compactly(features, some.subspan(static_cast<std::size_t>(half)));
}

}  // namespace

std::vector<Index> compact_order(const Features& features) {
  std::vector<Index> order(static_cast<std::size_t>(features.cols()));
  std::iota(order.begin(), order.end(), 0);
  if (features.rows() > 0) sort_compactly(features, order);
  return order;
}

std::vector<Index> nearest_features(const Features& targets, const Features& queries, std::span<const Index> order) {
  std::vector<Index> nearest(static_cast<std::size_t>(queries.cols()), 0);
  // Bounds cost more than they save.
  constexpr Eigen::Index few_rows = 32;
  if (targets.rows() <= few_rows) {
    AllTargets(targets).search(queries, nearest);
    return nearest;
  }
  std::vector<Index> own;
  if (order.empty()) {
    own = compact_order(targets);
    order = own;
  }
  TargetClusters(targets, order).search(queries, nearest);
  return nearest;
}

}  // namespace shellmatch
