#pragma once
/// \file
/// Two points that correspond.

#include "base/types.h"

namespace shellmatch {

struct CorrespondingPoints {
  Vec<3> on_reference, on_template;  ///< in the coordinates of the input
  double weight = 1;                 ///< confidence, greater than 0, at most 1
};

}  // namespace shellmatch
