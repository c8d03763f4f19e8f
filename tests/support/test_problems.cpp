#include "tests/support/test_problems.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <tuple>
#include <utility>

namespace shellmatch::testing {

namespace {

// Derivatives of one residual: (unknown, derivative).
using Derivatives = std::initializer_list<std::pair<std::size_t, double>>;

// Adds residuals up to the sum of their squares.
struct Accumulator {
  double value = 0;
  std::span<double> gradient;
  TestProblem::Entries* jacobian = nullptr;
  int n_residuals = 0;
  void add(double r, Derivatives derivatives) {
    value += r * r;
    if (jacobian != nullptr)
      for (const auto& [i, d] : derivatives) jacobian->emplace_back(n_residuals, static_cast<int>(i), d);
    ++n_residuals;
    if (gradient.empty()) return;
    for (const auto& [i, d] : derivatives) gradient[i] += 2 * r * d;
  }
};

class SumOfSquares : public TestProblem {
 public:
  SumOfSquares(std::string name, std::vector<double> start, std::vector<double> minimizer, double tolerance = 1e-3)
      : name_(std::move(name)), start_(std::move(start)), minimizer_(std::move(minimizer)), tolerance_(tolerance) {}
  std::string name() const override { return name_; }
  std::size_t size() const override { return start_.size(); }
  std::vector<double> start() const override { return start_; }
  std::vector<double> minimizer() const override { return minimizer_; }
  double coordinate_tolerance() const override { return tolerance_; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    Accumulator sum{.gradient = gradient};
    add_residuals(x, sum);
    value = sum.value;
    return std::isfinite(value);
  }
  Entries jacobian(std::span<const double> x) const override {
    Entries entries;
    Accumulator sum{.gradient = {}, .jacobian = &entries};
    add_residuals(x, sum);
    return entries;
  }

 protected:
  virtual void add_residuals(std::span<const double> x, Accumulator& sum) const = 0;

