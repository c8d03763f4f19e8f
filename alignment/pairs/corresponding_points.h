#pragma once
/// \file
/// Two points that correspond.

#include "base/types.h"

namespace shellmatch {

template <int Dim>
struct CorrespondingPointsIn {
  Vec<Dim> on_reference, on_template;  ///< in the coordinates of the input
  double weight = 1;                   ///< confidence, greater than 0, at most 1
};

using CorrespondingPoints = CorrespondingPointsIn<3>;

}  // namespace shellmatch
