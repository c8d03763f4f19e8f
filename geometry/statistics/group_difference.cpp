#include "geometry/statistics/group_difference.h"

#include "base/decompositions.h"
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/statistics/products.h"
#include "geometry/statistics/random.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace shellmatch {

namespace {

// Shares s that differ by less are equal: rounding of sums over the shapes is far below.
constexpr double equal_shares = 1e-11;
constexpr Eigen::Index splits_at_once = 128;
constexpr std::size_t points_at_once = 64;

// One row for each coordinate of a point, one column for each shape: deviations from the mean of all, in coordinates in
// which the sum of their outer products is the identity; 0 in directions in which the point does not move.
template <int Dim>
void whiten(Eigen::Ref<Eigen::Matrix<double, Dim, Eigen::Dynamic>> x, double rounding) {
  constexpr double relative = 1e-12;
  x.colwise() -= (x.rowwise().sum() / static_cast<double>(x.cols())).eval();
  Mat<Dim> scatter = Mat<Dim>::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) scatter += x.col(i) * x.col(i).transpose();
  const Eigenpairs<Dim> pairs = eigenpairs(scatter);
  const double least = std::max(relative * pairs.values[Dim - 1], static_cast<double>(x.cols()) * rounding * rounding);
  Vec<Dim> factors;
  for (int k = 0; k < Dim; ++k) factors[k] = pairs.values[k] > least ? 1 / std::sqrt(pairs.values[k]) : 0;
  const Mat<Dim> transform = factors.asDiagonal() * pairs.vectors.transpose();
  for (Eigen::Index i = 0; i < x.cols(); ++i) x.col(i) = (transform * x.col(i)).eval();
}

// Shares s of points under splits, chunk by chunk of the points.
template <int Dim>
class PointTests {
 public:
  PointTests(const PointSets& sets, const Splits& splits, const Eigen::MatrixXd& observed, double factor)
      : sets_(sets), splits_(splits), observed_(observed), factor_(factor), rounding_(rounding_of(sets)) {
    const auto n_points = static_cast<std::size_t>(sets.n_points());
    shares.setZero(sets.n_points());
    n_as_great.setZero(sets.n_points());
    greatest.setZero(splits.size());
    std::mutex mutex;
    parallel_chunks(n_points, points_at_once, [&](const Chunk& c) {
      const Eigen::ArrayXd of_chunk = test(c);
      const std::lock_guard lock(mutex);  // in any order: the greatest of numbers does not depend on it
      greatest = greatest.max(of_chunk);
    });
  }

  Eigen::ArrayXd shares;      // of the observed split, a point each
  Eigen::ArrayXd n_as_great;  // of all splits, a point each
  Eigen::ArrayXd greatest;    // of all points, a split each

 private:
  // The greatest share of these points, a split each.
  Eigen::ArrayXd test(const Chunk& c) {
    const auto begin = static_cast<Eigen::Index>(c.begin), n = static_cast<Eigen::Index>(c.end - c.begin);
    Eigen::MatrixXd deviations = sets_.coordinates.middleRows(Dim * begin, Dim * n), sums;
    for (Eigen::Index p = 0; p < n; ++p) whiten<Dim>(deviations.middleRows<Dim>(Dim * p), rounding_);
    const auto share = [&](Eigen::Index p, Eigen::Index split) {
      return factor_ * sums.col(split).template segment<Dim>(Dim * p).squaredNorm();
    };
    multiply(deviations, observed_, sums);
    for (Eigen::Index p = 0; p < n; ++p) shares[begin + p] = share(p, 0);
    Eigen::ArrayXd most = Eigen::ArrayXd::Zero(splits_.size());
    for (Eigen::Index first = 0; first < splits_.size(); first += splits_at_once) {
      const Eigen::Index count = std::min(splits_at_once, splits_.size() - first);
      multiply(deviations, splits_.indicators(first, count), sums);
      for (Eigen::Index split = 0; split < count; ++split)
        for (Eigen::Index p = 0; p < n; ++p) {
          const double s = share(p, split);
          if (s >= shares[begin + p] - equal_shares) ++n_as_great[begin + p];
          most[first + split] = std::max(most[first + split], s);
        }
    }
    return most;
  }

  const PointSets& sets_;
  const Splits& splits_;
  const Eigen::MatrixXd& observed_;
  double factor_, rounding_;
};

