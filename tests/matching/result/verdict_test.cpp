#include "matching/result/verdict.h"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

namespace shellmatch {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Of a good matching of surfaces.
MatchSummary good_summary() {
  MatchSummary s;
  s.dimension = 3;
  s.reference.n_facets = 1000;
  s.reference.n_components = s.template_shape.n_components = 1;
  s.reference.genus = s.template_shape.genus = 0;
  s.template_diagonal = 200;
  s.unit = "mm";
  s.distance = TwoSidedDistance{{1e-4, 2e-4, 3e-4}, {4e-4, 5e-4, 6e-4}, 0};
  s.area_distortion = DistortionSummary{1, 0.2, 5, 0.6, 1.7};
  s.angle_distortion = DistortionSummary{10, 0, 120, 1, 15};
  s.flipped_share = 0.003;
  s.levels.resize(2);
  return s;
}

const VerdictPlaces places{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};

// A figure of the summary, and the limits beyond which it means `look-here` and `not-matched`.
struct Case {
  const char* name;
  void (*set)(MatchSummary&, double);
  double look, fail;
  const char* what;
  std::vector<double> place;
};

const std::vector<Case> cases = {
    {"mean there", [](MatchSummary& s, double x) { s.distance->deformed_to_template.mean = x; }, 0.005, 0.03,
     "deformed reference lies", places.deformed},
    {"mean back", [](MatchSummary& s, double x) { s.distance->template_to_deformed.mean = x; }, 0.005, 0.03,
     "template lies", places.template_shape},
    {"largest there", [](MatchSummary& s, double x) { s.distance->deformed_to_template.max = x; }, 0.03, 0.2,
     "part of the deformed", places.deformed},
    {"largest back", [](MatchSummary& s, double x) { s.distance->template_to_deformed.max = x; }, 0.03, 0.2,
     "part of the template", places.template_shape},
    {"unreached", [](MatchSummary& s, double x) { s.distance->uncovered = x; }, 0.015, 0.05,
     "% of the template is not reached", places.template_shape},
    {"flipped", [](MatchSummary& s, double x) { s.flipped_share = x; }, 0.02, 0.08, "% of the surface faces away", {}},
    {"angles", [](MatchSummary& s, double x) { s.angle_distortion->p95 = x; }, 20, 48, "directions on a twentieth",
     places.distorted},
    {"areas grow", [](MatchSummary& s, double x) { s.area_distortion->p95 = x; }, 4, 12, "areas change by a factor",
     places.distorted},
    {"areas shrink", [](MatchSummary& s, double x) { s.area_distortion->p5 = 1 / x; }, 4, 12,
     "areas change by a factor", places.distorted},
};

// Of limbs in another pose, which touch.
MatchSummary vouched_summary() {
  MatchSummary s = good_summary();
  s.angle_distortion->p95 = 51;
  s.flipped_share = 0.05;
  s.distance->uncovered = 0.05;
  s.distance->deformed_to_template.max = 0.11;
  s.alignment.emplace();
  s.alignment->score = 0.7;
  s.alignment->margin = 1.2;
  s.alignment->n_pairs = 900;
  s.alignment->pair_share = 0.9;
  s.spin_difference = 0.35;
  return s;
}

TEST(Verdict, LimbsMayTurnAndTouchWhereTheSearchIsSureAndWhatCorrespondsLooksAlike) {
  EXPECT_EQ(judge(vouched_summary(), places).outcome, "matched");
  for (void (*const spoil)(MatchSummary&) :
       {+[](MatchSummary& s) { s.alignment->score = 0.85; }, +[](MatchSummary& s) { s.alignment->margin = 1; },
        +[](MatchSummary& s) { s.alignment->as_it_lies = true; },
        +[](MatchSummary& s) { s.alignment->doubtful = true; }, +[](MatchSummary& s) { s.alignment->n_pairs = 0; },
        +[](MatchSummary& s) { s.alignment.reset(); }, +[](MatchSummary& s) { s.spin_difference = 0.5; },
        +[](MatchSummary& s) { s.spin_difference = nan; }, +[](MatchSummary& s) { s.spin_difference.reset(); }}) {
    MatchSummary unsure = vouched_summary();
    spoil(unsure);
    EXPECT_EQ(judge(unsure, places).outcome, "not-matched");
  }
  for (const auto& [set, look, fail] :
       {std::tuple<void (*)(MatchSummary&, double), double, double>{cases[0].set, 0.008, 0.03},
        {cases[2].set, 0.12, 0.25},
        {cases[4].set, 0.06, 0.2},
        {cases[5].set, 0.06, 0.15},
        {cases[6].set, 52, 60},
        {cases[7].set, 5, 12}})
    for (const auto& [figure, outcome, below] :
         {std::tuple(look, "look-here", "matched"), {fail, "not-matched", "look-here"}}) {
      MatchSummary s = vouched_summary();
      set(s, 1.01 * figure);
      EXPECT_EQ(judge(s, places).outcome, outcome) << figure;
      set(s, 0.99 * figure);
      EXPECT_EQ(judge(s, places).outcome, below) << figure;
    }
  // Halfway to a clear margin half of the width.
  MatchSummary half = vouched_summary();
  half.alignment->margin = 1.075;
  half.distance->uncovered = 0.0374;
  half.flipped_share = 0.0399;
  half.distance->deformed_to_template.max = 0.0749;
  half.angle_distortion->p95 = 35.9;
  EXPECT_EQ(judge(half, places).outcome, "matched");
  half.angle_distortion->p95 = 36.1;
  EXPECT_EQ(judge(half, places).outcome, "look-here");
  half.angle_distortion->p95 = 35.9;
  half.alignment->margin = 2;
  half.alignment->pair_share = 0.801;
  EXPECT_EQ(judge(half, places).outcome, "matched");
  half.alignment->pair_share = 0.78;
  EXPECT_EQ(judge(half, places).outcome, "look-here");
  half.alignment->pair_share = 0.9;
  half.spin_difference = 0.449;
  EXPECT_EQ(judge(half, places).outcome, "matched");
  half.spin_difference = 0.46;
  EXPECT_EQ(judge(half, places).outcome, "look-here");
  MatchSummary mirrored = vouched_summary();
  mirrored.alignment->fits_mirrored = true;
  EXPECT_EQ(judge(mirrored, places).outcome, "look-here");
}

TEST(Verdict, WhatAPartLacksIsNoReasonWhereTheMapIsVouchedFor) {
  MatchSummary s = vouched_summary();
  s.distance->uncovered = 0.6;
  s.distance->template_to_deformed.max = 0.5;
  s.distance->template_to_deformed.mean = 0.05;
  EXPECT_EQ(judge(s, places).outcome, "not-matched");
  s.reference.invented = 0.1;
  EXPECT_EQ(judge(s, places).outcome, "matched");
  MatchSummary unclear = s;
  unclear.angle_distortion->p95 = 40;
  EXPECT_EQ(judge(unclear, places).outcome, "matched");
  unclear.alignment->margin = 1.1;
  EXPECT_EQ(judge(unclear, places).outcome, "look-here") << "of a part another map may differ in one limb only";
  s.spin_difference = 0.5;
  s.angle_distortion->p95 = 15;
  s.flipped_share = 0.003;
  EXPECT_EQ(judge(s, places).outcome, "look-here");
}

TEST(Verdict, LimbsThatTouchAreNoReasonWhereTheMapIsVouchedFor) {
  MatchSummary s = vouched_summary();
  s.reference.genus = 2;
  EXPECT_EQ(judge(s, places).outcome, "matched");
  s.alignment->margin = 1.14;
  EXPECT_EQ(judge(s, places).outcome, "look-here");
  s = vouched_summary();
  s.reference.n_components = 2;
  EXPECT_EQ(judge(s, places).outcome, "look-here");
}

TEST(Verdict, IsMatchedWithoutReasonsWhereAllIsWell) {
  const Verdict v = judge(good_summary(), places);
  EXPECT_EQ(v.outcome, "matched");
  EXPECT_TRUE(v.reasons.empty());
}

TEST(Verdict, EachFigureHasTwoLimitsAReasonAPlaceAndAdvice) {
  for (const Case& c : cases)
    for (const auto& [figure, outcome] : {std::pair(c.look, "look-here"), std::pair(c.fail, "not-matched")}) {
      SCOPED_TRACE(c.name);
      MatchSummary s = good_summary();
      c.set(s, 1.01 * figure);
      const Verdict v = judge(s, places);
      EXPECT_EQ(v.outcome, outcome);
      ASSERT_EQ(v.reasons.size(), 1u);
      EXPECT_NE(v.reasons[0].what.find(c.what), std::string::npos) << v.reasons[0].what;
      EXPECT_EQ(v.reasons[0].place, c.place);
      EXPECT_FALSE(v.reasons[0].advice.empty());
      // A little less is of no account.
      c.set(s, 0.99 * figure);
      EXPECT_EQ(judge(s, places).outcome, figure == c.look ? "matched" : "look-here");
    }
}

TEST(Verdict, LengthsInThePlaneMayChangeByTheRootOfWhatAreasMay) {
  MatchSummary s = good_summary();
  s.dimension = 2;
  s.angle_distortion.reset();
  for (const auto& [factor, outcome] :
       {std::pair(1.98, "matched"), {2.02, "look-here"}, {3.43, "look-here"}, {3.5, "not-matched"}}) {
    s.area_distortion->p95 = factor;
    EXPECT_EQ(judge(s, places).outcome, outcome) << factor;
  }
  EXPECT_NE(judge(s, places).reasons[0].what.find("lengths change by a factor of more than 3.5"), std::string::npos);
}

// A boy on a man.
TEST(Verdict, AnotherSizeOfTheWholeDistortsNothing) {
  MatchSummary s = good_summary();
  s.area_distortion = DistortionSummary{5, 1, 25, 3, 8.5};
  EXPECT_EQ(judge(s, places).outcome, "matched");
  s.area_distortion->p5 = 1.2;
  EXPECT_EQ(judge(s, places).outcome, "look-here");
}

TEST(Verdict, NoNumberIsNoMatch) {
  MatchSummary s = good_summary();
  s.distance->deformed_to_template.mean = nan;
  EXPECT_EQ(judge(s, places).outcome, "not-matched");
}

TEST(Verdict, TheGravestReasonIsFirst) {
  MatchSummary s = good_summary();
  s.distance->deformed_to_template.mean = 0.01;
  s.angle_distortion->p95 = 70;
  const Verdict v = judge(s, places);
  ASSERT_EQ(v.reasons.size(), 2u);
  EXPECT_NE(v.reasons[0].what.find("directions"), std::string::npos);
}

TEST(Verdict, LooksAtKindsFoldsDoubtsAndStops) {
  using Change = void (*)(MatchSummary&);
  for (const auto& [change, what] :
       {std::pair<Change, const char*>([](MatchSummary& s) { s.template_shape.genus = 1; },
                                       "the reference has 1 component and genus 0, the template 1 and 1"),
        {[](MatchSummary& s) { s.reference.invented = 0.62; }, "62 % of the reference's surface was made up"},
        {[](MatchSummary& s) { s.reference.n_components = 2; }, "the reference has 2 components and genus 0"},
        {[](MatchSummary& s) { s.levels.back().folds.n_folded_cells = 7; }, "folded cells of the grid: 7"},
        {[](MatchSummary& s) { s.alignment.emplace().doubtful = true; }, "no pose that is clearly the best"},
        {[](MatchSummary& s) { s.interrupted = true; }, "stopped before its last level"}}) {
    MatchSummary s = good_summary();
    change(s);
    const Verdict v = judge(s, places);
    EXPECT_EQ(v.outcome, "look-here") << what;
    ASSERT_EQ(v.reasons.size(), 1u) << what;
    EXPECT_NE(v.reasons[0].what.find(what), std::string::npos) << v.reasons[0].what;
  }
}

TEST(Verdict, LandmarksThatEndElsewhereAreNamed) {
  MatchSummary s = good_summary();
  s.landmarks = {19, 0.004, 0.04, "tail", {1, 2, 3}};
  EXPECT_EQ(judge(s, places).outcome, "matched");
  s.landmarks->max = 0.06;
  const Verdict one = judge(s, places);
  EXPECT_EQ(one.outcome, "look-here");
  ASSERT_EQ(one.reasons.size(), 1u);
  EXPECT_NE(one.reasons[0].what.find("landmark tail, the farthest of 19, ends 12 mm"), std::string::npos)
      << one.reasons[0].what;
  EXPECT_EQ(one.reasons[0].place, s.landmarks->place);
  s.landmarks->mean = 0.2;
  const Verdict all = judge(s, places);
  EXPECT_EQ(all.outcome, "not-matched");
  ASSERT_EQ(all.reasons.size(), 1u) << "one reason for all of them";
  EXPECT_NE(all.reasons[0].what.find("landmarks end 40 mm"), std::string::npos) << all.reasons[0].what;
}

TEST(Verdict, ALevelThatMinimisedNothingIsToBeLookedAt) {
  MatchSummary s = good_summary();
  s.levels.back().level = 6;
  s.levels.back().stop_reason = "cannot_evaluate_start";
  s.levels.back().stop_message = "the function cannot be evaluated at the start";
  const Verdict v = judge(s, places);
  EXPECT_EQ(v.outcome, "look-here");
  ASSERT_EQ(v.reasons.size(), 1u);
  EXPECT_EQ(v.reasons[0].what, "nothing was minimised on level 6: the function cannot be evaluated at the start");
}

TEST(Verdict, WhatWasMadeUpWeighsNothingAndIsNoReason) {
  MatchSummary s = good_summary();
  s.template_shape.invented = 0.3;
  s.verdict = judge(s, places);
  EXPECT_EQ(s.verdict->outcome, "matched");
  const auto lines = verdict_lines(s);
  EXPECT_NE(lines.at(0).find("from the template where both have data: mean"), std::string::npos) << lines[0];
}

TEST(Verdict, WhatAPartLacksIsToBeLookedAt) {
  const auto outcome = [](auto&& set) {
    MatchSummary s = good_summary();
    set(s);
    return judge(s, places).outcome;
  };
  const auto unreached = [](MatchSummary& s) {
    s.distance->uncovered = 0.4;
    s.distance->template_to_deformed.max = 0.5;
  };
  const auto beyond = [](MatchSummary& s) { s.distance->deformed_to_template.max = 0.5; };
  EXPECT_EQ(outcome(unreached), "not-matched");
  EXPECT_EQ(outcome([&](MatchSummary& s) { unreached(s), s.reference.invented = 0.2; }), "look-here");
  EXPECT_EQ(outcome([&](MatchSummary& s) { unreached(s), s.template_shape.invented = 0.2; }), "not-matched");
  EXPECT_EQ(outcome([&](MatchSummary& s) { unreached(s), s.reference.invented = 0.01; }), "not-matched");
  EXPECT_EQ(outcome([&](MatchSummary& s) { beyond(s), s.template_shape.invented = 0.2; }), "look-here");
  EXPECT_EQ(outcome([&](MatchSummary& s) { beyond(s), s.reference.invented = 0.2; }), "not-matched");
  const auto far_on_average = [](MatchSummary& s) { s.distance->template_to_deformed.mean = 0.05; };
  EXPECT_EQ(outcome([&](MatchSummary& s) { far_on_average(s), s.reference.invented = 0.2; }), "look-here");
  EXPECT_EQ(outcome([&](MatchSummary& s) { far_on_average(s), s.template_shape.invented = 0.2; }), "not-matched");
  EXPECT_EQ(outcome([&](MatchSummary& s) { s.reference.n_components = 2, s.reference.invented = 0.2; }), "matched");
  // Of two parts distances on average are of what both have.
  EXPECT_EQ(
      outcome([&](MatchSummary& s) { far_on_average(s), s.reference.invented = 0.2, s.template_shape.invented = 0.2; }),
      "not-matched");
}

TEST(Verdict, NothingInCommonIsNoMatch) {
  MatchSummary s = good_summary();
  s.distance->deformed_to_template.mean = std::numeric_limits<double>::quiet_NaN();
  const Verdict v = judge(s, places);
  EXPECT_EQ(v.outcome, "not-matched");
  ASSERT_EQ(v.reasons.size(), 1u);
  EXPECT_NE(v.reasons[0].what.find("nothing was measured"), std::string::npos);
  EXPECT_NE(verdict_lines(s).at(0).find("not measured, as there is nothing"), std::string::npos);
  s.distance_before = s.distance;
  EXPECT_NE(far_apart_warning(s).value_or("").find("nothing that both shapes have"), std::string::npos);
}

TEST(Verdict, LinesTellDistancesInTheUnitAndInDiagonals) {
  MatchSummary s = good_summary();
  s.distance->uncovered = 0.034;
  s.verdict = judge(s, places);
  const auto lines = verdict_lines(s);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0],
            "distance of the deformed reference from the template: mean 0.02 mm (0.0001 diagonals), 95 % 0.04 mm "
            "(0.0002 diagonals), "
            "largest 0.06 mm (0.0003 diagonals)");
  EXPECT_NE(lines[1].find("mean 0.08 mm (0.0004 diagonals)"), std::string::npos) << lines[1];
  EXPECT_NE(lines[1].find("; 3.4 % is not reached"), std::string::npos) << lines[1];
  EXPECT_EQ(lines[2], "verdict: matched, but look here");
  EXPECT_EQ(
      lines[3].find(
          "  3.4 % of the template is not reached, near (4.0, 5.0, 6.0) of the template; --align auto or landmarks"),
      0u)
      << lines[3];
  s.alignment.emplace().mode = "auto";  // it has been tried
  EXPECT_EQ(judge(s, places).reasons[0].advice.find("landmarks"), 0u);
  s.distance->deformed_to_template.mean = 50;
  EXPECT_NE(verdict_lines(s)[0].find("mean 10000 mm (50 diagonals)"), std::string::npos) << verdict_lines(s)[0];
  s.distance->deformed_to_template.mean = 1e-4;
  s.distance->uncovered = 1;
  EXPECT_NE(verdict_lines(s)[1].find("; 100 % is not reached"), std::string::npos) << verdict_lines(s)[1];
  s.unit = "";
  EXPECT_NE(verdict_lines(s)[0].find("mean 0.02 (0.0001 diagonals)"), std::string::npos) << verdict_lines(s)[0];
}

