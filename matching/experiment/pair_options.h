#pragma once
/// \file
/// What can be chosen of landmarks and of coverage. Each option names its unit.

#include "base/options.h"
#include "energies/pairs/point_pairs.h"
#include "matching/experiment/level_overrides.h"

#include <string>

namespace shellmatch {

/// Landmarks whose name one of two files lacks.
enum class UnpairedLandmarks { are_refused, are_left_out };
template <>
struct EnumNames<UnpairedLandmarks> {
  static constexpr std::pair<UnpairedLandmarks, std::string_view> names[] = {
      {UnpairedLandmarks::are_refused, "refuse"}, {UnpairedLandmarks::are_left_out, "leave-out"}};
};

/// Points that the user knows to correspond.
struct LandmarkOptions {
  std::string file, template_file;
  double weight = 1;
  RobustLoss loss = RobustLoss::cauchy;
  double scale = 0.01;
  double max_distance = 0.05;
  UnpairedLandmarks unpaired = UnpairedLandmarks::are_refused;
  static void describe(auto& self, auto& visit) {
    visit("file", self.file,
          {.meaning = "CSV file of points of both shapes, or CSV, .fcsv, .mrk.json or .tps of those of the reference "
                      "alone; relative to the YAML file (docs/landmarks.md)"});
    visit("template_file", self.template_file,
          {.meaning = "CSV, .fcsv or .mrk.json file of the points of the template, which have their names from `file`; "
                      "empty: `file` holds both"});
    visit("weight", self.weight,
          {.min = 0,
           .min_excluded = true,
           .meaning = "factor on all landmarks together, which weigh the reference's area (length) over nu at "
                      "min_level, on all levels"});
    visit("loss", self.loss,
          {.meaning = "trivial: squared distances; huber, cauchy: distances beyond 0.01 diagonals of the template "
                      "count less, so that wrong landmarks do little harm"});
    visit("max_distance", self.max_distance,
          {.unit = "diagonal of the template",
           .min = 0,
           .meaning = "a landmark that lies farther from its own shape is refused"});
    visit("unpaired", self.unpaired, {.meaning = "a name that only one of two files has: refuse or leave-out"});
  }
};

/// Coverage: pairs of closest points of both shapes make the match two-sided.
struct CoverageOptions {
  int levels = 2;
  double weight = 2;
  double loss_scale = 0.1;
  double point_distance = 0.3;
  double tolerance = 2e-4;
  double coarse_tolerance = 0.5;
  int samples = 10000;
  int rounds = 1;
  static void describe(auto& self, auto& visit) {
    visit("levels", self.levels,
          {.unit = "levels",
           .min = 0,
           .max = finest_level,
           .meaning = "number of finest levels on which the match is two-sided; 0: one-sided, as in the paper. Never "
                      "on cascade.min_level"});
    visit("weight", self.weight,
          {.min = 0,
           .min_excluded = true,
           .meaning = "factor on the coverage term, which weighs the area (length) of both shapes over nu"});
    visit("tolerance", self.tolerance,
          {.unit = "diagonal of the template", .min = 0, .meaning = "closer pairs do not pull"});
    visit("coarse_tolerance", self.coarse_tolerance,
          {.unit = "sides of the finest cells",
           .min = 0,
           .meaning = "on levels before the last closer pairs do not pull, either, as coverage is there for parts that "
                      "are not reached"});
    visit("samples", self.samples,
          {.unit = "points",
           .min = 10,
           .max = 1000000,
           .meaning = "at most so many points of each shape are paired: vertices, and points within large facets"});
  }
};

}  // namespace shellmatch
