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

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_vertices", self.max_vertices,
          {.unit = "vertices",
           .min = 600,
           .max = 20000,
           .meaning = "surfaces with more vertices are simplified to about this number first"});
    visit("mollification", self.mollification,
          {.unit = "mean length of the edges",
           .min = 0,
           .max = 0.1,
           .meaning = "by how much the triangle inequality holds in every triangle of the Laplacian, at least"});
    visit("functions", self.functions,
          {.unit = "eigenfunctions",
           .min = 40,
           .max = 200,
           .meaning = "eigenfunctions of the Laplacian on each surface in the last step"});
    visit("start_functions", self.start_functions,
          {.unit = "eigenfunctions",
           .min = 1,
           .max = 7,
           .meaning = "all signs of the first eigenfunctions are tried, as many as this"});
    visit("swap_ratio", self.swap_ratio,
          {.min = 1,
           .max = 3,
           .meaning = "neighbouring eigenfunctions are also tried in the other order where the ratio of their "
                      "eigenvalues is smaller"});
    visit("refined", self.refined,
          {.unit = "maps",
           .min = 1,
           .max = 20,
           .meaning = "maps that are refined to all eigenfunctions and returned: so many by their score, where they "
                      "leave doubt as many of the others by "
                      "what orders maps in the end, and the one that begins with the surfaces as they lie"});
    visit("pairs", self.pairs,
          {.unit = "pairs",
           .min = 10,
           .max = 5000,
           .meaning = "farthest point samples of the reference from which pairs are made"});
    visit("cycle_tolerance", self.cycle_tolerance,
          {.unit = "square root of the area",
           .min = 0,
           .max = 1,
           .min_excluded = true,
           .meaning = "a pair is kept if the way there and back ends nearer from its beginning"});
    visit("max_stretch", self.max_stretch,
          {.min = 1, .max = 100, .meaning = "a pair is kept if the map changes lengths around it by no larger factor"});
    visit("identity_preference", self.identity_preference,
          {.min = 1,
           .max = 100,
           .meaning = "outlines, and poses searched by distance: the map that begins with the shapes as they lie is "
                      "chosen unless its "
                      "score is larger than the best by this factor"});
    visit("mirror", self.mirror, {.meaning = "also try the mirrored reference"});
  }
};

}  // namespace shellmatch
