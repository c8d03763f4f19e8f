#pragma once
/// \file
/// Options of the derivative checks within a run.

#include "base/options.h"

namespace shellmatch {

struct CheckGradientOptions {
  int every = 0;
  int directions = 1;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("every", self.every,
          {.unit = "iterations",
           .min = 0,
           .meaning = "check every term's gradient at the start of each minimisation and at every n-th iteration, and "
                      "say in the summary what came of it; 0 checks nothing and costs nothing"});
  }
};

}  // namespace shellmatch
