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
}

}  // namespace
}  // namespace shellmatch
