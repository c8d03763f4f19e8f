// Tables of a cohort: their order, their quotes and what is unknown.

#include <gtest/gtest.h>

#include "apps/cohorts/output/cohort_summary.h"
#include "apps/cohorts/output/cohort_tables.h"

namespace shellmatch {
namespace {

SubjectResult subject(const std::string& id, const std::string& status, const std::string& outcome, double farthest) {
  SubjectResult s;
  s.id = id;
  s.status = status;
  s.outcome = outcome;
  s.diagonal = 10;
  if (status == "finished") s.distance = TwoSidedDistance{{0.001, 0.002, farthest}, {0.001, 0.002, 0.003}};
  return s;
}

const std::vector<SubjectResult> listed{subject("good", "finished", "matched", 0.01),
                                        subject("worse", "finished", "matched", 0.02), subject("lost", "failed", "", 0),
                                        subject("look", "finished", "look-here", 0.001),
                                        subject("wrong", "finished", "not-matched", 0.001)};

TEST(CohortTables, DistancesAreInTheUnitOfTheShapes) {
  Cohort cohort;
  cohort.subjects.resize(listed.size());
  cohort.subjects[0].source = "a, b.ply";
  for (Subject& s : cohort.subjects) s.further = {{"age", "7"}};
  std::vector<SubjectResult> subjects = listed;
  subjects[3].bent = true;
  const std::string text = subjects_csv(cohort, subjects, {0, 1, 3});
  EXPECT_NE(text.find("\ngood,,finished,matched,0,0.01,0.02,0.1,0.01,0.02,0.03,,10,0,,,\"a, b.ply\",0,7\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\nlost,,failed,,,,,,,,,,10,,,,,0,7\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nlook,,finished,look-here,2,0.01,0.02,0.01,0.01,0.02,0.03,,10,1,,,,0,7\n"), std::string::npos)
      << text;
}

TEST(CohortSummary, QuantilesAreValuesOfTheList) {
  const Spread s = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(s.n, 5u);
  EXPECT_EQ(s.median, 3);
  EXPECT_EQ(s.p95, 5);
  EXPECT_EQ(s.max, 5);
  std::vector<double> many;
  for (int k = 1; k <= 100; ++k) many.push_back(k);
  EXPECT_EQ(spread_of(many).p95, 95);
  EXPECT_EQ(spread_of({}).n, 0u);
}

}  // namespace
}  // namespace shellmatch
