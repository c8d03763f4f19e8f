#pragma once
/// \file
/// Pairs of points that a map is to carry onto each other, as data of an energy, with losses named as in Ceres.

#include "base/options.h"
#include "base/types.h"

#include <cmath>
#include <string>
#include <vector>

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

/// Asks for phi(p) = y, or, with a normal, for phi(p) in the plane through y across it. Positions in the unit domain.
template <int Dim>
struct PointPair {
  Vec<Dim> p, y;
  double weight = 1;                   ///< > 0
  Vec<Dim> normal = Vec<Dim>::Zero();  ///< of length 1; 0: all directions count
};

/// The energy sum of weight * rho(max(0, |B (phi(p) - y)| - tolerance)^2) with B = normal^T where there is one, else I.
template <int Dim>
struct PointPairs {
  std::vector<PointPair<Dim>> pairs;
  RobustLoss loss = RobustLoss::trivial;
  double scale = 1;      ///< of the loss, sides of the domain; > 0
  double tolerance = 0;  ///< distances up to it cost nothing; sides of the domain, >= 0
};

/// Pairs that make one term of the energy of a cascade, kept from its first level to its last.
template <int Dim>
struct PairSet {
  std::string name;       ///< of the term, in history.csv and summary.json
  PointPairs<Dim> pairs;  ///< the weights of which add up to the area (length) over which they are spread
  double factor = 1;      ///< on the term; its weight in the energy is factor / nu of the first level, on all levels
};

}  // namespace shellmatch