 private:
  std::string name_;
  std::vector<double> start_, minimizer_;
  double tolerance_;
};

std::vector<double> repeated(std::vector<double> block, std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = block[i % block.size()];
  return x;
}

class Rosenbrock final : public SumOfSquares {
 public:
  explicit Rosenbrock(std::size_t n)
      : SumOfSquares(n == 2 ? "rosenbrock" : fmt::format("extended_rosenbrock_{}", n), repeated({-1.2, 1}, n),
                     repeated({1}, n)) {}
  void add_residuals(std::span<const double> x, Accumulator& sum) const override {
    for (std::size_t i = 0; i < x.size(); i += 2) {
      sum.add(10 * (x[i + 1] - x[i] * x[i]), {{i, -20 * x[i]}, {i + 1, 10}});
      sum.add(1 - x[i], {{i, -1}});
    }
  }
};

class PowellSingular final : public SumOfSquares {
 public:
  explicit PowellSingular(std::size_t n)
      : SumOfSquares(n == 4 ? "powell_singular" : fmt::format("extended_powell_{}", n), repeated({3, -1, 0, 1}, n),
                     repeated({0}, n), 0.1) {}
  void add_residuals(std::span<const double> x, Accumulator& sum) const override {
    const double root5 = std::sqrt(5.0), root10 = std::sqrt(10.0);
    for (std::size_t i = 0; i < x.size(); i += 4) {
      const double a = x[i], b = x[i + 1], c = x[i + 2], d = x[i + 3];
      sum.add(a + 10 * b, {{i, 1}, {i + 1, 10}});
      sum.add(root5 * (c - d), {{i + 2, root5}, {i + 3, -root5}});
      sum.add((b - 2 * c) * (b - 2 * c), {{i + 1, 2 * (b - 2 * c)}, {i + 2, -4 * (b - 2 * c)}});
      sum.add(root10 * (a - d) * (a - d), {{i, 2 * root10 * (a - d)}, {i + 3, -2 * root10 * (a - d)}});
    }
  }
};

class Wood final : public SumOfSquares {
 public:
  Wood() : SumOfSquares("wood", {-3, -1, -3, -1}, {1, 1, 1, 1}) {}
  void add_residuals(std::span<const double> x, Accumulator& sum) const override {
    const double root10 = std::sqrt(10.0), root90 = std::sqrt(90.0);
    sum.add(10 * (x[1] - x[0] * x[0]), {{0, -20 * x[0]}, {1, 10}});
    sum.add(1 - x[0], {{0, -1}});
    sum.add(root90 * (x[3] - x[2] * x[2]), {{2, -2 * root90 * x[2]}, {3, root90}});
    sum.add(1 - x[2], {{2, -1}});
    sum.add(root10 * (x[1] + x[3] - 2), {{1, root10}, {3, root10}});
    sum.add((x[1] - x[3]) / root10, {{1, 1 / root10}, {3, -1 / root10}});
  }
};

class Beale final : public SumOfSquares {
 public:
  Beale() : SumOfSquares("beale", {1, 1}, {3, 0.5}) {}
  void add_residuals(std::span<const double> x, Accumulator& sum) const override {
    const double y[] = {1.5, 2.25, 2.625};
    for (int i = 1; i <= 3; ++i) {
      const double power = std::pow(x[1], i);
      sum.add(y[i - 1] - x[0] * (1 - power), {{0, power - 1}, {1, x[0] * i * std::pow(x[1], i - 1)}});
    }
  }
};

class HelicalValley final : public SumOfSquares {
 public:
  HelicalValley() : SumOfSquares("helical_valley", {-1, 0, 0}, {1, 0, 0}) {}
  void add_residuals(std::span<const double> x, Accumulator& sum) const override {
    constexpr double turn = 2 * std::numbers::pi;
    const double squared = x[0] * x[0] + x[1] * x[1], radius = std::sqrt(squared);
    const double theta = std::atan(x[1] / x[0]) / turn + (x[0] < 0 ? 0.5 : 0);
    sum.add(10 * (x[2] - 10 * theta), {{0, 100 * x[1] / squared / turn}, {1, -100 * x[0] / squared / turn}, {2, 10}});
    sum.add(10 * (radius - 1), {{0, 10 * x[0] / radius}, {1, 10 * x[1] / radius}});
    sum.add(x[2], {{2, 1}});
  }
};

class Trigonometric final : public TestProblem {
 public:
  explicit Trigonometric(std::size_t n) : n_(n) {}
  std::string name() const override { return "trigonometric"; }
  std::size_t size() const override { return n_; }
  std::vector<double> start() const override { return std::vector<double>(n_, 1.0 / static_cast<double>(n_)); }
  std::vector<double> minima() const override { return {0.0, 2.79506e-5}; }  // the local one is for n = 10
  Entries jacobian(std::span<const double> x) const override {
    Entries entries;
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) {
        const double own = i == j ? static_cast<double>(i + 1) * std::sin(x[i]) - std::cos(x[i]) : 0.0;
        entries.emplace_back(static_cast<int>(i), static_cast<int>(j), std::sin(x[j]) + own);
      }
    return entries;
  }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    double cosines = 0;
    for (const double t : x) cosines += std::cos(t);
    value = 0;
    double sum = 0;
    std::vector<double> r(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const auto k = static_cast<double>(i + 1);
      r[i] = static_cast<double>(n_) - cosines + k * (1 - std::cos(x[i])) - std::sin(x[i]);
      value += r[i] * r[i];
      sum += r[i];
    }
    for (std::size_t j = 0; j < gradient.size(); ++j) {
      const auto k = static_cast<double>(j + 1);
      gradient[j] = 2 * (sum * std::sin(x[j]) + r[j] * (k * std::sin(x[j]) - std::cos(x[j])));
    }
    return std::isfinite(value);
  }

 private:
  std::size_t n_;
};