TEST(Verdict, SaysNothingOfWhatIsNotKnown) {
  EXPECT_TRUE(verdict_lines(MatchSummary{}).empty());
  EXPECT_EQ(judge(MatchSummary{}, {}).outcome, "matched");
  EXPECT_FALSE(stuck_warning(std::vector<LevelSummary>(4)));
  EXPECT_FALSE(far_apart_warning(MatchSummary{}));
}

TEST(FarApart, IsSaidBeforeTheRun) {
  MatchSummary s = good_summary();
  s.distance_before = TwoSidedDistance{{0.1, 0.2, 0.4}, {0.24, 0.3, 0.5}};
  EXPECT_FALSE(far_apart_warning(s));
  s.distance_before->template_to_deformed.mean = 0.26;
  ASSERT_TRUE(far_apart_warning(s));
  EXPECT_NE(far_apart_warning(s)->find("the template 52 mm (0.26 diagonals) from the reference"), std::string::npos)
      << *far_apart_warning(s);
}

/// Levels from 3 on with these shares of the template not reached.
std::vector<LevelSummary> levels_with(const std::vector<double>& uncovered) {
  std::vector<LevelSummary> levels;
  for (const double share : uncovered) {
    levels.emplace_back().level = 3 + static_cast<int>(levels.size());
    levels.back().distance = TwoSidedDistance{{}, {}, share};
  }
  return levels;
}

// Shares as measured: a gorilla that crouches, a dolphin turned by pi, a centaur, a cat, a fish.
TEST(StuckWarning, WarnsOfWhatDoesNotGetNearer) {
  const auto warning = stuck_warning(levels_with({0.528, 0.364, 0.304}));
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->find("level 5: 30 % of the template is not reached, after 36 %"), 0u) << *warning;
  EXPECT_TRUE(stuck_warning(levels_with({0.493, 0.225, 0.202})));
  EXPECT_FALSE(stuck_warning(levels_with({0.151, 0.149}))) << "the second level";
  EXPECT_FALSE(stuck_warning(levels_with({0.151, 0.149, 0.064})));
  EXPECT_FALSE(stuck_warning(levels_with({0.480, 0.268, 0.097})));
  EXPECT_FALSE(stuck_warning(levels_with({0.146, 0.043, 0.043})));
  EXPECT_FALSE(stuck_warning(levels_with({0.9, 0.6, 0.4})));
}

}  // namespace
}  // namespace shellmatch
