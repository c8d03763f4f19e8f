#include "geometry/statistics/products.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <utility>
#include <vector>

namespace shellmatch {

GramEigen gram_eigen(const Eigen::MatrixXd& gram, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  SHELLMATCH_CHECK(solver.info() == Eigen::Success, "the inner products of shapes have eigenvalues");
  const Eigen::Index n = gram.rows();
  const double limit = n == 0 ? 0 : std::max(least, least_variance_share * solver.eigenvalues()[n - 1]);
  Eigen::Index kept = 0;
  while (kept < n && solver.eigenvalues()[n - 1 - kept] > limit) ++kept;
  return {solver.eigenvalues().reverse().head(kept), solver.eigenvectors().rowwise().reverse().leftCols(kept)};
}

Eigen::MatrixXd orthonormalising_combinations(const Eigen::MatrixXd& gram) {
  const Eigen::LLT<Eigen::MatrixXd> factor(gram);
  SHELLMATCH_CHECK(factor.info() == Eigen::Success, "modes are linearly independent");
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(gram.rows(), gram.cols());
  factor.matrixU().solveInPlace(inverse);
  return inverse;
}

namespace {

// A tile of the result is a task; it reads its columns in blocks of rows, which fit into the cache.
constexpr Eigen::Index tile = 64, rows_at_once = 480;
// Columns of a product of combine(). Eigen chooses the order of sums by the sizes of the factors and the processor's
// caches.
constexpr Eigen::Index columns_at_once = 16;

struct Range {
  Eigen::Index begin, size;
};

// Rows of some columns, without the centre.
void load(const Shapes& shapes, const Range& rows, const Range& columns, Eigen::MatrixXd& block) {
  block = shapes.columns.block(rows.begin, columns.begin, rows.size, columns.size);
  if (shapes.centre != nullptr) block.colwise() -= shapes.centre->segment(rows.begin, rows.size);
}

// The weights of the rows: as many consecutive ones for a point as it has coordinates.
Eigen::VectorXd weights_of_rows(Eigen::Index n_rows, const Eigen::VectorXd& weights) {
  SHELLMATCH_CHECK(weights.size() > 0 && n_rows % weights.size() == 0, "every point has a weight");
  const Eigen::Index dimension = n_rows / weights.size();
  Eigen::VectorXd of_rows(n_rows);
  for (Eigen::Index row = 0; row < n_rows; ++row) of_rows[row] = weights[row / dimension];
  return of_rows;
}

Eigen::MatrixXd products(const Shapes& a, const Shapes& b, const Eigen::VectorXd& weights, bool symmetric) {
  SHELLMATCH_CHECK(a.columns.rows() == b.columns.rows(), "inner products are those of shapes with the same points");
  const Eigen::Index n_rows = a.columns.rows();
  const Eigen::VectorXd of_rows = weights_of_rows(n_rows, weights);
  Eigen::MatrixXd result(a.columns.cols(), b.columns.cols());
  std::vector<std::pair<Range, Range>> tiles;
  for (Eigen::Index j = 0; j < result.cols(); j += tile)
    for (Eigen::Index i = 0; i < (symmetric ? j + 1 : result.rows()); i += tile)
      tiles.push_back({{i, std::min(tile, result.rows() - i)}, {j, std::min(tile, result.cols() - j)}});
  parallel_for(
      tiles.size(),
      [&](std::size_t t) {
        const auto& [left, right] = tiles[t];
        Eigen::MatrixXd from_a, from_b, sum = Eigen::MatrixXd::Zero(left.size, right.size);
        for (Eigen::Index row = 0; row < n_rows; row += rows_at_once) {
          stop_if_wanted();
          const Range rows{row, std::min(rows_at_once, n_rows - row)};
          load(a, rows, left, from_a);
          load(b, rows, right, from_b);
          from_a.array().colwise() *= of_rows.segment(row, rows.size).array();
          sum.noalias() += from_a.transpose() * from_b;
        }
        result.block(left.begin, right.begin, left.size, right.size) = sum;
      },
      1);
  return result;
}

// All products have the same sizes, filled up with zeros, so that a column is the same to the bit whatever comes after
// it.
template <class Write>
void combine(const Shapes& a, const Eigen::MatrixXd& coefficients, const Write& write) {
  SHELLMATCH_CHECK(a.columns.cols() == coefficients.rows(), "every column has a coefficient");
  parallel_chunks(static_cast<std::size_t>(a.columns.rows()), static_cast<std::size_t>(rows_at_once),
                  [&](const Chunk& c) {
                    const Range rows{static_cast<Eigen::Index>(c.begin), static_cast<Eigen::Index>(c.end - c.begin)};
                    Eigen::MatrixXd block, product, padded(coefficients.rows(), columns_at_once);
                    load(a, rows, {0, a.columns.cols()}, block);
                    for (Eigen::Index begin = 0; begin < coefficients.cols(); begin += columns_at_once) {
                      const Range columns{begin, std::min(columns_at_once, coefficients.cols() - begin)};
                      padded.leftCols(columns.size) = coefficients.middleCols(columns.begin, columns.size);
                      padded.rightCols(columns_at_once - columns.size).setZero();
                      multiply(block, padded, product);
                      write(rows, columns, product.leftCols(columns.size));
                    }
                  });
}

}  // namespace

Eigen::MatrixXd inner_products(const Shapes& a, const Shapes& b, const Eigen::VectorXd& weights) {
  return products(a, b, weights, false);
}

Eigen::MatrixXd gram_matrix(const Shapes& a, const Eigen::VectorXd& weights) {
  Eigen::MatrixXd gram = products(a, a, weights, true);
  for (Eigen::Index j = 0; j < gram.cols(); ++j)
    for (Eigen::Index i = j + 1; i < gram.rows(); ++i) gram(i, j) = gram(j, i);
  return gram;
}

Eigen::MatrixXd combinations(const Shapes& a, const Eigen::MatrixXd& coefficients) {
  Eigen::MatrixXd result(a.columns.rows(), coefficients.cols());
  combine(a, coefficients, [&](const Range& rows, const Range& columns, const auto& product) {
    result.block(rows.begin, columns.begin, rows.size, columns.size) = product;
  });
  return result;
}

void combine_in_place(Eigen::MatrixXd& a, const Eigen::MatrixXd& coefficients) {
  SHELLMATCH_CHECK(coefficients.rows() == coefficients.cols(), "in place there is room for as many columns as before");
  combine({a}, coefficients, [&](const Range& rows, const Range& columns, const auto& product) {
    a.block(rows.begin, columns.begin, rows.size, columns.size) = product;
  });
}

void multiply(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::MatrixXd& c) { c.noalias() = a * b; }

}  // namespace shellmatch
