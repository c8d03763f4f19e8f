#pragma once
/// \file
/// The groups of the self-test (matching/self_test/self_test.h). What each compares can be replaced, so that a test can
/// plant an error.

#include "energies/assembly/folds.h"
#include "geometry/surface/placement.h"
#include "matching/derivative_check/gradient_report.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// One comparison with what is known.
struct SelfCheck {
  std::string group, name;
  double figure = 0;                               ///< an error, or a count of what is wrong
  double bound = 0;                                ///< the largest that passes
  bool passed() const { return figure <= bound; }  ///< false for NaN
};

/// Distances and curvatures of built-in shapes against their formulas, and the density W on multiples of rotations.
std::vector<SelfCheck> check_closed_forms();

/// Orders of Taylor remainders, and gradients against dual numbers.
template <int Dim>
std::vector<SelfCheck> check_gradients();
/// The checks of one report.
std::vector<SelfCheck> checks_of(const GradientReport& report);

template <int Dim>
using BoundsOfDeterminants =
    std::function<std::vector<DeterminantBounds>(std::span<const Element<Dim>>, std::span<const Vec<Dim>>)>;

/// Random cells, some folded: a bound must lie below det Dphi wherever that is looked at, and be exact where phi is
/// affine.
template <int Dim>
std::vector<SelfCheck> check_fold_certificates(const BoundsOfDeterminants<Dim>& bounds = determinant_bounds<Dim>);

/// Matches an ellipse (ellipsoid) onto its own image under a similarity, which is then the true map.
/// \param truth where the vertices must end
template <int Dim>
std::vector<SelfCheck> check_match(const Similarity<Dim>& motion, const Similarity<Dim>& truth);
/// The motion that the self-test uses.
template <int Dim>
Similarity<Dim> self_test_motion();

/// All checks: closed forms, gradients, certificates of folds, matches of known result, in the plane and in space.
/// \param next called with the name of each group before it
std::vector<SelfCheck> run_self_test(const std::function<void(const std::string& group)>& next = {});

/// Names of the checks that did not pass, separated by commas.
std::string failed_checks(const std::vector<SelfCheck>& checks);

/// A table: group, check, figure, bound, and whether it passed.
std::string self_test_text(const std::vector<SelfCheck>& checks);

}  // namespace shellmatch
