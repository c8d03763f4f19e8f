// A whole head onto one without its neck, and the reverse: what is there is matched as between whole heads, and what
// the other lacks is neither pulled nor measured.

#include "geometry/generate/generate_shape.h"
#include "geometry/repair/make_shape.h"
#include "matching/alignment/align_shapes.h"
#include "matching/alignment/trial.h"
#include "matching/input/shape_source.h"
#include "matching/match_shapes.h"
#include "matching/result/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {
namespace {

struct CutShape {
  Shape<3> shape;
  std::vector<Index> kept;  // its vertices in the whole shape
  double height = 0;        // along the direction, of the cut
};

// Without the share of the surface that lies farthest along `direction`.
CutShape cut(const Shape<3>& whole, const Vec<3>& direction, double share) {
  const Surface<3>& surface = whole.surface;  // nothing had to be mended: vertices are those of the original
  std::vector<std::pair<double, std::size_t>> order;
  double total = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    double height = 0;
    for (const Index v : surface.facets[f]) height += surface.vertices[static_cast<std::size_t>(v)].dot(direction) / 3;
    order.emplace_back(height, f);
    total += facet_measure(surface, static_cast<Index>(f));
  }
  std::ranges::sort(order);
  OriginalShape<3> rest;
  std::vector<Index> number(surface.vertices.size(), no_index);
  CutShape result;
  double area = 0;
  for (const auto& [height, f] : order) {
    area += facet_measure(surface, static_cast<Index>(f));
    if (area > (1 - share) * total) break;
    result.height = height;
    std::vector<Index>& polygon = rest.polygons.emplace_back();
    for (const Index v : surface.facets[f]) {
      Index& n = number[static_cast<std::size_t>(v)];
      if (n == no_index) {
        n = static_cast<Index>(rest.vertices.size());
        rest.vertices.push_back(surface.vertices[static_cast<std::size_t>(v)]);
        result.kept.push_back(v);
      }
      polygon.push_back(n);
    }
  }
  result.shape = make_shape(std::move(rest), "cut", {}, Closing::automatic);
  return result;
}

const VertexAttribute* column(const OriginalShape<3>& shape, const std::string& name) {
  const auto found = std::ranges::find(shape.attributes, name, &VertexAttribute::name);
  return found == shape.attributes.end() ? nullptr : &*found;
}

// The match of the whole heads tells where every vertex of the reference belongs.
class Partial : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    reference = std::make_unique<Shape<3>>(face(""));
    other = std::make_unique<Shape<3>>(face("other"));
  }
  static void TearDownTestSuite() {
    reference.reset();
    other.reset();
    whole_match.reset();
  }
  /// Of the tests that need it the first makes it.
  static const MatchResult<3>& whole() {
    Observer quiet;
    if (!whole_match)
      whole_match = std::make_unique<MatchResult<3>>(match_shapes(*reference, *other, options(), quiet));
    return *whole_match;
  }
  // Edges are shorter than half a cell of the finest level that is used here.
  static Shape<3> face(const char* variant) {
    return make_shape(std::get<OriginalShape<3>>(generate_shape("face", variant, 0.012)), "face");
  }
  static ExperimentOptions options() {
    ExperimentOptions o = profile_defaults(Profile::standard);
    o.cascade.max_level = 5;
    o.align.mode = AlignMode::none;
    return o;
  }
  // Mean distance of ends from those of the whole heads, over vertices of the reference; diagonals of the template.
  template <class EndOf>
  static double difference(const std::vector<Index>& vertices, EndOf&& end_of) {
    EXPECT_GT(vertices.size(), 1000u);
    double sum = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      sum += (end_of(i) - whole().deformed.vertices[static_cast<std::size_t>(vertices[i])]).norm();
    return sum / static_cast<double>(vertices.size()) / bounding_box(other->original.vertices).diagonal();
  }

  // Few vertices and functions, which tell turned heads apart.
  static ExperimentOptions search_options() {
    ExperimentOptions o = options();
    o.align.mode = AlignMode::automatic;
    o.align.search.max_vertices = 1000;
    o.align.search.pairs = 300;
    o.align.search.functions = 60;
    o.align.search.refined = 2;
    o.align.bend = BendMode::never;
    o.align.direction = MatchDirection::forward;
    o.cascade.max_level = 3;
    return o;
  }
  static Shape<3> sideways(double scale) {
    OriginalShape<3> turned = reference->original;
    for (Vec<3>& x : turned.vertices) x = scale * Vec<3>(-x[1], x[0], x[2]);
    return make_shape(std::move(turned), "sideways");
  }
  struct Notes final : Observer {
    void note(const std::string& text) override { all += text + "\n"; }
    std::string all;
  };

  const Vec<3> down{0, -1, 0};
  static inline std::unique_ptr<Shape<3>> reference, other;
  static inline std::unique_ptr<MatchResult<3>> whole_match;
  Observer quiet;
};

