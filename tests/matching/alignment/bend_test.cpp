// Tongs whose ends nearly touch, onto open ones: no map of space on coarse cells sets them apart.
#include "geometry/repair/make_shape.h"
#include "matching/alignment/prepare_pair.h"
#include "matching/level/deformation.h"
#include "matching/match_placed_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace shellmatch {
namespace {

constexpr double tube_length = 6, tube_radius = 0.15;
constexpr Index n_rings = 60, n_around = 16;

enum class Hole { none, slit };

bool in_slit(Index ring, Index around) { return ring >= 20 && ring < 40 && around < n_around / 2; }

/// A tube whose middle line is part of a circle of this curvature, or straight. \param prong length of a thorn at the
/// middle, on the outer side
Shape<3> tube(double curvature, Hole hole = Hole::none, double prong = 0) {
  const auto middle = [&](double s) {
    return curvature > 0 ? Vec<3>(std::sin(curvature * s) / curvature, (1 - std::cos(curvature * s)) / curvature, 0)
                         : Vec<3>(s, 0, 0);
  };
  const auto out = [&](double s) { return Vec<3>(std::sin(curvature * s), -std::cos(curvature * s), 0); };
  OriginalShape<3> shape;
  for (Index i = 0; i < n_rings; ++i) {
    const double s = tube_length * (i / (n_rings - 1.0) - 0.5);
    for (Index k = 0; k < n_around; ++k) {
      const double angle = 2 * std::numbers::pi * k / n_around;
      const Vec<3> side = std::cos(angle) * out(s) + std::sin(angle) * Vec<3>::UnitZ();
      const double to_prong = std::hypot(s, tube_radius * (side - out(0)).norm());
      shape.vertices.push_back(middle(s) + tube_radius * side + prong * std::max(0.0, 1 - to_prong / 0.3) * out(s));
    }
  }
  for (const double end : {-0.5, 0.5}) shape.vertices.push_back(middle(end * tube_length));
  const auto at = [](Index i, Index k) { return i * n_around + k % n_around; };
  const Index first = n_rings * n_around, last = first + 1;
  for (Index k = 0; k < n_around; ++k) {
    for (Index i = 0; i + 1 < n_rings; ++i) {
      if (hole == Hole::slit && in_slit(i, k)) continue;
      shape.polygons.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      shape.polygons.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
    shape.polygons.push_back({first, at(0, k + 1), at(0, k)});
    shape.polygons.push_back({last, at(n_rings - 1, k), at(n_rings - 1, k + 1)});
  }
  return make_shape(std::move(shape), "tube", {}, Closing::automatic);
}

/// As if a search had found these pairs.
AlignmentFindings<3> found(const ShapePair<3>& shapes) {
  Start<3> start;
  const auto &x = shapes.reference.original.vertices, &y = shapes.template_shape.original.vertices;
  for (std::size_t v = 0; v < x.size(); v += 7) start.alignment.pairs.push_back({pair_name(v), x[v], y[v]});
  start.n_pairs = start.alignment.pairs.size();
  start.score = 0.3;
  start.order = 0.05;
  AlignmentFindings<3> findings;
  findings.by_pairs.results.push_back({{start}, 2});
  return findings;
}

struct Matched {
  PreparedPair<3> prepared;
  MatchResult<3> result;
  double error = 0;  ///< mean, in lengths of the tube
  std::string notes = {};
};

Matched match(BendMode bend, const std::vector<Landmark<3>>& landmarks = {}) {
  ExperimentOptions options = profile_defaults(Profile::standard);
  options.cascade.max_level = 5;
  options.align.bend = bend;
  MatchInputs<3> inputs;
  inputs.shapes = {tube(1.04), tube(0)};
  inputs.landmarks = landmarks;
  const std::vector<Vec<3>> truth = inputs.shapes.template_shape.original.vertices;
  struct : Observer {
    std::string notes;
    void note(const std::string& text) override { notes += text + "\n"; }
  } listener;
  AlignmentFindings<3> findings = found(inputs.shapes);
  inputs.prepared = prepare_pair(inputs.shapes, inputs.landmarks, options, listener, findings);
  PreparedPair<3> prepared = inputs.prepared;
  Recorder recorder(listener);
  RunClock clock;
  Matched m{std::move(prepared), match_placed_shapes(std::move(inputs), options, recorder, clock)};
  m.notes = listener.notes;
  for (std::size_t v = 0; v < truth.size(); ++v)
    m.error += (m.result.deformed.vertices[v] - truth[v]).norm() / tube_length / static_cast<double>(truth.size());
  return m;
}

TEST(Bend, EndsThatNearlyTouchMoveApart) {
  const Matched bent = match(BendMode::automatic), space = match(BendMode::never);
  ASSERT_TRUE(bent.prepared.alignment.bend);
  EXPECT_TRUE(bent.result.summary.bent);
  EXPECT_FALSE(space.prepared.alignment.bend);
  EXPECT_FALSE(space.result.summary.bent);
  EXPECT_NE(bent.notes.find("bend: "), std::string::npos) << bent.notes;
  EXPECT_EQ(bent.notes.find("direction: "), std::string::npos) << "neither that was tried is taken: " << bent.notes;
  EXPECT_EQ(space.notes.find("bend: "), std::string::npos) << space.notes;
  EXPECT_NE(space.notes.find("direction: "), std::string::npos) << space.notes;
  EXPECT_LT(bent.error, 0.01);
  EXPECT_GT(space.error, 1.5 * bent.error);
  EXPECT_EQ(bent.result.summary.levels.back().folds.n_folded_cells, 0);
}

TEST(Bend, AWholeIsBentOntoAPart) {
  ShapePair<3> shapes{tube(1.04), tube(0, Hole::slit)};
  ASSERT_TRUE(shapes.one_is_part());
  AlignmentFindings<3> findings = found(shapes);
  StartSearch<3>& search = findings.by_pairs.results[0];
  search.is_of_part = true;
  std::erase_if(search.starts[0].alignment.pairs, [](const Landmark<3>& pair) {
    const auto v = static_cast<Index>(std::stoi(pair.name.substr(pair.name.find(' ') + 1))) - 1;
    return in_slit(v / n_around, v % n_around);
  });
  Observer quiet;
  const PreparedPair<3> prepared = prepare_pair(shapes, {}, profile_defaults(Profile::standard), quiet, findings);
  EXPECT_TRUE(prepared.alignment.bend);
}

TEST(Bend, TheMapCarriesTheReferenceAsItWasRead) {
  const Matched m = match(BendMode::automatic);
  const std::vector<Vec<3>> reference = tube(1.04).original.vertices;
  ASSERT_TRUE(m.result.map.bend);
  for (std::size_t v = 0; v < reference.size(); ++v) {
    const Vec<3> y = m.result.map.apply(reference[v]);
    EXPECT_LT((y - m.result.deformed.vertices[v]).norm(), 1e-9) << v;
    const auto x = PointMap<3>(m.result.map, Toward::reference)(y);
    ASSERT_TRUE(x) << v;
    EXPECT_LT((*x - reference[v]).norm(), 1e-6) << v;
  }
  // What is measured and shown compares with the reference as it was.
  const auto& shown = m.result.surfaces.reference.vertices;
  EXPECT_LT((shown.front() - shown[shown.size() - 3]).norm(),
            (reference.front() - reference[reference.size() - 3]).norm());
  EXPECT_GT(m.result.summary.distance_before->deformed_to_template.mean, 0.1);
}

TEST(Bend, WhereShapesLieNearPairsThatEndElsewhereAreWrongAndNotMissed) {
  const auto missed = [](const ShapePair<3>& shapes) {
    // A third of the map is four rings off.
    Alignment<3> alignment = found(shapes).by_pairs.results[0].starts[0].alignment;
    for (std::size_t i = alignment.pairs.size() / 3; i < alignment.pairs.size() * 2 / 3; ++i)
      alignment.pairs[i].on_template = shapes.template_shape.original.vertices[7 * i + 4 * n_around];
    const ExperimentOptions options = profile_defaults(Profile::standard);
    Observer quiet;
    return Trials<3>(shapes, {}, options, quiet).of_direction(alignment, Carried::reference).missed;
  };
  EXPECT_EQ(missed({tube(0.2), tube(0.22)}), 0);
  EXPECT_GT(missed({tube(1.04), tube(0)}), 0.1);
}

TEST(Bend, WhereEndsOfLimbsDoNotArriveThoughNoPairIsMissed) {
  ShapePair<3> shapes{tube(1.04, Hole::none, 1), tube(0, Hole::none, 1)};
  AlignmentFindings<3> findings = found(shapes);
  Alignment<3>& alignment = findings.by_pairs.results[0].starts[0].alignment;
  // Ends that touch something have no pairs.
  std::erase_if(alignment.pairs, [](const Landmark<3>& pair) {
    const auto v = static_cast<Index>(std::stoi(pair.name.substr(pair.name.find(' ') + 1))) - 1;
    return v < 20 * n_around || v >= 40 * n_around;
  });
  const ExperimentOptions options = profile_defaults(Profile::standard);
  Observer quiet;
  const Trials<3> trials(shapes, {}, options, quiet);
  const Alignment<3> bent = bent_start(alignment, shapes.reference.surface, {});
  EXPECT_EQ(trials.of_direction(alignment, Carried::reference).missed, 0);
  EXPECT_GT(trials.of_direction(alignment, Carried::reference).limb_disorder, 0.5);
  EXPECT_LT(trials.of_direction(bent, Carried::reference).limb_disorder, 0.1);
  EXPECT_TRUE(prepare_pair(shapes, {}, options, quiet, findings).alignment.bend);
}

TEST(Bend, LandmarksBelongToTheReferenceAsItWasRead) {
  const auto x = tube(1.04).original.vertices, y = tube(0).original.vertices;
  const Matched m = match(BendMode::automatic, {{"start", x[5], y[5]}, {"end", x[900], y[900]}});
  ASSERT_TRUE(m.result.map.bend);
  ASSERT_TRUE(m.result.summary.landmarks);
  EXPECT_LT(m.result.summary.landmarks->max, 0.01);
}

}  // namespace
}  // namespace shellmatch
