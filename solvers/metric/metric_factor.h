#pragma once
/// \file
/// A metric given by a factor of its matrix.

#include <cstddef>
#include <span>

namespace shellmatch {

/// A metric M = F^T F on n unknowns, given by its factor F. In the variables y = F x the Euclidean inner
/// product is that of M, and the Euclidean gradient F^-T g is F times the gradient M^-1 g in that metric.
class MetricFactor {
 public:
  virtual ~MetricFactor() = default;
  virtual std::size_t size() const = 0;
  /// y = F x
  virtual void apply(std::span<const double> x, std::span<double> y) const = 0;
  /// x = F^-1 y
  virtual void solve(std::span<const double> y, std::span<double> x) const = 0;
  /// z = F^-T g; z may be g itself.
  virtual void solve_transposed(std::span<const double> g, std::span<double> z) const = 0;
};

}  // namespace shellmatch
