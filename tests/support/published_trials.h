#pragma once
/// \file
/// Every method on every published problem.

#include "solvers/solver_options.h"
#include "tests/support/test_problems.h"

#include <string>

namespace shellmatch::testing {

/// What came of one method on one problem.
struct Trial {
  MinimizerSummary summary;
  std::string wrong;  ///< empty where the published minimum was found
};

/// Runs the method from the published start until the gradient has fallen to 1e-10 of its first norm, with at most
/// 20,000 iterations. Asked for are 8 digits of the value, 6 of the methods without memory, per four unknowns.
Trial try_method(const std::string& method, TestProblem& problem);

/// Why this method cannot be asked for that problem; empty where it can.
std::string expected_failure(const std::string& method, const std::string& problem);

}  // namespace shellmatch::testing
