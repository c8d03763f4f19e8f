// The page of a result, as far as it can be judged without a browser (tests/matching/page/browser_test.py has one).

#include "matching/report/report.h"

#include "matching/checkpoint/checkpoints.h"
#include "matching/input/shape_source.h"
#include "matching/json/json_text.h"
#include "matching/match_shapes.h"
#include "matching/report/report_page.h"
#include "matching/report/surface_figures.h"
#include "tests/matching/report/page_element.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace shellmatch {
namespace {

template <int Dim>
Shape<Dim> shape(const std::string& name) {
  return std::get<Shape<Dim>>(open_shape("generate:" + name));
}

ExperimentOptions quick(int min_level, int max_level) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.min_level = min_level;
  o.cascade.max_level = max_level;
  o.align.mode = AlignMode::none;
  o.align.direction = MatchDirection::forward;
  o.pictures = Pictures::none;
  return o;
}

template <int Dim>
MatchResult<Dim> matched(const std::string& reference, const std::string& template_shape,
                         const ExperimentOptions& options) {
  Observer nobody;
  return match_shapes(shape<Dim>(reference), shape<Dim>(template_shape), options, nobody);
}

Json description(const std::string& page) {
  std::istringstream text(testing::page_element(page, "data"));
  return parse_json(text);
}

TEST(Report, HoldsSummaryOptionsAndAllArrays) {
  ExperimentOptions o = quick(3, 5);
  o.energy.delta = 0.75;
  const MatchResult<2> result = matched<2>("circle", "ellipse", o);
  ASSERT_EQ(result.levels.size(), 2u);
  EXPECT_EQ(result.levels[0].level, 3);
  EXPECT_EQ(result.levels[1].vertices.size(), result.surfaces.reference.vertices.size());
  const Json report = description(report_html(result, o));
  EXPECT_EQ(report["summary"]["dimension"], 2);
  EXPECT_EQ(report["levels"], (std::vector<int>{3, 4}));
  EXPECT_FALSE(report.contains("picture"));
  std::set<std::string> names, changed;
  std::size_t end = 0;
  for (const Json& a : report["arrays"]) {
    names.insert(a["name"]);
    EXPECT_EQ(a["offset"], end);
    end += a["bytes"].get<std::size_t>();
  }
  for (const char* name : {"reference", "template", "deformed", "deformed.3", "deformed.4", "reference.facets",
                           "distance_to_template", "distance_to_deformed", "measure_ratio", "curvature_change",
                           "history.energy", "history.match", "grid.levels", "grid.images"})
    EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_FALSE(names.contains("angle_change"));
  for (const Json& option : report["options"])
    if (option.contains("default")) changed.insert(option["name"]);
  EXPECT_TRUE(changed.contains("energy.delta") && changed.contains("pictures"));
  EXPECT_FALSE(changed.contains("cascade.nu"));
}

TEST(Report, KeepsNoLevelsWhereThereIsNone) {
  ExperimentOptions o = quick(3, 4);
  o.report = false;
  EXPECT_TRUE(matched<2>("circle", "ellipse", o).levels.empty());
}

// A run that was stopped goes on whether it writes a report or not.
TEST(Report, ChangesNoLevel) {
  ExperimentOptions with = quick(3, 4), without = with;
  without.report = false;
  EXPECT_EQ(changed_option(with, without), "");
  without.cascade.nu /= 2;
  EXPECT_TRUE(changed_option(with, without).starts_with("cascade.nu"));
}

// A name that would end the element, begin another one or a comment stays a name.
TEST(Report, NamesDoNotBecomePartsOfThePage) {
  const ExperimentOptions o = quick(3, 3);
  MatchResult<2> result = matched<2>("circle", "ellipse", o);
  const std::string name = "</script><script>alert(1)</script><!-- \xff\"&.csv";
  result.summary.reference.file = name;
  const std::string page = report_html(result, o), data = testing::page_element(page, "data");
  EXPECT_EQ(data.find('<'), std::string::npos);
  const std::string read_back = description(page)["summary"]["reference"]["file"];
  EXPECT_TRUE(read_back.starts_with("</script><script>alert(1)</script><!-- ")) << read_back;
  const auto count = [](std::string_view text, std::string_view part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count(page, "<script"), count(report_page, "<script"));
}

TEST(Report, ThePageNamesNoHostItWouldAsk) {
  EXPECT_NE(report_page.find("Content-Security-Policy\" content=\"default-src 'none'"), std::string_view::npos);
  for (const char* word : {"src=\"http", "href=\"http", "src=\"//", "@import"})
    EXPECT_EQ(report_page.find(word), std::string_view::npos) << word;
}

// A sphere of radius 1/4 carried onto one of 3/8 by a map that is known.
TEST(SurfaceFigures, AreThoseOfAScaledSphere) {
  MatchResult<3> result = matched<3>("sphere", "sphere", quick(2, 2));
  MatchedSurfaces<3>& s = result.surfaces;
  const Vec<3> centre = Vec<3>::Constant(0.5);
  const auto scaled = [&](double radius) {
    std::vector<Vec<3>> vertices = s.reference.vertices;
    for (Vec<3>& x : vertices) x = centre + radius * (x - centre).normalized();
    return vertices;
  };
  s.reference.vertices = scaled(0.25);
  s.template_shape = s.deformed = s.reference;
  s.template_shape.vertices = s.deformed.vertices = scaled(0.375);
  s.distance.assign(s.deformed.vertices.size(), 0.01);
  s.template_distance.assign(s.template_shape.vertices.size(), 0.03);
  result.map.placement.scale = 0.5;  // lengths of the files are twice as long
  const SurfaceFigures figures = surface_figures(result);
  for (std::size_t v = 0; v < s.reference.vertices.size(); ++v) {
    EXPECT_DOUBLE_EQ(figures.distance_to_template[v], 0.02);
    EXPECT_DOUBLE_EQ(figures.distance_to_deformed[v], 0.06);
    EXPECT_NEAR(figures.measure_ratio[v], 2.25, 1e-9);
    EXPECT_NEAR(figures.angle_change[v], 0, 1e-4);
    EXPECT_NEAR(figures.curvature_change[v], (1 / 0.375 - 1 / 0.25) / 2, 0.01);
  }
  // From a few fits, too, of which the other vertices have theirs.
  for (const double change : surface_figures(result, 100).curvature_change)
    EXPECT_NEAR(change, (1 / 0.375 - 1 / 0.25) / 2, 0.01);
}

// Stretched along an axis by 2: facets that contain the axis are sheared by 2 atan sqrt 2 - 90 degrees, those across it
// not at all.
TEST(SurfaceFigures, AngleChangeIsTheLargestOfAllAngles) {
  MatchResult<3> result = matched<3>("sphere", "sphere", quick(2, 2));
  MatchedSurfaces<3>& s = result.surfaces;
  s.template_shape = s.deformed = s.reference;
  for (Surface<3>* stretched : {&s.template_shape, &s.deformed})
    for (Vec<3>& x : stretched->vertices) x[2] = 0.5 + 2 * (x[2] - 0.5);
  s.distance.assign(s.deformed.vertices.size(), 0);
  s.template_distance = s.distance;
  const std::vector<double> change = surface_figures(result).angle_change;
  EXPECT_NEAR(*std::ranges::max_element(change), 2 * std::atan(std::sqrt(2.0)) * 180 / std::acos(-1.0) - 90, 0.2);
  EXPECT_LT(*std::ranges::min_element(change), 1);
}

}  // namespace
}  // namespace shellmatch
