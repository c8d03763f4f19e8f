#include "matching/result/verdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace shellmatch {
namespace {

MatchSummary matched() {
  MatchSummary s;
  s.reference.n_facets = 1000;
  s.distance = TwoSidedDistance{{1e-4, 2e-4, 3e-4}, {4e-4, 5e-4, 6e-4}};
  s.n_flipped_facets = 3;
  s.levels.resize(2);
  s.levels[1].folds.n_folded_cells = 7;
  return s;
}

TEST(Verdict, TellsDistancesBothWaysAndFolds) {
  const auto lines = verdict(matched());
  ASSERT_EQ(lines.size(), 1u);
  for (const char* part : {"mean 0.0001, largest 0.0003", "mean 0.0004, largest 0.0006 back", "7 folded cells"})
    EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
}

TEST(Verdict, TellsHowMuchIsNotReached) {
  MatchSummary s = matched();
  EXPECT_EQ(verdict(s)[0].find("uncovered"), std::string::npos);
  s.distance->uncovered = 0.034;
  EXPECT_NE(verdict(s)[0].find("; 3.4 % of the template uncovered"), std::string::npos) << verdict(s)[0];
}

TEST(Verdict, TellsWhatDoesNotBelongTogether) {
  for (const double far : {0.031, std::numeric_limits<double>::quiet_NaN()})
    for (const bool back : {false, true}) {
      MatchSummary s = matched();
      (back ? s.distance->template_to_deformed : s.distance->deformed_to_template).mean = far;
      const auto lines = verdict(s);
      ASSERT_EQ(lines.size(), 2u) << far << back;
      EXPECT_NE(lines[1].find("do not match"), std::string::npos) << lines[1];
    }
  MatchSummary s = matched();
  s.n_flipped_facets = 21;
  const auto lines = verdict(s);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[1].find("21 of 1000 facets face away"), std::string::npos) << lines[1];
}

TEST(Verdict, SaysNothingOfWhatIsNotKnown) {
  EXPECT_TRUE(verdict(MatchSummary{}).empty());
  EXPECT_FALSE(stuck_warning(std::vector<LevelSummary>(4)));
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