TEST_F(Partial, AWholeHeadFitsAPartOfOne) {
  const CutShape part = cut(*other, down, 1.0 / 3);
  EXPECT_GT(part.shape.invented_share, 0.1);
  const MatchResult<3> fitted = match_shapes(*reference, part.shape, options(), quiet);
  std::vector<Index> kept, gone;
  for (std::size_t v = 0; v < reference->original.vertices.size(); ++v)
    (whole().deformed.vertices[v].dot(down) < part.height ? kept : gone).push_back(static_cast<Index>(v));
  const auto end_in = [](const MatchResult<3>& r, const std::vector<Index>& vertices) {
    return [&](std::size_t i) { return r.deformed.vertices[static_cast<std::size_t>(vertices[i])]; };
  };
  // Without the mask the cut is matched like the rest.
  CutShape taken_for_whole = part;
  taken_for_whole.shape.evidence = {};
  const MatchResult<3> pulled = match_shapes(*reference, taken_for_whole.shape, options(), quiet);
  EXPECT_LT(difference(kept, end_in(fitted, kept)), 0.008);
  EXPECT_GT(difference(kept, end_in(pulled, kept)), 0.012);
  // What the template lacks is not pulled to the cut, which is up to 0.3 diagonals away.
  EXPECT_LT(difference(gone, end_in(fitted, gone)), 0.03);
  EXPECT_GT(difference(gone, end_in(pulled, gone)), 0.06);

  // Nothing is measured there, and the result says where.
  EXPECT_EQ(fitted.summary.verdict->outcome, "matched") << verdict_lines(fitted.summary).back();
  EXPECT_NEAR(*fitted.summary.template_shape.invented, part.shape.invented_share, 1e-12);
  const VertexAttribute* observed = column(fitted.deformed, "template_observed");
  ASSERT_NE(observed, nullptr);
  const auto share_observed = [&](const std::vector<Index>& vertices) {
    const auto n =
        std::ranges::count_if(vertices, [&](Index v) { return observed->values[static_cast<std::size_t>(v)] != 0; });
    return static_cast<double>(n) / static_cast<double>(vertices.size());
  };
  EXPECT_GT(share_observed(kept), 0.95);
  EXPECT_LT(share_observed(gone), 0.1);
  EXPECT_EQ(column(whole().deformed, "template_observed"), nullptr);
  EXPECT_TRUE(std::ranges::any_of(fitted.surfaces.distance, [](double d) { return std::isnan(d); }));
}

TEST_F(Partial, APartOfAHeadFitsAWholeOne) {
  const CutShape part = cut(*reference, down, 1.0 / 3);
  for (const int coverage_levels : {0, 2}) {
    ExperimentOptions o = options();
    o.coverage.levels = coverage_levels;
    const MatchResult<3> fitted = match_shapes(part.shape, *other, o, quiet);
    EXPECT_LT(difference(part.kept, [&](std::size_t i) { return fitted.deformed.vertices[i]; }), 0.008);
    EXPECT_EQ(fitted.summary.verdict->outcome, "matched") << verdict_lines(fitted.summary).back();
    const VertexAttribute* observed = column(fitted.template_shape, "deformed_observed");
    ASSERT_NE(observed, nullptr);
    const double share =
        static_cast<double>(std::ranges::count(observed->values, 1.0)) / static_cast<double>(observed->values.size());
    EXPECT_NEAR(share, 2.0 / 3, 0.1);
  }
}

// A result that is used as a reference has the columns of its own matching only.
TEST_F(Partial, ColumnsOfAnEarlierMatchingGo) {
  Shape<3> used = *reference, seen = *other;
  const auto zeros = [](const Shape<3>& s, const char* name) {
    return VertexAttribute{name, "uchar", std::vector<double>(s.original.vertices.size(), 0)};
  };
  used.original.attributes.push_back(zeros(used, "template_observed"));
  seen.original.attributes.push_back(zeros(seen, "deformed_observed"));
  ExperimentOptions o = options();
  o.cascade.max_level = 3;
  const MatchResult<3> r = match_shapes(used, seen, o, quiet);
  EXPECT_EQ(column(r.deformed, "template_observed"), nullptr);
  EXPECT_EQ(column(r.template_shape, "deformed_observed"), nullptr);
}