class LogBarrier final : public TestProblem {
 public:
  LogBarrier(std::size_t n, double mu) : n_(n), mu_(mu) {}
  std::string name() const override { return fmt::format("log_barrier_{}_{:g}", n_, mu_); }
  std::size_t size() const override { return n_; }
  std::vector<double> start() const override { return std::vector<double>(n_, 5.0); }
  std::vector<double> minimizer() const override {
    // x = b + mu a / t with t = a.x, hence t^2 - (a.b) t - mu |a|^2 = 0
    double ab = 0, aa = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      ab += a(i) * b(i);
      aa += a(i) * a(i);
    }
    // The root of larger sum, divided into the product of the roots: no cancellation for a.b < 0.
    const double t = 2 * mu_ * aa / (std::sqrt(ab * ab + 4 * mu_ * aa) - ab);
    std::vector<double> x(n_);
    for (std::size_t i = 0; i < n_; ++i) x[i] = b(i) + mu_ * a(i) / t;
    return x;
  }
  std::vector<double> minima() const override {
    auto self = *this;
    double value = 0;
    self.evaluate(minimizer(), value, {});
    return {value};
  }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    double t = 0;
    value = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      t += a(i) * x[i];
      value += 0.5 * (x[i] - b(i)) * (x[i] - b(i));
    }
    if (!(t > 0)) return false;
    value -= mu_ * std::log(t);
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] = x[i] - b(i) - mu_ * a(i) / t;
    return true;
  }
  Entries jacobian(std::span<const double> x) const override {
    double t = 0;
    for (std::size_t i = 0; i < n_; ++i) t += a(i) * x[i];
    Entries entries;
    const int n = static_cast<int>(n_);
    for (int i = 0; i < n; ++i) {
      entries.emplace_back(i, i, std::sqrt(0.5));
      entries.emplace_back(n, i, std::sqrt(0.5 * mu_) * a(static_cast<std::size_t>(i)) / t);
    }
    return entries;
  }

 private:
  double a(std::size_t i) const { return 1 + static_cast<double>(i % 3); }
  double b(std::size_t i) const { return i % 2 == 0 ? -1.0 : -0.25; }
  std::size_t n_;
  double mu_;
};

class WeightedBowl final : public TestProblem {
 public:
  explicit WeightedBowl(std::size_t n) : mass_(n) {
    for (std::size_t i = 0; i < n; ++i) mass_[i] = std::pow(8.0, -static_cast<double>(i % 6));
  }
  std::string name() const override { return "weighted_bowl"; }
  std::size_t size() const override { return mass_.size(); }
  std::vector<double> start() const override { return std::vector<double>(size(), 0.0); }
  std::vector<double> minimizer() const override {
    std::vector<double> x(size());
    for (std::size_t i = 0; i < size(); ++i) x[i] = centre(i);
    return x;
  }
  std::span<const double> lumped_mass() const override { return mass_; }
  Entries jacobian(std::span<const double> x) const override {
    Entries entries;
    for (std::size_t i = 0; i < size(); ++i) {
      const double e = x[i] - centre(i);
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i), std::sqrt(0.5 * mass_[i] * (1 + 3 * e * e)));
    }
    return entries;
  }
  // Three components for each node of a chain: h1 couples neighbours by a second difference, h1_band more tightly and
  // with a mass of its own. No chain for a number of unknowns that is no multiple of three.
  Eigen::SparseMatrix<double> metric_matrix(Metric metric) const override {
    if (size() % 3 != 0) return {};
    const int n = static_cast<int>(size() / 3);
    const double coupling = metric == Metric::h1 ? 0.1 : 1;
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, metric == Metric::h1 ? 1.0 : 1.0 + i % 2);
    for (int i = 0; i + 1 < n; ++i)
      for (const auto& [a, b, sign] : {std::tuple{i, i, 1}, {i + 1, i + 1, 1}, {i, i + 1, -1}, {i + 1, i, -1}})
        entries.emplace_back(a, b, sign * coupling);
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }
  std::vector<std::string> term_names() const override { return {"quadratic", "quartic"}; }
  std::vector<double> term_values() const override { return {quadratic_, quartic_}; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    quadratic_ = quartic_ = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double e = x[i] - centre(i);
      quadratic_ += mass_[i] / 2 * e * e;
      quartic_ += mass_[i] / 4 * e * e * e * e;
      if (!gradient.empty()) gradient[i] = mass_[i] * (e + e * e * e);
    }
    value = quadratic_ + quartic_;
    return std::isfinite(value);
  }

 private:
  static double centre(std::size_t i) { return 1 + 0.5 * std::sin(static_cast<double>(i)); }
  std::vector<double> mass_;
  double quadratic_ = 0, quartic_ = 0;
};

}  // namespace

