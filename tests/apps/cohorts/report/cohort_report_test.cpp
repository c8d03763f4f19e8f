// The page of a cohort, as far as it can be judged without a browser (tests/matching/page/cohort_browser_test.py has
// one).

#include "apps/cohorts/report/cohort_report.h"

#include "apps/cohorts/report/cohort_page.h"
#include "matching/json/json_text.h"
#include "tests/apps/cohorts/report/cohort_samples.h"
#include "tests/matching/report/page_element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace shellmatch {
namespace {

Json description(const std::string& page) {
  std::istringstream text(testing::page_element(page, "data"));
  return parse_json(text);
}

std::set<std::string> array_names(const Json& page) {
  std::set<std::string> names;
  for (const Json& a : page["arrays"]) names.insert(a["name"]);
  return names;
}

TEST(CohortReport, HoldsTheSubjectsTheWorstFirst) {
  const CohortResult<3> result = test::sample_cohort<3>();
  const Json page = description(cohort_report_html(result)), subjects = page["subjects"];
  EXPECT_EQ(page["title"], result.title);
  EXPECT_EQ(page["unit"], "mm");
  EXPECT_EQ(page["dimension"], 3);
  EXPECT_EQ(page["procrustes"], "rigid");
  ASSERT_EQ(subjects.size(), 12u);
  EXPECT_EQ(subjects[0]["id"], "subject-03");
  EXPECT_EQ(subjects[0]["status"], "timed_out");
  EXPECT_EQ(subjects[0]["message"], result.subjects[2].message);
  EXPECT_FALSE(subjects[0].contains("column") || subjects[0].contains("thumbnail") || subjects[0].contains("distance"));
  EXPECT_EQ(subjects[1]["outcome"], "not-matched");
  EXPECT_EQ(subjects[1]["reasons"].size(), 2u);
  EXPECT_FALSE(subjects[1].contains("column"));
  EXPECT_EQ(subjects[2]["id"], "subject-05");
  EXPECT_FALSE(subjects[1]["bent"]);
  EXPECT_TRUE(subjects[2]["bent"]);
  EXPECT_EQ(subjects[2]["column"], 3);  // after those of the first, second and fourth subject
  EXPECT_EQ(subjects[2]["folder"], "runs/subject-05/output");
  EXPECT_EQ(subjects[2]["reasons"][0]["advice"], result.subjects[4].reasons[0].advice);
  EXPECT_EQ(subjects[2]["distance"]["atlas_to_subject"]["max"], result.subjects[4].distance->deformed_to_template.max);
  EXPECT_EQ(subjects[2]["distance"]["subject_to_atlas"]["max"], result.subjects[4].distance->template_to_deformed.max);
  EXPECT_EQ(subjects[2]["diagonal"], 104);
  EXPECT_TRUE(subjects[2].contains("thumbnail"));
  EXPECT_EQ(page["thumbnails"]["left_out"], 0);
}

TEST(CohortReport, HoldsTheModelItsCurvesAndTheDifference) {
  const CohortResult<3> result = test::sample_cohort<3>();
  const Json page = description(cohort_report_html(result));
  EXPECT_EQ(page["shape"], "mean");
  EXPECT_EQ(page["model"]["modes"], 9);
  ASSERT_EQ(page["model"]["variances"].size(), 9u);
  EXPECT_EQ(page["model"]["variances"][1], result.model->variances[1]);
  EXPECT_EQ(page["model"]["total_variance"], result.model->total_variance);
  const ModelCurves& curves = *result.curves;
  const std::pair<const char*, const std::vector<double>&> lists[] = {
      {"compactness", curves.compactness},
      {"generalisation", curves.generalisation},
      {"generalisation_error", curves.generalisation_error},
      {"specificity", curves.specificity},
      {"specificity_error", curves.specificity_error}};
  for (const auto& [name, values] : lists) EXPECT_EQ(page["curves"][name], values) << name;
  EXPECT_EQ(page["difference"]["group_b"], "b");
  EXPECT_EQ(page["difference"]["n_a"].get<int>() + page["difference"]["n_b"].get<int>(), 10);
  EXPECT_EQ(page["difference"]["global_p"], 0.002);
  EXPECT_EQ(page["difference"]["permutations"], 1000);
  EXPECT_EQ(page["difference"]["all_permutations"], true);
  const Eigen::VectorXd& p = result.difference->p_corrected;
  const auto n_significant = static_cast<double>((p.array() < 0.05).count());
  EXPECT_NEAR(page["difference"]["significant_share"], n_significant / static_cast<double>(p.size()), 1e-12);
  EXPECT_EQ(page["rounds"][2]["change"], 0.0008);
  EXPECT_TRUE(page.contains("camera"));
  std::set<std::string> expected = {"mean",       "facets", "scores", "deviation", "difference", "difference_normal",
                                    "p_corrected"};
  for (int k = 1; k <= 9; ++k) expected.insert("mode." + std::to_string(k));
  EXPECT_EQ(array_names(page), expected);
  const auto& mean = page["arrays"][0];
  EXPECT_EQ(mean["entries"], result.atlas.vertices.size());
  EXPECT_EQ(page["arrays"][1]["entries"], result.surface.facets.size());
}

TEST(CohortReport, ModesAreDisplacementsByOneStandardDeviation) {
  const CohortResult<2> result = test::sample_cohort<2>();
  const Json page = description(cohort_report_html(result));
  EXPECT_FALSE(page.contains("camera"));
  for (const Json& a : page["arrays"])
    if (a["name"] == "mode.2") {
      const Eigen::VectorXd mode = std::sqrt(result.model->variances[1]) * result.model->modes.col(1);
      const auto xy = mode.reshaped(2, mode.size() / 2);
      EXPECT_NEAR(a["low"][0], xy.row(0).minCoeff(), 1e-9);
      EXPECT_NEAR(a["low"][1], xy.row(1).minCoeff(), 1e-9);
    }
}

TEST(CohortReport, WithoutAModelItHasTheOnlyShapeOrTheAtlas) {
  const Json one = description(cohort_report_html(test::sample_cohort<3>({.n_subjects = 1, .has_failures = false})));
  EXPECT_EQ(one["shape"], "subject");
  EXPECT_EQ(array_names(one), (std::set<std::string>{"mean", "facets"}));
  EXPECT_FALSE(one.contains("model") || one.contains("curves") || one.contains("difference"));
  EXPECT_TRUE(one["subjects"][0].contains("thumbnail"));
  CohortResult<2> none = test::sample_cohort<2>({.n_subjects = 0, .has_failures = false});
  none.subjects = {test::unfinished_subject("lost", "crashed")};
  const Json page = description(cohort_report_html(none));
  EXPECT_EQ(page["shape"], "atlas");
  EXPECT_EQ(page["subjects"].size(), 1u);
}

// It has 12 modes, and the variances of all.
TEST(CohortReport, StaysSmall) {
  CohortResult<3> result = test::sample_cohort<3>({.n_subjects = 40, .n_points = 5000, .has_failures = false});
  ASSERT_GE(result.atlas.vertices.size(), 4900u);
  const std::string html = cohort_report_html(result);
  EXPECT_LT(html.size(), 5'000'000u);
  const Json page = description(html);
  EXPECT_EQ(page["model"]["modes"], 12);
  EXPECT_EQ(page["model"]["variances"].size(), static_cast<std::size_t>(result.model->variances.size()));
  EXPECT_GT(result.model->variances.size(), 12);
  EXPECT_FALSE(array_names(page).contains("mode.13"));
}

// A name that would end the element, begin another one or a comment stays a name; what was not measured is no number.
TEST(CohortReport, NamesDoNotBecomePartsOfThePage) {
  CohortResult<2> result = test::sample_cohort<2>();
  const std::string name = "</script><script>alert(1)</script><!-- \xff\"&";
  result.title = result.unit = name;
  for (SubjectResult& s : result.subjects) s.id = s.group = s.message = s.folder = name;
  result.group_a = name;
  result.subjects[4].reasons[0].what = name;
  result.subjects[4].distance->deformed_to_template.p95 = std::numeric_limits<double>::quiet_NaN();
  const std::string page = cohort_report_html(result);
  EXPECT_EQ(testing::page_element(page, "data").find('<'), std::string::npos);
  const Json read_back = description(page);
  EXPECT_TRUE(read_back["title"].get<std::string>().starts_with("</script><script>alert(1)</script><!-- "));
  EXPECT_TRUE(read_back["subjects"][2]["distance"]["atlas_to_subject"]["p95"].is_null());
  const auto count = [](std::string_view text, std::string_view part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count(page, "<script"), count(cohort_page, "<script"));
}

TEST(CohortReport, ThePageNamesNoHostItWouldAsk) {
  EXPECT_NE(cohort_page.find("Content-Security-Policy\" content=\"default-src 'none'"), std::string_view::npos);
  for (const char* word : {"src=\"http", "href=\"http", "src=\"//", "@import"})
    EXPECT_EQ(cohort_page.find(word), std::string_view::npos) << word;
}

}  // namespace
}  // namespace shellmatch
