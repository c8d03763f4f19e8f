// Cohorts of surfaces onto a given atlas, whose poses are predicted from the first subjects.

#include "geometry/generate/round.h"
#include "geometry/io/write_shape.h"
#include "matching/output/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "tests/apps/cohorts/execution/cohort_harness.h"

namespace shellmatch {
namespace {

struct CohortPrediction : CohortProgram {
  /// The atlas and five subjects, each with a bump.
  void SetUp() override {
    CohortProgram::SetUp();
    for (int k = 0; k <= 5; ++k) {
      Surface<3> surface = geodesic_sphere(5);
      const Vec<3> top = Vec<3>(1, 0.7, 0.4).normalized(), axes(1.3 + 0.03 * k, 1.1, 0.9 - 0.02 * k);
      for (Vec<3>& x : surface.vertices) x = axes.cwiseProduct((1 + 0.25 * std::exp(-4 * (x - top).squaredNorm())) * x);
      OriginalShape<3> shape{surface.vertices, {}, {}};
      for (const auto& facet : surface.facets) shape.polygons.emplace_back(facet.begin(), facet.end());
      write_ply(path(k == 0 ? "atlas.ply" : fmt::format("s{}.ply", k)), shape);
    }
  }
  std::vector<std::string> words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> all{"s4.ply", "s2.ply", "s5.ply", "s1.ply", "s3.ply", "--atlas", "atlas.ply", "-o", out};
    if (more.empty()) std::reverse(all.begin(), all.begin() + 5);
    for (const char* word : {"--levels", "3:3", "--set", "statistics.samples=20", "--set", "statistics.mode_meshes=0"})
      all.emplace_back(word);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::optional<int> predicted_from(const std::string& out, int subject) const {
    return read_summary(path(fmt::format("{}/runs/s{}/output/summary.json", out, subject))).alignment->n_images;
  }
};

TEST_F(CohortPrediction, OrderAndDivisionChangeNothing) {
  const ProgramResult whole = cohort(words("whole"));
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_TRUE(has(whole.err, "first subjects: 3 subjects")) << whole.err;
  for (const int k : {1, 2, 3}) EXPECT_FALSE(predicted_from("whole", k)) << k;
  for (const int k : {4, 5}) EXPECT_EQ(predicted_from("whole", k), 3) << k;
  EXPECT_FALSE(std::filesystem::exists(path("whole/runs/s4/output/report.html")));

  EXPECT_EQ(cohort(words("parts", {"--list-stages"})).out, "first\nlast\n");
  const ProgramResult early = cohort(words("parts", {"--only", "s4", "--stage", "last"}));
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_TRUE(has(early.err, "last stage waits for first subjects")) << early.err;
  const ProgramResult waits = cohort(words("parts", {"--shard", "1/2"}));  // s4, s5, s3
  EXPECT_EQ(waits.exit_code, 0) << waits.err;
  EXPECT_TRUE(has(waits.err, "the other subjects wait for the first ones of other parts")) << waits.err;
  for (const char* shard : {"2/2", "1/2"}) EXPECT_EQ(cohort(words("parts", {"--shard", shard, "-q"})).exit_code, 0);
  const ProgramResult end = cohort(words("parts", {"--collect"}));
  ASSERT_EQ(end.exit_code, 0) << end.err;
  for (int k = 1; k <= 5; ++k) {
    const std::string name = fmt::format("runs/s{}/output/deformed.ply", k);
    EXPECT_EQ(text_of("parts/" + name), text_of("whole/" + name)) << name;
  }
}

}  // namespace
}  // namespace shellmatch