void TestProblem::prepare_second_derivative(std::span<const double> x, std::span<const float>) {
  const Entries entries = jacobian(x);
  int n_rows = 0;
  for (const auto& e : entries) n_rows = std::max(n_rows, e.row() + 1);
  Eigen::SparseMatrix<double> j(n_rows, static_cast<int>(size()));
  j.setFromTriplets(entries.begin(), entries.end());
  hessian_ = 2 * Eigen::SparseMatrix<double>(j.transpose()) * j;
}

void TestProblem::apply_second_derivative(std::span<const double> x, std::span<double> y) const {
  using Vector = Eigen::VectorXd;
  const auto n = static_cast<Eigen::Index>(size());
  Eigen::Map<Vector>(y.data(), n) = hessian_ * Eigen::Map<const Vector>(x.data(), n);
}

void TestProblem::precondition(std::span<const double> r, std::span<double> z) const {
  const Eigen::VectorXd diagonal = hessian_.diagonal();
  for (std::size_t i = 0; i < r.size(); ++i) z[i] = r[i] / (diagonal[static_cast<Eigen::Index>(i)] + 1e-12);
}

std::string TestProblem::check(double value, const std::vector<double>& x, double value_tolerance) const {
  const auto known = minima();
  double nearest = known.front();
  for (const double m : known)
    if (std::abs(value - m) < std::abs(value - nearest)) nearest = m;
  if (!(std::abs(value - nearest) <= value_tolerance * std::max(1.0, std::abs(nearest))))
    return fmt::format("{}: value {:.10g}, minimum {:.10g}", name(), value, nearest);
  const auto solution = minimizer();
  for (std::size_t i = 0; i < solution.size(); ++i)
    if (!(std::abs(x[i] - solution[i]) <= coordinate_tolerance()))
      return fmt::format("{}: x[{}] = {:.8g}, minimiser {:.8g}", name(), i, x[i], solution[i]);
  return {};
}

std::vector<std::unique_ptr<TestProblem>> more_garbow_hillstrom() {
  std::vector<std::unique_ptr<TestProblem>> problems;
  problems.push_back(std::make_unique<Rosenbrock>(2));
  problems.push_back(std::make_unique<PowellSingular>(4));
  problems.push_back(std::make_unique<Wood>());
  problems.push_back(std::make_unique<Beale>());
  problems.push_back(std::make_unique<HelicalValley>());
  problems.push_back(std::make_unique<Trigonometric>(10));
  for (const std::size_t n : {100, 1000}) {
    problems.push_back(std::make_unique<Rosenbrock>(n));
    problems.push_back(std::make_unique<PowellSingular>(n));
  }
  return problems;
}

std::unique_ptr<TestProblem> extended_rosenbrock(std::size_t n) { return std::make_unique<Rosenbrock>(n); }
std::unique_ptr<TestProblem> log_barrier(std::size_t n, double mu) { return std::make_unique<LogBarrier>(n, mu); }
std::unique_ptr<TestProblem> weighted_bowl(std::size_t n) { return std::make_unique<WeightedBowl>(n); }

}  // namespace shellmatch::testing
