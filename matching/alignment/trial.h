#pragma once
/// \file
/// A trial of a start: how much energy the coarsest levels of a cascade need from there, and how well they cover the template.

#include "matching/alignment/alignment.h"
#include "matching/experiment/options.h"
#include "matching/experiment/shape_pair.h"
#include "matching/progress/observer.h"

#include <limits>

namespace shellmatch {

/// At the end of the coarsest two levels. All infinite where the energy cannot be computed from this start.
struct Trial {
  double energy = std::numeric_limits<double>::infinity();       ///< without the pairs' term
  double with_pairs = std::numeric_limits<double>::infinity();
  double uncovered = std::numeric_limits<double>::infinity();    ///< mean distance from the template to phi(M1), sides of the domain
};

/// \param start pose and pairs of the reference \param landmarks pull, too
template <int Dim>
Trial try_start(const ShapePair<Dim>& shapes, const Alignment<Dim>& start, const std::vector<Landmark<Dim>>& landmarks,
                const ExperimentOptions& options, Observer& observer);

}  // namespace shellmatch
