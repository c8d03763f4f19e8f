#pragma once
/// \file
/// Options of automatic point pairs between two surfaces.

#include "base/options.h"

namespace shellmatch {

struct AlignmentOptions {
  int max_vertices = 5000;
  double mollification = 2e-3;
  int functions = 100;
  int start_functions = 5;
  double swap_ratio = 1.35;
  int refined = 4;
  int pairs = 300;
  double cycle_tolerance = 0.03;
  double max_stretch = 3;
  double identity_preference = 1.1;
  bool mirror = false;

  static void describe(auto& self, auto& visit) {
    visit("pairs", self.pairs,
          {.unit = "pairs",
           .min = 10,
           .max = 5000,
           .meaning = "farthest point samples of the reference from which pairs are made"});
    visit("mirror", self.mirror, {.meaning = "also try the mirrored reference"});
  }
};

}  // namespace shellmatch
