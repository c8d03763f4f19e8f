#include "alignment/functional_map/starts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace shellmatch {

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
