// Landmarks from the user's coordinates to the result: a limb gets where they say, with every kind of solver.

#include "base/error.h"
#include "matching/alignment/prepare_pair.h"
#include "matching/checkpoint/checkpoints.h"
#include "matching/derivative_check/gradient_report.h"
#include "matching/input/shape_pair.h"
#include "matching/match_shapes.h"
#include "matching/run_gradient_check.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/matching/pairs/limb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {
namespace {

using namespace testing;

constexpr double from = 0.3, to = 1.4;  // directions of the limb

/// Landmarks every 40 degrees from the limb's tip on.
std::vector<Landmark<2>> landmarks(int n = 9) {
  std::vector<Landmark<2>> all;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    all.push_back({"at " + std::to_string(i), limb_point(from + angle, from), limb_point(to + angle, to)});
  }
  return all;
}

ExperimentOptions options_to(int max_level) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = max_level;
  o.align.mode = AlignMode::none;  // which would find the limb by itself
  o.coverage.levels = 0;           // landmarks alone
  return o;
}

/// Mean over the outline of the distance from where the turn by to - from would carry it.
double mean_error(const MatchResult<2>& result) {
  double sum = 0;
  constexpr int n = 200;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    sum += (result.map.apply(limb_point(from + angle, from)) - limb_point(to + angle, to)).norm();
  }
  return sum / n;
}

double tip_error(const MatchResult<2>& result) {
  return (result.map.apply(limb_point(from, from)) - limb_point(to, to)).norm();
}

TEST(Landmarks, PullALimbToItsPlace) {
  Observer quiet;
  const auto alone = match_shapes(with_limb(from), with_limb(to), options_to(6), quiet);
  const auto pulled = match_shapes(with_limb(from), with_limb(to), options_to(6), quiet, landmarks());
  EXPECT_GT(tip_error(alone), 1);  // the limb is 1.2 long
  EXPECT_LT(tip_error(pulled), 0.05);
  EXPECT_EQ(pulled.summary.levels.back().folds.n_uncertified_cells, 0);
  EXPECT_LT(pulled.summary.distance->template_to_deformed.mean, 2e-5);
  // They are a term like others.
  ASSERT_EQ(pulled.history.term_names.back(), "landmarks");
  EXPECT_EQ(pulled.history.term_names.size(), alone.history.term_names.size() + 1);
  EXPECT_GT(pulled.history.rows.front().record.terms.back(), 0);
  for (const auto& row : pulled.history.rows) {
    double sum = 0;
    for (const double term : row.record.terms) sum += term;
    EXPECT_NEAR(sum, row.record.value, 1e-12 * sum);
  }
  for (const auto& list :
       {pulled.summary.levels.back().energy_minimised, pulled.summary.levels.back().energy_reported}) {
    const auto at =
        std::find_if(list.begin(), list.end(), [](const auto& entry) { return entry.first == "landmarks"; });
    ASSERT_NE(at, list.end());
    EXPECT_GT(at->second, 0);
  }
}

TEST(Landmarks, AGrossOutlierDoesLittleHarm) {
  Observer quiet;
  auto wrong = landmarks(18);
  const double clean = mean_error(match_shapes(with_limb(from), with_limb(to), options_to(5), quiet, wrong));
  wrong[9].on_template = limb_point(to + 0.9, to);
  ExperimentOptions o = options_to(5);
  const double robust = mean_error(match_shapes(with_limb(from), with_limb(to), o, quiet, wrong));
  o.landmarks.loss = RobustLoss::trivial;
  const double plain = mean_error(match_shapes(with_limb(from), with_limb(to), o, quiet, wrong));
  EXPECT_LT(robust, 0.2 * plain);
  EXPECT_LT(robust, 0.01);  // of the disk's radius
  EXPECT_LT(clean, robust);
}

TEST(Landmarks, EverySolverMinimisesThem) {
  Observer quiet;
  std::vector<double> errors;
  for (const std::string name : {"newton", "lbfgs", "fletcher_reeves"})
    for (const Metric metric : {Metric::l2, Metric::weighted_h1}) {
      if (name == "newton" && metric != Metric::l2) continue;
      ExperimentOptions o = options_to(4);
      o.solver.name = name;
      o.solver.metric = metric;
      if (name != "newton") o.solver.stop = {};
      errors.push_back(tip_error(match_shapes(with_limb(from), with_limb(to), o, quiet, landmarks())));
      EXPECT_LT(errors.back(), 0.15) << name << ", " << enum_name(metric);
    }
}

