#include "base/error.h"
#include "matching/output/history_file.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <limits>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;

History some_history() {
  History h{{"match", "membrane"}, {}};
  for (int level = 3; level < 5; ++level)
    for (int i = 0; i < 4; ++i)
      h.rows.push_back({level,
                        1,
                        0.1 / level,
                        {i,
                         1.0 / (3 + i),
                         {0.1 * i, 1e-300 / 7},
                         1e-5 / 3,
                         1e-3 / 7,
                         0.7,
                         2 * i + 1,
                         i + 1,
                         0.25 * i,
                         i < 2 ? "newton" : "lbfgs"}});
  return h;
}

TEST(HistoryTest, RoundTripIsExact) {
  const TemporaryFolder tmp;
  const History h = some_history();
  write_history(h, tmp / "history.csv");
  const History back = read_history(tmp / "history.csv");
  EXPECT_EQ(back.term_names, h.term_names);
  ASSERT_EQ(back.rows.size(), h.rows.size());
  EXPECT_EQ(history_csv(back), history_csv(h));
  for (std::size_t i = 0; i < h.rows.size(); ++i) {
    EXPECT_EQ(back.rows[i].nu, h.rows[i].nu);
    EXPECT_EQ(back.rows[i].record.value, h.rows[i].record.value);
    EXPECT_EQ(back.rows[i].record.terms, h.rows[i].record.terms);
    EXPECT_EQ(back.rows[i].record.solver, h.rows[i].record.solver);
    EXPECT_EQ(back.rows[i].record.l2_gradient_norm, h.rows[i].record.l2_gradient_norm);
    EXPECT_EQ(back.rows[i].record.gradient_evaluations, h.rows[i].record.gradient_evaluations);
    EXPECT_EQ(back.rows[i].record.seconds, h.rows[i].record.seconds);
  }
}

TEST(HistoryTest, HeadLineNamesEveryColumn) {
  const std::string csv = history_csv(some_history());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "level,substep,nu,solver,iteration,value,match,membrane,gradient_norm,l2_gradient_norm,step,"
            "value_evaluations,gradient_evaluations,seconds");
}

TEST(HistoryTest, DamageIsAnInputErrorThatNamesTheLine) {
  const TemporaryFolder tmp;
  const std::string good = history_csv(some_history());
  const std::size_t third = good.find('\n', good.find('\n') + 1) + 1;
  for (const std::string& bad :
       {good.substr(0, third) + "3,1,0.1\n", good.substr(0, third) + "x" + good.substr(third)}) {
    put(tmp / "h.csv", bad);
    EXPECT_NE(message_of<InputError>([&] { read_history(tmp / "h.csv"); }).find("line 3"), std::string::npos);
  }
  // A level that no integer has is not cut to one.
  put(tmp / "h.csv", good.substr(0, third) + "4294967299" + good.substr(good.find(',', third)));
  EXPECT_NE(message_of<InputError>([&] { read_history(tmp / "h.csv"); }).find("line 3: '4294967299'"),
            std::string::npos);
  put(tmp / "h.csv", "a,b,c\n");
  EXPECT_THROW(read_history(tmp / "h.csv"), InputError);
  EXPECT_THROW(read_history(tmp / "not_there.csv"), InputError);
}

TEST(HistoryTest, PlotHasTheSumAndEachTermAndAMarkAtEachNewMinimisation) {
  const History h = some_history();
  for (const bool over_seconds : {false, true}) {
    const Plot plot = energy_plot(h, over_seconds);
    ASSERT_EQ(plot.series.size(), 3u);
    EXPECT_EQ(plot.series[1].name, "match");
    ASSERT_EQ(plot.marks.size(), 1u);
    EXPECT_DOUBLE_EQ(plot.marks[0], over_seconds ? 0.75 : 3);
    EXPECT_DOUBLE_EQ(plot.series[0].x.back(), over_seconds ? 1.5 : 6);
    for (const Series& s : plot.series) EXPECT_EQ(s.x.size(), s.y.size());
  }
  EXPECT_TRUE(energy_plot({}).series[0].x.empty());
}

}  // namespace
}  // namespace shellmatch
