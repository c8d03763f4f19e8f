#include "solvers/metric/cholmod_factor.h"

#include "base/error.h"

#include <cholmod.h>

#include <cmath>

// Of libgomp, which CHOLMOD brings along where it was built with OpenMP.
extern "C" [[gnu::weak]] void omp_set_max_active_levels(int);

namespace shellmatch {

namespace {

// CHOLMOD's loops stay in the calling thread, as the number of threads is the user's choice (base/parallel.h). Where
// the system refused a thread, libgomp would end the program. They hold none of the work: that is BLAS'.
void keep_to_one_thread() {
  if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
}

}  // namespace

/// Owns CHOLMOD's objects. Every solve writes to the workspace, so solves must not run in parallel.
struct SparseFactor::Content {
  Eigen::SparseMatrix<double> matrix;
  int n_components;
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense *in = nullptr, *permuted = nullptr, *out = nullptr, *y = nullptr, *e = nullptr;

  Content(Eigen::SparseMatrix<double> m, int n) : matrix(std::move(m)), n_components(n) {
    keep_to_one_thread();
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
  }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  ~Content() {
    cholmod_free_factor(&factor, &common);
    for (cholmod_dense** d : {&in, &permuted, &out, &y, &e}) cholmod_free_dense(d, &common);
    cholmod_finish(&common);
  }

  [[noreturn]] static void throw_no_memory_to_solve() {
    throw MemoryError(
        "there is not enough memory to solve with the factor of the metric; use solver.metric l2, or a coarser grid");
  }

  std::size_t n_rows() const { return static_cast<std::size_t>(matrix.rows()); }

  void factorise() {
    cholmod_sparse lower{};
    lower.nrow = lower.ncol = n_rows();
    lower.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    lower.p = matrix.outerIndexPtr();
    lower.i = matrix.innerIndexPtr();
    lower.x = matrix.valuePtr();
    lower.stype = -1;  // entries above the diagonal are ignored
    lower.itype = CHOLMOD_INT;
    lower.xtype = CHOLMOD_REAL;
    lower.dtype = CHOLMOD_DOUBLE;
    lower.sorted = lower.packed = 1;
    factor = cholmod_analyze(&lower, &common);
    if (factor != nullptr) cholmod_factorize(&lower, factor, &common);
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
      throw MemoryError(
          fmt::format("there is not enough memory for the factor of the metric on {} nodes; use solver.metric l2, or a "
                      "coarser grid",
                      n_rows()));
    if (common.status != CHOLMOD_OK)
      throw_input_error(
          "the metric's matrix is not positive definite (pivot {} of {}); use solver.metric l2, or weights > 0",
          factor == nullptr ? 0 : factor->minor, n_rows());
    in = cholmod_zeros(n_rows(), static_cast<std::size_t>(n_components), CHOLMOD_REAL, &common);
    if (in == nullptr) throw_no_memory_to_solve();
  }

  /// out = second(first(in)), where both are CHOLMOD's codes of partial solves.
  void solve(std::span<const double> from, int first, int second, std::span<double> to) {
    keep_to_one_thread();  // of whatever thread calls
    double* values = static_cast<double*>(in->x);
    const std::size_t n = n_rows(), m = static_cast<std::size_t>(n_components);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < m; ++k) values[k * n + i] = from[i * m + k];
    const bool solved = cholmod_solve2(first, factor, in, nullptr, &permuted, nullptr, &y, &e, &common) != 0 &&
                        cholmod_solve2(second, factor, permuted, nullptr, &out, nullptr, &y, &e, &common) != 0;
    if (!solved) throw_no_memory_to_solve();
    const double* result = static_cast<const double*>(out->x);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < m; ++k) to[i * m + k] = result[k * n + i];
  }
};

SparseFactor::SparseFactor(Eigen::SparseMatrix<double> matrix, int n_components)
    : content_(std::make_unique<Content>(std::move(matrix), n_components)) {
  SHELLMATCH_CHECK(content_->matrix.rows() == content_->matrix.cols() && n_components > 0,
                   "a metric's matrix is square");
  content_->matrix.makeCompressed();
  content_->factorise();
}
SparseFactor::~SparseFactor() = default;

std::size_t SparseFactor::size() const { return content_->n_rows() * static_cast<std::size_t>(content_->n_components); }

// CHOLMOD solves with L but does not multiply by it: L^T P x = L^{-1} P M x.
void SparseFactor::apply(std::span<const double> x, std::span<double> y) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Index n = content_->matrix.rows();
  const Rows product = content_->matrix * Eigen::Map<const Rows>(x.data(), n, content_->n_components);
  content_->solve({product.data(), x.size()}, CHOLMOD_P, CHOLMOD_L, y);
}

void SparseFactor::solve(std::span<const double> y, std::span<double> x) const {
  content_->solve(y, CHOLMOD_Lt, CHOLMOD_Pt, x);
}

void SparseFactor::solve_transposed(std::span<const double> g, std::span<double> z) const {
  content_->solve(g, CHOLMOD_P, CHOLMOD_L, z);
}

}  // namespace shellmatch