TEST(Landmarks, AreWeighedByTheReferencesLength) {
  const Shape<2> a = with_limb(from), b = with_limb(to);
  ShapePair<2> shapes{a, b};
  const ExperimentOptions o = options_to(5);
  const Similarity<2> placement = shapes.place(o);
  const SignedDistance<2> d1(shapes.reference.surface), d2(shapes.template_shape.surface);
  auto marks = landmarks(4);
  marks[1].weight = 3;
  LandmarkOptions options;
  options.weight = 2;
  options.scale = 0.1;
  const PairSet<2> set = landmark_pairs("landmarks", marks, options, {}, placement, d1, d2);
  double length = 0;
  for (std::size_t f = 0; f < d1.surface().facets.size(); ++f)
    length += facet_measure(d1.surface(), static_cast<Index>(f));
  ASSERT_EQ(set.pairs.pairs.size(), 4u);
  EXPECT_NEAR(set.pairs.pairs[0].weight, length / 4, 1e-14);
  EXPECT_NEAR(set.pairs.pairs[1].weight, 3 * length / 4, 1e-14);
  EXPECT_EQ(set.factor, 2);
  EXPECT_NEAR(set.pairs.scale, 0.1 * bounding_box(d2.surface().vertices).diagonal(), 1e-14);
  EXPECT_EQ(set.pairs.pairs[2].p, placement(marks[2].on_reference));
  EXPECT_EQ(set.pairs.pairs[2].y, placement(marks[2].on_template));

  const auto refused = [&](Vec<2> x, bool on_template) {
    auto moved = marks;
    (on_template ? moved[2].on_template : moved[2].on_reference) = x;
    return message_of<InputError>([&] { landmark_pairs("landmarks", moved, options, {}, placement, d1, d2); });
  };
  EXPECT_NE(refused({50, 0}, true).find("landmark 'at 2': its point of the template lies outside of the domain"),
            std::string::npos);
  EXPECT_NE(refused({0, 0}, false).find("its point of the reference lies"), std::string::npos);
  EXPECT_NE(refused({0, 0}, false).find("landmarks.max_distance"), std::string::npos);
  EXPECT_EQ(refused(limb_point(0.1, from), false), "");
  marks[2].template_origin = "points.csv, line 4";
  EXPECT_EQ(refused({50, 0}, true).find("points.csv, line 4: landmark 'at 2'"), 0u);
}

TEST(Landmarks, AreCheckedBeforeAnythingIsSearched) {
  ShapePair<2> shapes{with_limb(from), with_limb(to)};
  auto marks = landmarks(4);
  marks[2].on_template = {0, 0};
  marks[2].template_origin = "b.csv, line 4";
  for (const MatchDirection direction : {MatchDirection::forward, MatchDirection::backward}) {
    ExperimentOptions o = options_to(5);
    o.align.mode = AlignMode::automatic;
    o.align.direction = direction;
    struct : Observer {
      void stage(const std::string& name) override { EXPECT_NE(name, "alignment"); }
    } observer;
    const std::string told = message_of<InputError>([&] { prepare_pair(shapes, marks, o, observer); });
    EXPECT_EQ(told.find("b.csv, line 4: landmark 'at 2': its point of the template lies"), 0u) << told;
  }
  // The shapes keep their names where the template is deformed.
  const auto swapped = exchanged(marks);
  EXPECT_EQ(swapped[2].reference_name, "template");
  marks[2].on_template = {std::nan(""), 0};
  Observer quiet;
  EXPECT_NE(message_of<InputError>([&] { prepare_pair(shapes, marks, options_to(5), quiet); }).find("is not finite"),
            std::string::npos);
}

TEST(Landmarks, CheckGradientExaminesThem) {
  const TemporaryFolder folder;
  put(folder / "marks.csv", "vertex1,vertex2\n0,0\n20,21\n40,43\n");
  ExperimentOptions o = options_to(5);
  o.input.reference = "generate:ellipse/round";
  o.input.template_file = "generate:ellipse/long";
  o.landmarks.file = folder / "marks.csv";
  o.coverage.levels = 1;
  Observer quiet;
  GradientCheckRequest request;
  request.settings.n_directions = 1;
  const GradientReport report = run_gradient_check(o, request, quiet);
  EXPECT_TRUE(report.passed()) << gradient_report_text(report);
  int n_passed = 0;
  for (const TermCheck& term : report.terms)
    if (term.name == "landmarks" || term.name == "coverage") {
      n_passed += term.state == TermCheck::State::passed;
      EXPECT_GT(term.value, 0) << term.name;
      EXPECT_TRUE(term.hessian) << term.name;
    }
  EXPECT_EQ(n_passed, 2);
}

TEST(Landmarks, ARunIsNotResumedWithOthers) {
  const Shape<2> shape = with_limb(from);
  const auto identity = [&](const std::vector<Landmark<2>>& marks) {
    return run_identity<2>(options_to(5), shape.original, shape.original, marks).landmarks;
  };
  auto moved = landmarks();
  moved[3].on_template[1] += 1e-9;
  EXPECT_EQ(identity({}), "");
  EXPECT_EQ(identity(landmarks()), identity(landmarks()));
  EXPECT_NE(identity(landmarks()), identity(moved));
}

}  // namespace
}  // namespace shellmatch