// Either shape may be the part, and a turn of either is found.
TEST_F(Partial, ThePoseOfAPartIsSearched) {
  const ExperimentOptions o = search_options();
  const Shape<3> sideways = Partial::sideways(1);
  const Shape<3> part = cut(*other, down, 1.0 / 3).shape;
  ShapePair<3> shapes{sideways, part};
  EXPECT_TRUE(shapes.one_is_part());
  Notes notes, back;
  const AlignmentSummary onto_whole = *align_shapes<3>({part, sideways}, {}, o, back).summary;
  EXPECT_NE(back.all.find("searched as a part"), std::string::npos) << back.all;
  EXPECT_NEAR(onto_whole.angle, 90, 10) << back.all;
  EXPECT_GT(onto_whole.n_pairs, 100);
  // What was cut off where it is thin leaves small gaps. The search of wholes finds nothing that is clear then.
  shapes.template_shape.invented_share = 0.01;
  EXPECT_FALSE(shapes.one_is_part());
  const MatchResult<3> thin = match_shapes(sideways, shapes.template_shape, o, notes);
  const AlignmentSummary& onto_part = *thin.summary.alignment;
  EXPECT_TRUE(onto_part.is_of_part.value_or(false)) << notes.all;
  EXPECT_NEAR(onto_part.angle, 90, 10) << notes.all;
  EXPECT_EQ(onto_part.scale, 1);
  EXPECT_EQ(onto_part.n_pairs, onto_whole.n_pairs);
  EXPECT_TRUE(thin.summary.template_shape.may_be_part());
  EXPECT_FALSE(thin.summary.reference.may_be_part());
  shapes.template_shape.invented_share = 0.001;
  EXPECT_FALSE(align_shapes<3>(shapes, {}, o, notes).summary->is_of_part.has_value());
}

// In inches it is a part of nothing: what was made up is large, and the search of wholes is clear all the same.
TEST_F(Partial, AWholeWithAHoleMayBeInAnotherUnit) {
  const Shape<3> holed = cut(*other, down, 0.05).shape;
  ASSERT_GT(holed.invented_share, least_of_part);
  Notes notes;
  const double inch = 25.4;
  const Alignment<3> found = align_shapes<3>({sideways(inch), holed}, {}, search_options(), notes);
  EXPECT_FALSE(found.summary->is_of_part.has_value()) << notes.all;
  EXPECT_NEAR(found.summary->angle, 90, 10) << notes.all;
  EXPECT_NEAR(found.summary->scale * inch, 1, 0.1);
  EXPECT_GT(found.pairs.size(), 100u);
  const ObservedPart<3> observed(holed.evidence);
  for (const Landmark<3>& pair : found.pairs) EXPECT_TRUE(observed.contains(pair.on_template)) << pair.name;
}

TEST_F(Partial, TheDirectionIsChosenByThePartAlone) {
  // Of two balls the part has one, and that without a cap. The other is not reached in either direction.
  const Shape<3> ball = std::get<Shape<3>>(open_shape("generate:sphere"));
  OriginalShape<3> balls = ball.original;
  const auto n = static_cast<Index>(balls.vertices.size());
  const double apart = 1.5 * bounding_box(balls.vertices).diagonal();
  for (Index v = 0; v < n; ++v) balls.vertices.push_back(balls.vertices[v] + Vec<3>(apart, 0, 0));
  for (std::vector<Index> polygon : ball.original.polygons) {
    for (Index& v : polygon) v += n;
    balls.polygons.push_back(std::move(polygon));
  }
  const Shape<3> whole_shape = make_shape(std::move(balls), "two balls");
  const CutShape part = cut(ball, down, 0.1);
  const auto distance = [&](const Shape<3>& deformed, const Shape<3>& other_shape, Carried carried) {
    const ShapePair<3> pair{deformed, other_shape};
    return Trials<3>(pair, {}, options(), quiet).of_direction({}, carried).distance;
  };
  EXPECT_LT(distance(part.shape, whole_shape, Carried::reference), 0.01);
  EXPECT_LT(distance(part.shape, whole_shape, Carried::template_shape), 0.01);
}

}  // namespace
}  // namespace shellmatch
