#pragma once
/// \file
/// A test of the program as it is installed, on this machine: what it computes, against what is known. Seconds, no
/// files.

#include "matching/self_test/known_cases.h"

#include <functional>
#include <string>
#include <vector>

namespace shellmatch {

/// All checks: closed forms, gradients, certificates of folds, matches of known result, in the plane and in space.
/// \param next called with the name of each group before it
std::vector<SelfCheck> run_self_test(const std::function<void(const std::string& group)>& next = {});

/// Names of the checks that did not pass, separated by commas.
std::string failed_checks(const std::vector<SelfCheck>& checks);

/// A table: group, check, figure, bound, and whether it passed.
std::string self_test_text(const std::vector<SelfCheck>& checks);

}  // namespace shellmatch
