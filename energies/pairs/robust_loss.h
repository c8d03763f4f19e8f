#pragma once
/// \file
/// Robust loss functions of a squared residual, with the names and conventions of Ceres' loss_function.h.

#include "base/options.h"

#include <cmath>

namespace shellmatch {

enum class RobustLoss { trivial, huber, cauchy };
template <>
struct EnumNames<RobustLoss> {
  static constexpr std::pair<RobustLoss, std::string_view> names[] = {
      {RobustLoss::trivial, "trivial"}, {RobustLoss::huber, "huber"}, {RobustLoss::cauchy, "cauchy"}};
};

/// rho(s) for a squared residual s >= 0, of the same unit: about s where sqrt(s) is much less than `scale`, and of
/// slower growth beyond (trivial: s everywhere). Ceres: TrivialLoss, HuberLoss(scale), CauchyLoss(scale).
template <class T>
T robust_loss(RobustLoss loss, double scale, const T& s) {
  using std::log;
  using std::sqrt;
  const double square = scale * scale;
  switch (loss) {
    case RobustLoss::huber: return s > square ? T(2.0 * scale * sqrt(s) - square) : s;
    case RobustLoss::cauchy: return square * log(1.0 + s / square);
    case RobustLoss::trivial: break;
  }
  return s;
}

/// rho'(s), in (0, 1]. Newton's model weighs a residual with it and drops rho'': that is positive, where rho'' < 0
/// would not be.
inline double robust_weight(RobustLoss loss, double scale, double s) {
  const double square = scale * scale;
  switch (loss) {
    case RobustLoss::huber: return s > square ? scale / std::sqrt(s) : 1;
    case RobustLoss::cauchy: return 1 / (1 + s / square);
    case RobustLoss::trivial: break;
  }
  return 1;
}

}  // namespace shellmatch
