// Surfaces that are not closed: holes, inner walls, sheets.

#include "geometry/repair/close_surface.h"
#include "geometry/repair/repair.h"
#include "tests/geometry/surface/test_surfaces.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <cmath>

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
  const MendedSurface ball = mended(unit_sphere(3), notes), strict = mended(unit_sphere(3), strict_notes, Closing::never);
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
  const double pi = std::acos(-1.0), cap = pi / 3 * (1 - height) * (1 - height) * (2 + height), disc = pi * (1 - height * height);
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
    for (int k = 0; k < 3; ++k) EXPECT_EQ(ball.surface.vertices[ball.surface.facets[f][k]], open.vertices[open.facets[f][k]]);
}

TEST(CloseSurface, StrictRefusesIt) {
  std::vector<std::string> notes;
  expect_input_error([&] { mended(cut_at(unit_sphere(3), 0.5), notes, Closing::never); }, {"thing", "the surface is open", "1 loop"});
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
  // Triangles have an inscribed radius of 0.0217, and the wrap counts as theirs up to 0.0042 beside them: 1 - (0.6 + 0.19)^2.
  EXPECT_NEAR(wrap.invented_share, 0.38, 0.08);
  EXPECT_NEAR(area_of(wrap.evidence.unobserved) / area_of(wrap.surface), wrap.invented_share, 1e-12);
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
