#include "geometry/statistics/leave_one_out.h"

#include "geometry/statistics/products.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// An eigenvalue of S' and the square of the component of the shape along its eigenvector.
using Component = std::pair<double, double>;

// The equation between two neighbouring poles, as a function of tau = mu - origin, where the origin is a pole:
// differences to the poles nearby are exact.
class SecularEquation {
 public:
  SecularEquation(const Eigen::ArrayXd& poles, const Eigen::ArrayXd& squares, double rho)
      : poles_(poles), squares_(squares), one_over_rho_(1 / rho), reach_(rho * squares.sum()) {}

  // The k-th root from above: below pole k, and above pole k + 1 where there is one.
  Component solve(Eigen::Index k) {
    above_ = k + 1;
    const bool last = above_ == poles_.size();
    double low, high;
    if (last) {
      place_origin(k);
      low = -reach_ * (1 + 8 * epsilon);
      high = 0;
    } else {
      place_origin(k);
      const double half = shifted_[k + 1] / 2;
      if (evaluate(half) > 0) {  // the root is above the middle
        low = half;
        high = 0;
      } else {
        place_origin(k + 1);
        low = 0;
        high = shifted_[k] / 2;
      }
    }
    const double tau = root(low, high);
    return {origin_ + tau, 1 / (slope_above_ + slope_below_)};
  }

 private:
  void place_origin(Eigen::Index k) {
    origin_ = poles_[k];
    shifted_ = poles_ - origin_;
  }

  // 1 / rho - sum_j z_j^2 / (pole_j - mu), which falls; and the two parts of the sum with their slopes, of the poles
  // above and below.
  double evaluate(double tau) {
    quotients_ = squares_ / (shifted_ - tau);
    sum_above_ = quotients_.head(above_).sum();
    sum_below_ = quotients_.tail(quotients_.size() - above_).sum();
    quotients_ /= shifted_ - tau;
    slope_above_ = quotients_.head(above_).sum();
    slope_below_ = quotients_.tail(quotients_.size() - above_).sum();
    return one_over_rho_ - sum_above_ - sum_below_;
  }

  // Each part is replaced by r + s / (pole - tau) with the same value and slope, pole the nearest one (J. R. Bunch, C.
  // P. Nielsen and D. C. Sorensen, Numer. Math. 31, 1978); within a bracket, which is halved where a step would leave
  // it.
  double root(double low, double high) {
    const bool has_below = above_ < poles_.size();
    constexpr int max_steps = 200, max_rational_steps = 40;
    double tau = (low + high) / 2;
    for (int step = 0; step < max_steps; ++step) {
      const double value = evaluate(tau);
      const double noise =
          epsilon * (8 * (one_over_rho_ + sum_above_ - sum_below_) + std::abs(tau) * (slope_above_ + slope_below_));
      if (std::abs(value) <= noise) break;
      (value > 0 ? low : high) = tau;
      double next = std::numeric_limits<double>::quiet_NaN();
      if (step < max_rational_steps) next = tau + rational_step(tau, value, has_below);
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (next == tau || next <= low || next >= high) break;
      tau = next;
    }
    return tau;
  }

  double rational_step(double tau, double value, bool has_below) const {
    const double to_above = shifted_[above_ - 1] - tau, s_above = slope_above_ * to_above * to_above;
    double c = value + slope_above_ * to_above;
    if (!has_below) return to_above - s_above / c;  // c - s / (pole - tau) = 0
    const double to_below = shifted_[above_] - tau, s_below = slope_below_ * to_below * to_below;
    c += slope_below_ * to_below;
    // c (to_above - eta) (to_below - eta) - s_above (to_below - eta) - s_below (to_above - eta), which is negative at
    // eta = to_below and positive at to_above: the root between them is that at which it rises.
    const double h = c * (to_above + to_below) - s_above - s_below, product = to_above * to_below * value;
    const double discriminant = std::sqrt(std::abs(h * h - 4 * c * product));
    return h > 0 ? (h + discriminant) / (2 * c) : 2 * product / (h - discriminant);
  }

  const Eigen::ArrayXd &poles_, &squares_;
  double one_over_rho_, reach_, origin_ = 0;
  Eigen::Index above_ = 0;  // number of poles above the root
  Eigen::ArrayXd shifted_, quotients_;
  double sum_above_ = 0, sum_below_ = 0, slope_above_ = 0, slope_below_ = 0;
};

// Eigenvalues that S' has in common with S to rounding, moved to `components`: the shape has nothing of their mode, or
// two are so close that a mode of their plane has nothing of the shape. What is left are poles, descending, with the
// squares of z.
std::pair<Eigen::ArrayXd, Eigen::ArrayXd> deflate(const Eigen::VectorXd& values, const Eigen::VectorXd& scores,
                                                  double rho, std::vector<Component>& components) {
  const double tolerance = 8 * epsilon * values[0], length = scores.norm();
  std::vector<double> poles, z;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    if (rho * std::abs(scores[k]) * length <= tolerance) {
      components.emplace_back(values[k], rho * rho * scores[k] * scores[k]);
      continue;
    }
    if (!z.empty()) {
      const double both = std::hypot(z.back(), scores[k]);
      if ((poles.back() - values[k]) * std::abs(z.back() / both) * std::abs(scores[k] / both) <= tolerance) {
        components.emplace_back(poles.back(), 0);
        poles.back() = values[k];
        z.back() = both;
        continue;
      }
    }
    poles.push_back(values[k]);
    z.push_back(scores[k]);
  }
  const auto size = static_cast<Eigen::Index>(z.size());
  return {Eigen::Map<Eigen::ArrayXd>(poles.data(), size), Eigen::Map<Eigen::ArrayXd>(z.data(), size).square()};
}

}  // namespace

Eigen::VectorXd left_out_distances(const Eigen::VectorXd& values, const Eigen::VectorXd& scores, Eigen::Index n) {
  const Eigen::Index n_modes = values.size();
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(n_modes + 1);
  if (n_modes == 0) return squares;
  const double rho = static_cast<double>(n) / static_cast<double>(n - 1);
  std::vector<Component> components;
  const auto [poles, squared_scores] = deflate(values, scores, rho, components);
  SecularEquation equation(poles, squared_scores, rho);
  for (Eigen::Index k = 0; k < poles.size(); ++k) components.push_back(equation.solve(k));
  std::stable_sort(components.begin(), components.end(),
                   [](const Component& a, const Component& b) { return a.first > b.first; });
  // A direction in which the others do not vary is no mode of theirs: what the shape has of it, no number of modes
  // approximates.
  const double rounding = least_variance_share * values[0];
  const auto is_mode = [&](const Component& component) { return component.first > rounding; };
  for (const Component& component : components)
    if (!is_mode(component)) squares[n_modes] += component.second;
  // What M modes leave are the components along the others. Nothing is subtracted, so that small distances keep their
  // digits.
  for (Eigen::Index k = n_modes; k-- > 0;) {
    const Component& component = components[static_cast<std::size_t>(k)];
    squares[k] = squares[k + 1] + (is_mode(component) ? component.second : 0);
  }
  return squares;
}

}  // namespace shellmatch
