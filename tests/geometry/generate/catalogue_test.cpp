// Every shape and variant of the catalogue: closed, outward, of the promised genus, in the domain, without
// self-intersections, with good triangles, and the same bits twice.
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/surface/self_intersections.h"
#include "geometry/implicit/mesh_implicit.h"
#include "geometry/generate/generate_shape.h"
#include "tests/geometry/generate/generated_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

struct Entry {
  GeneratorInfo info;
  GeneratorVariant variant;
};

std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (const GeneratorInfo& info : generator_catalogue())
    for (const GeneratorVariant& v : info.variants) all.push_back({info, v});
  return all;
}

class EveryShape : public testing::TestWithParam<Entry> {};

double smallest_angle(const Surface<3>& s, Index f) {
  double least = M_PI;
  for (int k = 0; k < 3; ++k) {
    const Vec<3>& a = s.vertices[s.facets[f][k]];
    const Vec<3> u = s.vertices[s.facets[f][(k + 1) % 3]] - a, v = s.vertices[s.facets[f][(k + 2) % 3]] - a;
    least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return least * 180 / M_PI;
}

TEST_P(EveryShape, IsClosedOutwardAndSound) {
  const auto& [info, variant] = GetParam();
  const AnyOriginal shape = generate_shape(info.name, variant.name);
  if (info.dimension == 3) {
    const Surface<3> s = as_surface(std::get<OriginalShape<3>>(shape));
    EXPECT_TRUE(is_closed_manifold(s));
    const auto euler = static_cast<int>(s.vertices.size()) - static_cast<int>(s.facets.size()) / 2;
    EXPECT_EQ(euler, 2 - 2 * info.genus);
    EXPECT_GT(enclosed_measure(s), 0.005);
    EXPECT_EQ(self_intersecting_facets(s).empty(), variant.name != "clasped");
    std::size_t thin = 0;
    for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) {
      const double angle = smallest_angle(s, f);
      EXPECT_GT(angle, 5);
      thin += angle < 20;
    }
    EXPECT_LT(thin, 0.01 * s.facets.size());
    EXPECT_GT(s.vertices.size(), 4000u);
    EXPECT_LT(s.vertices.size(), 24000u);
  } else {
    const Surface<2> s = as_surface(std::get<OriginalShape<2>>(shape));
    EXPECT_GT(enclosed_measure(s), 0.05);
    EXPECT_TRUE(self_intersecting_facets(s).empty());
    for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f)
      EXPECT_GT(facet_measure(s, f), 0.5 * info.edge_length);
  }
  std::visit(
      [](const auto& original) {
        const auto box = bounding_box(original.vertices);
        EXPECT_GE(box.min.minCoeff(), 0.08);
        EXPECT_LE(box.max.maxCoeff(), 0.92);
      },
      shape);
}

TEST_P(EveryShape, IsTheSameTwiceWhateverTheNumberOfThreads) {
  const auto& [info, variant] = GetParam();
  const double edge = 1.8 * info.edge_length;
  set_n_threads(1);
  const AnyOriginal one = generate_shape(info.name, variant.name, edge);
  set_n_threads(2);
  const AnyOriginal two = generate_shape(info.name, variant.name, edge);
  set_n_threads(0);
  std::visit(
      [&](const auto& a) {
        const auto& b = std::get<std::decay_t<decltype(a)>>(two);
        EXPECT_TRUE(a.vertices == b.vertices);
        EXPECT_EQ(a.polygons, b.polygons);
      },
      one);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryShape, testing::ValuesIn(entries()),
                         [](const auto& named) { return named.param.info.name + "_" + named.param.variant.name; });

TEST(Catalogue, DefaultsLieInTheirRanges) {
  for (const Entry& e : entries())
    for (const GeneratorParameter& p : e.info.parameters) {
      EXPECT_TRUE(in_range(e.variant.values.at(p.name), p.info)) << e.info.name << ' ' << p.name;
      EXPECT_FALSE(p.info.meaning.empty());
    }
}

std::string message_of(const char* name, const char* variant, double edge, const GeneratorParameters& parameters) {
  try {
    generate_shape(name, variant, edge, parameters);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Catalogue, BadInputIsNamedWithTheNearestSpelling) {
  const auto expect_words = [](const std::string& message, std::initializer_list<const char*> words) {
    for (const char* w : words) EXPECT_NE(message.find(w), std::string::npos) << w << " in: " << message;
  };
  expect_words(message_of("dolfin", "", 0, {}), {"dolfin", "did you mean 'dolphin'", "sphere", "leaf"});
  expect_words(message_of("hand", "bnet", 0, {}), {"bnet", "did you mean 'bent'", "rest"});
  expect_words(message_of("sphere", "", 0, {{"raduis", 0.2}}), {"sphere", "raduis", "did you mean 'radius'"});
  expect_words(message_of("sphere", "", 0, {{"radius", 0.7}}), {"radius", "0.7", "0.02 <= x <= 0.4"});
  expect_words(message_of("sphere", "", 0, {{"radius", NAN}}), {"radius", "range"});
  expect_words(message_of("star", "", 0, {{"points", 4.5}}), {"points", "whole number"});
  expect_words(message_of("circle", "", -1, {}), {"edge length", "0.003"});
  expect_words(message_of("torus", "", 0, {{"major_radius", 0.1}, {"minor_radius", 0.2}}), {"minor_radius", "0.95"});
  expect_words(message_of("box", "", 0, {{"rounding", 0.4}}), {"rounding", "smaller"});
  expect_words(message_of("box", "", 0.02, {{"side_x", 0.8}, {"side_y", 0.8}, {"turn", 45}}), {"leaves", "0.95"});
}

}  // namespace
}  // namespace shellmatch
