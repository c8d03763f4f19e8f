// Matching as a function of values: the same numbers as a run writes, and no file.

#include "matching/match_shapes.h"

#include "base/error.h"
#include "geometry/repair/make_shape.h"
#include "matching/input/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/history_file.h"
#include "matching/write_result.h"
#include "matching/output/summary.h"
#include "matching/run_matching.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::TemporaryFolder;

Shape<2> outline(const std::string& name) { return std::get<Shape<2>>(open_shape("generate:" + name)); }

/// The outline `factor` times as large, in a unit or in none.
Shape<2> scaled(const std::string& name, double factor, const std::string& unit) {
  OriginalShape<2> original = outline(name).original;
  for (Vec<2>& x : original.vertices) x *= factor;
  Shape<2> shape = make_shape(std::move(original), name + " " + unit);
  shape.unit = unit;
  return shape;
}

ExperimentOptions options_to(int max_level) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.input.reference = "generate:ellipse/round";
  o.input.template_file = "generate:ellipse/long";
  o.cascade.max_level = max_level;
  o.pictures = Pictures::result;
  return o;
}

std::string lasting_summary(MatchSummary s) {
  s.run = {};
  return summary_json(s);
}

std::string lasting_history(History history) {
  for (HistoryRow& row : history.rows) row.record.seconds = 0;
  return history_csv(history);
}

TEST(MatchShapes, ResultsAreInTheUnitOfTheTemplateWhereItIsKnown) {
  struct Words final : Observer {
    void warn(const std::string& text) override { all += text + "\n"; }
    std::string all;
  };
  const auto unit_of = [](double factor, const std::string& of_reference, const std::string& of_template,
                          Words& words) {
    return *match_shapes(scaled("ellipse/round", factor, of_reference), scaled("ellipse/long", 1, of_template),
                         options_to(3), words)
                .summary.unit;
  };
  Words quiet, words;
  EXPECT_EQ(unit_of(1, "", "mm", quiet), "mm");
  EXPECT_EQ(unit_of(1, "mm", "", quiet), "mm");
  EXPECT_EQ(unit_of(1000, "", "mm", quiet), "mm");
  EXPECT_EQ(unit_of(1000, "", "", quiet), "");
  EXPECT_EQ(quiet.all.find("unit"), std::string::npos) << quiet.all;
  EXPECT_EQ(unit_of(1000, "mm", "", words), "");
  EXPECT_NE(words.all.find("names no unit and is 0.00"), std::string::npos) << words.all;
}

TEST(MatchShapes, GivesWhatARunWrites) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = options_to(5);
  Observer quiet;
  const AnyMatchResult returned = run_matching(o, tmp / "run", {}, quiet);
  const MatchResult<2> result = match_shapes(outline("ellipse/round"), outline("ellipse/long"), o, quiet);

  // A run knows where these vertices truly go; the function was not told.
  const MatchSummary written = read_summary(tmp / "run/summary.json");
  EXPECT_EQ(summary_json(summary_of(returned)), summary_json(written));
  MatchSummary untold = written;
  untold.correspondence_error.reset();
  untold.correspondence_error_before.reset();
  EXPECT_TRUE(written.correspondence_error);
  EXPECT_EQ(lasting_summary(result.summary), lasting_summary(untold));
  EXPECT_EQ(lasting_history(result.history), lasting_history(read_history(tmp / "run/history.csv")));

  const Deformation<2> map = read_deformation<2>(tmp / "run");
  ASSERT_EQ(map.phi.size(), result.map.phi.size());
  for (const Vec<2>& x : {Vec<2>(0.1, 0.2), Vec<2>(-0.4, 0.3), Vec<2>(7, 7)})
    EXPECT_EQ(map.apply(x), result.map.apply(x));

  write_result_folder(result, o, tmp / "written");
  for (const char* file :
       {"deformed.csv", "deformation.vtu", "config.yaml", "pictures/result.png", "pictures/energy.png"})
    EXPECT_EQ(contents_of(tmp / (std::string("written/") + file)), contents_of(tmp / (std::string("run/") + file)))
        << file;
}

