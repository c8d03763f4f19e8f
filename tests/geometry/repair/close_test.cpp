// Surfaces that are not closed: holes, inner walls, sheets.

#include "geometry/repair/close_surface.h"
#include "geometry/repair/repair.h"
#include "tests/geometry/surface/test_surfaces.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

using namespace test;

OriginalShape<3> original_of(const Surface<3>& surface) {
  OriginalShape<3> shape;
  shape.vertices = surface.vertices;
  for (const auto& [a, b, c] : surface.facets) shape.polygons.push_back({a, b, c});
  return shape;
}

// Without the facets whose centre lies above z = height.
Surface<3> cut_at(Surface<3> surface, double height) {
  std::erase_if(surface.facets, [&](const std::array<Index, 3>& f) {
    double z = 0;
    for (const Index v : f) z += surface.vertices[v].z() / 3;
    return z > height;
  });
  return surface;
}

MendedSurface mended(const Surface<3>& surface, std::vector<std::string>& notes, Closing closing = Closing::automatic) {
  return mend_surface(original_of(surface), "thing", notes, closing);
}

bool has_note(const std::vector<std::string>& notes, const std::string& part) {
  for (const std::string& note : notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

double area_of(const Surface<3>& surface) {
  double area = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) area += facet_measure(surface, static_cast<Index>(f));
  return area;
}

TEST(CloseSurface, ClosedOnesStayAsTheyAre) {
  std::vector<std::string> notes, strict_notes;
  const MendedSurface ball = mended(unit_sphere(3), notes),
                      strict = mended(unit_sphere(3), strict_notes, Closing::never);
  EXPECT_EQ(ball.surface.facets, strict.surface.facets);
  EXPECT_EQ(ball.invented_share, 0);
  EXPECT_TRUE(ball.evidence.is_complete());
  EXPECT_EQ(notes, strict_notes);
}

TEST(CloseSurface, AHoleIsFilledFlatAndSaid) {
  const double height = 0.9;
  const Surface<3> open = cut_at(unit_sphere(4), height);
  std::vector<std::string> notes;
  const MendedSurface ball = mended(open, notes);
  // Ball and cap without the slice above; area of the disc over that of both.
  const double pi = std::acos(-1.0), cap = pi / 3 * (1 - height) * (1 - height) * (2 + height),
               disc = pi * (1 - height * height);
  EXPECT_NEAR(enclosed_measure(ball.surface), 4 * pi / 3 - cap, 0.05);
  EXPECT_NEAR(ball.invented_share, disc / (disc + 2 * pi * (1 + height)), 0.01);
  EXPECT_TRUE(has_note(notes, "1 hole filled with ")) << notes.back();
  EXPECT_TRUE(has_note(notes, "that part is made up"));
  // The patch alone is invented: the disc.
  EXPECT_EQ(ball.evidence.observed.facets.size(), open.facets.size());
  EXPECT_NEAR(area_of(ball.evidence.unobserved), disc, 0.02);
  for (const Vec<3>& x : ball.evidence.unobserved.vertices) EXPECT_NEAR(x.z(), height, 0.06);
  // What was there keeps its triangles.
  for (std::size_t f = 0; f < 3; ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(ball.surface.vertices[ball.surface.facets[f][k]], open.vertices[open.facets[f][k]]);
}

TEST(CloseSurface, StrictRefusesIt) {
  std::vector<std::string> notes;
  expect_input_error([&] { mended(cut_at(unit_sphere(3), 0.5), notes, Closing::never); },
                     {"thing", "the surface is open", "1 loop"});
}

TEST(CloseSurface, TwoBoxesThatShareAnEdgeAreTakenApart) {
  Surface<3> boxes = joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
  std::vector<std::string> notes;
  // Their common edge as one: four triangles at it.
  for (auto& facet : boxes.facets)
    for (Index& v : facet)
      for (Index w = 0; w < v; ++w)
        if (boxes.vertices[w] == boxes.vertices[v]) {
          v = w;
          break;
        }
  expect_input_error([&] { mended(boxes, notes, Closing::never); }, {"not manifold"});
  notes.clear();
  const MendedSurface two = mended(boxes, notes);
  EXPECT_NEAR(enclosed_measure(two.surface), 2, 0.2);
}

// Every triangle by itself, shrunk towards its centre.
Surface<3> shrunk_triangles(const Surface<3>& surface, double factor) {
  Surface<3> soup;
  for (const auto& facet : surface.facets) {
    Vec<3> centre = Vec<3>::Zero();
    for (const Index v : facet) centre += surface.vertices[v] / 3;
    std::array<Index, 3>& own = soup.facets.emplace_back();
    for (int k = 0; k < 3; ++k) {
      own[k] = static_cast<Index>(soup.vertices.size());
      soup.vertices.emplace_back(centre + factor * (surface.vertices[facet[k]] - centre));
    }
  }
  return soup;
}

TEST(CloseSurface, ManyGapsAreWrapped) {
  const Surface<3> ball = unit_sphere(4), soup = shrunk_triangles(ball, 0.9);
  std::vector<std::string> notes;
  const MendedSurface wrap = mended(soup, notes);
  EXPECT_TRUE(has_note(notes, "not closed, and wrapped")) << notes.front();
  EXPECT_NEAR(enclosed_measure(wrap.surface), enclosed_measure(ball), 0.1);
  // Gaps of 0.004 are hardly wider than the wrap is far from the triangles.
  EXPECT_LT(wrap.invented_share, 0.01);
}

TEST(CloseSurface, WhatAWrapBridgesIsInvented) {
  const Surface<3> soup = shrunk_triangles(unit_sphere(4), 0.6);
  std::vector<std::string> notes;
  const MendedSurface wrap = mended(soup, notes);
  EXPECT_NEAR(area_of(wrap.evidence.observed) / area_of(unit_sphere(4)), 0.36, 1e-12);
  // Triangles have an inscribed radius of 0.0217, and the wrap counts as theirs up to 0.0042 beside them: 1 - (0.6 +
  // 0.19)^2.
  EXPECT_NEAR(wrap.invented_share, 0.38, 0.08);
  EXPECT_NEAR(area_of(wrap.evidence.unobserved) / area_of(wrap.surface), wrap.invented_share, 1e-12);
}

// Three bands around the unit sphere, each as wide as twice `half`: eight holes.
Surface<3> banded_sphere(double half) {
  Surface<3> surface = unit_sphere(4);
  std::erase_if(surface.facets, [&](const std::array<Index, 3>& f) {
    const Vec<3> centre = (surface.vertices[f[0]] + surface.vertices[f[1]] + surface.vertices[f[2]]) / 3;
    return centre.cwiseAbs().minCoeff() > half;
  });
  return surface;
}

TEST(CloseSurface, OfALaceMostIsMadeUp) {
  const Surface<3> lace = banded_sphere(0.12);
  std::vector<std::string> notes;
  const MendedSurface body = mended(lace, notes);
  EXPECT_TRUE(has_note(notes, "8 holes filled")) << notes.front();
  EXPECT_NEAR(area_of(body.evidence.observed), area_of(lace), 1e-9);
  EXPECT_NEAR(body.invented_share, 1 - area_of(lace) / area_of(body.surface), 1e-9);
  EXPECT_GT(body.invented_share, 0.5);
  EXPECT_GT(enclosed_measure(body.surface), 0.5 * enclosed_measure(unit_sphere(4)));
}

// A dish as deep as a tenth of its width encloses something, one as deep as a hundredth does not.
TEST(CloseSurface, ADishIsClosedByALid) {
  for (const double depth : {0.1, 0.01}) {
    Surface<3> dish = cut_at(unit_sphere(4), -0.9);
    const double width = 2 * std::sqrt(1 - 0.9 * 0.9);
    for (Vec<3>& x : dish.vertices) x.z() *= depth * width / 0.1;
    std::vector<std::string> notes;
    if (depth < 0.05) {
      expect_input_error([&] { mended(dish, notes); }, {"thing", "the surface is open", "encloses next to nothing"});
      continue;
    }
    const MendedSurface closed = mended(dish, notes);
    EXPECT_TRUE(has_note(notes, "1 hole filled"));
    EXPECT_NEAR(closed.invented_share, 0.5, 0.05);
  }
}

TEST(CloseSurface, AHoleOfThousandsOfEdgesIsFilled) {
  constexpr Index n = 2400;
  Surface<3> cup;
  for (const double z : {0.0, 3.0})
    for (Index k = 0; k < n; ++k)
      cup.vertices.emplace_back(std::cos(2 * std::numbers::pi * k / n), std::sin(2 * std::numbers::pi * k / n), z);
  cup.vertices.emplace_back(0, 0, 0);
  for (Index k = 0; k < n; ++k) {
    const Index next = (k + 1) % n;
    cup.facets.insert(cup.facets.end(), {{k, next, n + next}, {k, n + next, n + k}, {next, k, 2 * n}});
  }
  std::vector<std::string> notes;
  const MendedSurface closed = mended(cup, notes);
  EXPECT_TRUE(has_note(notes, "1 hole filled with 2398 triangles"));
  EXPECT_NEAR(enclosed_measure(closed.surface), 3 * std::numbers::pi, 1e-3);
}

TEST(CloseSurface, WiderGapsAreBridgedWhereNarrowOnesLeaveNothing) {
  std::vector<std::string> notes;
  const MendedSurface wrap = mended(shrunk_triangles(unit_sphere(1), 0.7), notes);
  EXPECT_TRUE(has_note(notes, "not closed, and wrapped")) << notes.front();
  EXPECT_TRUE(has_note(notes, "bridges gaps up to 0.2")) << notes.front();
  EXPECT_GT(enclosed_measure(wrap.surface), 0.7 * enclosed_measure(unit_sphere(1)));
}

TEST(CloseSurface, ALooseTriangleIsLeftOutAndNothingIsMadeUp) {
  Surface<3> surface = unit_sphere(3);
  const auto n = static_cast<Index>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
  surface.facets.push_back({n, n + 1, n + 2});
  std::vector<std::string> notes;
  const MendedSurface ball = mended(surface, notes);
  EXPECT_EQ(ball.surface.facets.size(), unit_sphere(3).facets.size());
  EXPECT_EQ(ball.invented_share, 0);
  EXPECT_TRUE(ball.evidence.is_complete());
  EXPECT_TRUE(has_note(notes, "1 loose triangle left out"));
}

TEST(CloseSurface, FlatTrianglesAloneAreRefused) {
  Surface<3> flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  flat.facets = {{0, 1, 2}, {1, 2, 3}};
  EXPECT_TRUE(wrapped(flat, 0.1, 0.01).facets.empty());
  std::vector<std::string> notes;
  expect_input_error([&] { mended(flat, notes); }, {"thing", "the surface is open"});
}

TEST(CloseSurface, ASheetEnclosesNothing) {
  Surface<3> sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  sheet.facets = {{0, 1, 2}, {0, 2, 3}};
  std::vector<std::string> notes;
  expect_input_error([&] { mended(sheet, notes); }, {"thing", "the surface is open", "encloses next to nothing"});
}

}  // namespace
}  // namespace shellmatch
