#pragma once
/// \file

#include "base/options.h"

#include <string_view>
#include <utility>

namespace shellmatch {

/// At the domain's boundary: natural, or phi = id.
enum class BoundaryCondition { neumann, dirichlet };
template <>
struct EnumNames<BoundaryCondition> {
  static constexpr std::pair<BoundaryCondition, std::string_view> names[] = {
      {BoundaryCondition::neumann, "neumann"}, {BoundaryCondition::dirichlet, "dirichlet"}};
};

}  // namespace shellmatch