// Every vertex comes back in its order and where the map has it, a seam that mending welds included.
TEST(MatchShapes, VerticesKeepTheirOrderAndFollowTheMap) {
  const OriginalShape<2> given = outline("ellipse/round").original;
  OriginalShape<2> circle = given;
  circle.vertices.push_back(circle.vertices.front());  // twice, and once without a segment
  circle.polygons.front().push_back(static_cast<Index>(given.vertices.size()));
  circle.vertices.emplace_back(0.25, 0.125);
  circle.attributes.push_back({"label", "int", std::vector<double>(circle.vertices.size(), 7)});
  Observer quiet;
  const MatchResult<2> r = match_shapes(make_shape(circle, "circle"), outline("ellipse/long"), options_to(4), quiet);
  ASSERT_EQ(r.deformed.vertices.size(), given.vertices.size() + 2);
  EXPECT_EQ(r.deformed.polygons, circle.polygons);
  for (std::size_t v = 0; v < circle.vertices.size(); ++v)
    EXPECT_EQ(r.deformed.vertices[v], r.map.apply(circle.vertices[v])) << v;
  ASSERT_EQ(r.deformed.attributes.size(), 8u);  // its own, two figures and five of the nearest point
  EXPECT_EQ(r.template_shape.attributes.back().name, "distance_to_deformed");
  EXPECT_EQ(r.deformed.attributes[0].values, circle.attributes[0].values);
  EXPECT_EQ(r.surfaces.deformed.vertices.size(), r.surfaces.reference.vertices.size());
  EXPECT_EQ(r.surfaces.distance.size(), r.surfaces.reference.vertices.size());
  // At the surface's vertices the unit domain's distance is that of the summary, relative to the template's diagonal.
  const double diagonal = bounding_box(r.surfaces.template_shape.vertices).diagonal();
  for (const double d : r.surfaces.distance)
    EXPECT_LE(d / diagonal, r.summary.distance->deformed_to_template.max * 1.0001);
}

TEST(MatchShapes, AnObserverStopsItAndTheResultSaysSo) {
  struct Stop final : Observer {
    bool iterated(const LevelStart& start, const IterationRecord&) override { return start.level < 4; }
  } stop;
  const MatchResult<2> r = match_shapes(outline("ellipse/round"), outline("ellipse/long"), options_to(6), stop);
  EXPECT_TRUE(r.summary.interrupted);
  EXPECT_EQ(r.summary.levels.back().level, 4);
  EXPECT_EQ(r.history.rows.back().level, 4);
}

Shape<2> circles(const std::vector<Vec<2>>& centres, double radius) {
  OriginalShape<2> shape;
  constexpr int n = 60;
  for (const Vec<2>& centre : centres) {
    auto& ring = shape.polygons.emplace_back();
    for (int i = 0; i < n; ++i) {
      ring.push_back(static_cast<Index>(shape.vertices.size()));
      const double t = 2 * std::acos(-1.0) * i / n;
      shape.vertices.emplace_back(centre + radius * Vec<2>(std::cos(t), std::sin(t)));
    }
  }
  return make_shape(std::move(shape), "circles");
}

// In the coordinates of the template's file, in whichever direction the map was found.
TEST(MatchShapes, TheVerdictSaysWhereTheTemplateIsNotReached) {
  const Vec<2> here(1000, 500), there(1100, 480);
  for (const MatchDirection direction : {MatchDirection::forward, MatchDirection::backward}) {
    ExperimentOptions o = options_to(5);
    o.align.direction = direction;
    o.align.mode = AlignMode::none;
    Observer quiet;
    const MatchResult<2> r = match_shapes(circles({here}, 20), circles({here, there}, 20), o, quiet);
    const Verdict& v = r.summary.verdict.value();
    EXPECT_EQ(v.outcome, "not-matched");
    ASSERT_FALSE(v.reasons.empty());
    bool found = false;
    for (const VerdictReason& reason : v.reasons)
      if (reason.shape == "template") {
        found = true;
        const Vec<2> place(reason.place.at(0), reason.place.at(1));
        double off = std::abs((place - there).norm() - 20);
        // Backward one circle is drawn over both, and which of them it covers worse hangs on the last digits.
        if (direction == MatchDirection::backward) off = std::min(off, std::abs((place - here).norm() - 20));
        EXPECT_LT(off, 2) << enum_name(direction);
      }
    EXPECT_TRUE(found);
    EXPECT_EQ(r.summary.template_shape.n_components, 2u);
    EXPECT_NEAR(r.summary.template_diagonal.value(), std::hypot(140, 60), 0.5);
  }
}

TEST(MatchShapes, OptionsThatAProgramHasSetAreChecked) {
  const Shape<2> circle = outline("ellipse/round");
  Observer quiet;
  const auto message = [&](auto change) {
    ExperimentOptions o = options_to(4);
    change(o);
    return message_of<InputError>([&] { match_shapes(circle, circle, o, quiet); });
  };
  // First what costs little where nobody checks.
  ASSERT_EQ(message([](ExperimentOptions& o) { o.cascade.nu = std::numeric_limits<double>::infinity(); }),
            "cascade.nu: inf is out of range; expected a finite number, x > 0");
  EXPECT_EQ(message([](ExperimentOptions& o) { o.cascade.max_level = 16; }),
            "cascade.max_level: 16 is out of range; expected an integer, 1 <= x <= 15");
  EXPECT_EQ(message([](ExperimentOptions& o) { o.cascade.min_level = 5; }),
            "cascade.max_level: 4 is below cascade.min_level = 5; expected at least that");
}

}  // namespace
}  // namespace shellmatch
