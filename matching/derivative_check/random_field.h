#pragma once
/// \file
/// Random numbers and fields for derivative checks: a seed gives the same ones on every machine.

#include "base/types.h"

#include <array>
#include <cmath>
#include <random>

namespace shellmatch {

/// Uniform in [-1, 1]. Not a distribution of the standard library, as their algorithms differ between implementations.
inline double random_unit(std::mt19937& random) {
  return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1;
}

/// A smooth field: each component is one wave of amplitude 1, with at most about one period over the domain.
template <int Dim>
class SmoothRandomField {
 public:
  explicit SmoothRandomField(std::mt19937& random) {
    for (int k = 0; k < Dim; ++k) {
      for (double& w : wave_[k]) w = 6 * random_unit(random);
      phase_[k] = 3 * random_unit(random);
    }
  }
  Vec<Dim> operator()(const Vec<Dim>& x) const {
    Vec<Dim> u;
    for (int k = 0; k < Dim; ++k) u[k] = std::sin(wave_[k].dot(x) + phase_[k]);
    return u;
  }

 private:
  std::array<Vec<Dim>, Dim> wave_;
  Vec<Dim> phase_;
};

}  // namespace shellmatch
