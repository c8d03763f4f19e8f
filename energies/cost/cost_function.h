#pragma once
/// \file
/// The energy on one element as a cost function of Ceres.

#include <ceres/cost_function.h>

#include <memory>

namespace shellmatch {

/// Of one parameter block, the positions of the element's corners, and one "residual": the value itself, not halved or
/// squared. Its Jacobian is the gradient; Evaluate() is false where there is no finite value.
using ElementCostFunction = std::unique_ptr<ceres::CostFunction>;

}  // namespace shellmatch
