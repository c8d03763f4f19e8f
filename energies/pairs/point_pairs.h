#pragma once
/// \file
/// Pairs of points that a map is to carry onto each other, as data of an energy.

#include "base/types.h"
#include "energies/pairs/robust_loss.h"

#include <string>
#include <vector>

namespace shellmatch {

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