template <int Dim>
void add_point_tests(const PointSets& sets, const Splits& splits, const Eigen::MatrixXd& observed,
                     GroupDifference& result) {
  const double n_a = result.n_a, n_b = result.n_b, n = n_a + n_b, n_splits = static_cast<double>(splits.size());
  // The sum over group B of deviations from the mean of all is n_a n_b / n times the difference of the means.
  PointTests<Dim> tests(sets, splits, observed, n / (n_a * n_b));
  result.statistic = ((n - 2) * tests.shares / (1 - tests.shares).max(equal_shares)).matrix();
  result.p = (tests.n_as_great / n_splits).matrix();
  std::sort(tests.greatest.begin(), tests.greatest.end());
  result.p_corrected.resize(sets.n_points());
  for (Eigen::Index p = 0; p < sets.n_points(); ++p) {
    const auto first = std::lower_bound(tests.greatest.begin(), tests.greatest.end(), tests.shares[p] - equal_shares);
    result.p_corrected[p] = static_cast<double>(tests.greatest.end() - first) / n_splits;
  }
  result.q = false_discovery_rates(result.p);
}

void add_global_test(const PointSets& sets, const Eigen::VectorXd& weights, const Splits& splits,
                     const Eigen::MatrixXd& observed, GroupDifference& result) {
  const Eigen::VectorXd mean = mean_of(sets);
  const Eigen::MatrixXd gram = gram_matrix({sets.coordinates, &mean}, weights);
  Eigen::MatrixXd product;
  const auto squares = [&](const Eigen::MatrixXd& indicators) -> Eigen::ArrayXd {  // of the sums over group B
    multiply(gram, indicators, product);
    return indicators.cwiseProduct(product).colwise().sum().transpose();
  };
  const double n_a = result.n_a, n_b = result.n_b;
  const double equal = 1e-12 * n_b * gram.trace();  // rounding of a sum that is at most n_b times the trace
  const double least = squares(observed)[0] - equal;
  Eigen::Index n_as_great = 0;
  for (Eigen::Index first = 0; first < splits.size(); first += splits_at_once)
    n_as_great += (squares(splits.indicators(first, std::min(splits_at_once, splits.size() - first))) >= least).count();
  result.global_p = static_cast<double>(n_as_great) / static_cast<double>(splits.size());
  result.difference = combinations({sets.coordinates, &mean}, observed * ((n_a + n_b) / (n_a * n_b)));
  result.distance = std::sqrt(gram_matrix({result.difference}, weights)(0, 0));
}

}  // namespace

GroupDifference group_difference(const PointSets& aligned, const Eigen::VectorXd& weights,
                                 const std::vector<char>& is_b, int n_permutations, std::uint64_t seed) {
  check_point_sets(aligned, weights);
  const Eigen::Index n = aligned.n_sets();
  if (std::ssize(is_b) != n) throw_input_error("{} memberships of groups for {} shapes", is_b.size(), n);
  if (n_permutations < 1)
    throw_input_error("{} permutations; at least one is needed, the observed one", n_permutations);
  GroupDifference result;
  for (const char b : is_b) ++(b != 0 ? result.n_b : result.n_a);
  if (result.n_a < 2 || result.n_b < 2 || n < aligned.dimension + 2)
    throw_input_error(
        "groups of {} and {} shapes: a comparison at points of {} coordinates needs two shapes in each group and {} in "
        "both",
        result.n_a, result.n_b, aligned.dimension, aligned.dimension + 2);
  const Splits splits(is_b, n_permutations, seed);
  result.n_permutations = static_cast<int>(splits.size());
  result.all_permutations = splits.are_all();
  Eigen::MatrixXd observed(n, 1);
  for (Eigen::Index i = 0; i < n; ++i) observed(i, 0) = is_b[static_cast<std::size_t>(i)] != 0 ? 1 : 0;
  aligned.dimension == 2 ? add_point_tests<2>(aligned, splits, observed, result)
                         : add_point_tests<3>(aligned, splits, observed, result);
  add_global_test(aligned, weights, splits, observed, result);
  return result;
}

Eigen::VectorXd false_discovery_rates(const Eigen::VectorXd& p) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(p.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return p[a] < p[b]; });
  Eigen::VectorXd q(p.size());
  double least = 1;
  for (std::size_t i = order.size(); i-- > 0;) {
    least = std::min(least, p[order[i]] * (static_cast<double>(order.size()) / static_cast<double>(i + 1)));
    q[order[i]] = least;
  }
  return q;
}

}  // namespace shellmatch
