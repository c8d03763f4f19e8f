#pragma once
/// \file
/// A line of the self-test.

#include <string>

namespace shellmatch {

/// One comparison with what is known.
struct SelfCheck {
  std::string group, name;
  double figure = 0;                               ///< an error, or a count of what is wrong
  double bound = 0;                                ///< the largest that passes
  bool passed() const { return figure <= bound; }  ///< false for NaN
};

}  // namespace shellmatch
