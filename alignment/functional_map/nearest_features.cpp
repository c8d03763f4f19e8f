#include "alignment/functional_map/nearest_features.h"

#include <algorithm>
#include <limits>

namespace shellmatch {

std::vector<Index> nearest_features(const Features& targets, const Features& queries) {
  // |t - q|^2 / 2 = |q|^2 / 2 - (t . q - |t|^2 / 2), so that the nearest target has the greatest bracket.
  constexpr Eigen::Index target_block = 512, query_block = 64;
  const Eigen::VectorXf half_squares = 0.5f * targets.colwise().squaredNorm().transpose();
  std::vector<Index> nearest(static_cast<std::size_t>(queries.cols()), 0);
  Eigen::MatrixXf products(target_block, query_block);
  for (Eigen::Index q = 0; q < queries.cols(); q += query_block) {
    const Eigen::Index n_queries = std::min(query_block, queries.cols() - q);
    Eigen::VectorXf best = Eigen::VectorXf::Constant(n_queries, -std::numeric_limits<float>::infinity());
    for (Eigen::Index t = 0; t < targets.cols(); t += target_block) {
      const Eigen::Index n_targets = std::min(target_block, targets.cols() - t);
      auto block = products.topLeftCorner(n_targets, n_queries);
      block.noalias() = targets.middleCols(t, n_targets).transpose() * queries.middleCols(q, n_queries);
      block.colwise() -= half_squares.segment(t, n_targets);
      for (Eigen::Index j = 0; j < n_queries; ++j) {
        const float greatest = block.col(j).maxCoeff();
        if (!(greatest > best[j])) continue;
        best[j] = greatest;
        const float* begin = block.col(j).data();
        nearest[static_cast<std::size_t>(q + j)] =
            static_cast<Index>(t + (std::find(begin, begin + n_targets, greatest) - begin));
      }
    }
  }
  return nearest;
}

}  // namespace shellmatch
