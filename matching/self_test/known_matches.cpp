#include "geometry/repair/make_shape.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/yaml_options.h"
#include "matching/match_shapes.h"
#include "matching/self_test/known_cases.h"

#include <algorithm>

namespace shellmatch {

template <>
Similarity<2> self_test_motion<2>() {
  return {.scale = 1.1, .offset = {0.05, 0.1}};
}

template <>
Similarity<3> self_test_motion<3>() {
  return {.scale = 1.1, .offset = {0.05, 0.1, 0}};
}

template <int Dim>
std::vector<SelfCheck> check_match(const Similarity<Dim>& motion, const Similarity<Dim>& truth) {
  const bool plane = Dim == 2;
  const auto reference =
      std::get<OriginalShape<Dim>>(generated_original(plane ? "generate:ellipse" : "generate:ellipsoid"));
  OriginalShape<Dim> moved = reference;
  for (Vec<Dim>& x : moved.vertices) x = motion(x);
  const ExperimentOptions options = make_experiment({{"cascade.min_level", "3", "self-test"},
                                                     {"cascade.max_level", plane ? "6" : "4", "self-test"},
                                                     {"align.mode", "none", "self-test"}});
  Observer nobody;
  const MatchResult<Dim> result =
      match_shapes(make_shape(reference, "the reference"), make_shape(moved, "its image"), options, nobody);
  const double diagonal = bounding_box(reference.vertices).diagonal();
  double worst = 0;
  for (std::size_t i = 0; i < reference.vertices.size(); ++i)
    worst = std::max(worst, (result.deformed.vertices[i] - truth(reference.vertices[i])).norm() / diagonal);
  const TwoSidedDistance distance = result.summary.distance.value();
  const FoldReport& folds = result.summary.levels.back().folds;
  return {{"", "distance from the true positions, largest", worst, plane ? 0.01 : 0.03},
          {"", "distance to the template, mean", distance.deformed_to_template.mean, plane ? 1e-4 : 5e-4},
          {"", "distance from the template, mean", distance.template_to_deformed.mean, plane ? 1e-4 : 5e-4},
          {"", "cells that may fold", static_cast<double>(folds.n_uncertified_cells), 0}};
}

template std::vector<SelfCheck> check_match<2>(const Similarity<2>&, const Similarity<2>&);
template std::vector<SelfCheck> check_match<3>(const Similarity<3>&, const Similarity<3>&);

}  // namespace shellmatch
