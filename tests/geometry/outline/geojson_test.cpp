// GeoJSON as QuPath exports it and as RFC 7946 defines it: holes, parts, names, classes, and which way y points.
#include "tests/geometry/outline/outline_files.h"

namespace shellmatch::testing {
namespace {

const std::string outer_ring = "[[0,0],[9,0],[9,9],[0,9],[0,0]]", inner_ring = "[[3,3],[3,6],[6,6],[6,3],[3,3]]",
                  ring_apart = "[[20,1],[24,1],[24,5.5],[20,1]]";

std::string polygon_of(const std::string& rings) { return R"({"type":"Polygon","coordinates":[)" + rings + "]}"; }
std::string feature(const std::string& geometry, const std::string& properties, const std::string& id = "") {
  return R"({"type":"Feature",)" + (id.empty() ? "" : R"("id":")" + id + "\",") + R"("geometry":)" + geometry +
         R"(,"properties":{)" + properties + "}}";
}
std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

class GeoJson : public ::testing::Test {
 protected:
  Shape<2> read(const std::string& text, const std::string& part = "") const {
    return read_outline(folder_.write("cells.geojson", text) + part);
  }
  std::string error(const std::string& text, const std::string& part = "") const {
    return input_error_of([&] { read(text, part); });
  }
  TempFolder folder_;
};

TEST_F(GeoJson, YPointsUpUnlessQuPathWroteIt) {
  const std::string drawn = feature(polygon_of("[[0,0],[9,0],[9,4],[0,0]]"), "\"name\":\"a\"");
  const Shape<2> map = read(drawn);
  EXPECT_EQ(ring(map), (Points{{0, 0}, {9, 0}, {9, 4}}));
  EXPECT_TRUE(has_note(map, "without QuPath's objectType: y points up"));
  for (const std::string& pixels : {feature(polygon_of("[[0,0],[9,0],[9,4],[0,0]]"), R"("objectType":"annotation")"),
                                    feature(polygon_of("[[0,0],[9,0],[9,4],[0,0]]"), "", "PathAnnotationObject")}) {
    const Shape<2> shape = read(pixels);
    EXPECT_EQ(ring(shape), (Points{{0, 0}, {9, 0}, {9, -4}}));
    EXPECT_TRUE(has_note(shape, "GeoJSON of QuPath"));
    EXPECT_TRUE(has_note(shape, "y = -y"));
  }
}

TEST_F(GeoJson, MayEndInJsonButForPointsOfSlicer) {
  EXPECT_DOUBLE_EQ(area(read_outline(folder_.write("a.json", polygon_of(outer_ring))).surface), 81);
  EXPECT_TRUE(contains(input_error_of([&] { read_outline(folder_.write("a.mrk.json", "{}")); }),
                       "the format '.json' is not supported"));
}

TEST_F(GeoJson, PolygonsHaveHolesAndParts) {
  EXPECT_DOUBLE_EQ(area(read(polygon_of(outer_ring + "," + inner_ring)).surface), 72);
  const Shape<2> parts =
      read(R"({"type":"GeometryCollection","geometries":[{"type":"MultiPolygon","coordinates":[[)" + outer_ring + "," +
           inner_ring + "],[" + ring_apart + R"(]]},{"type":"Point","coordinates":[0,0]}]})");
  EXPECT_DOUBLE_EQ(area(parts.surface), 81);
  EXPECT_EQ(parts.original.polygons.size(), 3u);
  EXPECT_TRUE(has_note(parts, "1 geometry without area left out"));
  EXPECT_EQ(ring(read(polygon_of("[[1,2,300],[4,2,300],[4,6,300],[1,2,300]]"))).at(1), Vec<2>(4, 2));
}

TEST_F(GeoJson, NamesIdsAndClassesChoose) {
  const std::string tumour = R"("objectType":"annotation","classification":{"name":"Tumour"})";
  const std::string text =
      collection(feature(polygon_of(outer_ring), R"("name":"left",)" + tumour, "11-aa") + "," +
                 feature(polygon_of(ring_apart), tumour, "22-bb") + "," +
                 feature(polygon_of("[[50,0],[52,0],[52,2],[50,2]]"), R"("objectType":"cell","name":"right")", "33") +
                 "," + feature("null", R"("objectType":"tile")"));
  EXPECT_DOUBLE_EQ(area(read(text, ":left").surface), 81);
  EXPECT_DOUBLE_EQ(area(read(text, ":22-bb").surface), 9);
  EXPECT_DOUBLE_EQ(area(read(text, ":33").surface), 4);
  EXPECT_DOUBLE_EQ(area(read(text, ":Tumour").surface), 90);
  const Shape<2> all = read(text);
  EXPECT_DOUBLE_EQ(area(all.surface), 94);
  EXPECT_TRUE(has_note(all, "3 areas taken together: 'left', '22-bb', 'right'; FILE:NAME chooses")) << notes_of(all);
  EXPECT_TRUE(has_note(all, "1 object without geometry"));
  EXPECT_TRUE(contains(error(text, ":Stroma"), "no area is named 'Stroma'; choose one of 'left'"));
  // As a list, which older versions of QuPath write; of a cell with its nucleus the cell counts.
  std::string cell = feature(polygon_of(outer_ring), R"("objectType":"cell")");
  cell.insert(1, R"("nucleusGeometry":)" + polygon_of(inner_ring) + ",");
  const Shape<2> list = read("[" + cell + "]");
  EXPECT_DOUBLE_EQ(area(list.surface), 81);
  EXPECT_TRUE(has_note(list, "1 nucleus of cells left out"));
}

TEST_F(GeoJson, WhatIsWrongIsSaidOnce) {
  EXPECT_TRUE(contains(error("{\"type\":"), "no JSON"));
  EXPECT_TRUE(contains(error("{}"), "an object without 'type'; expected a FeatureCollection"));
  EXPECT_TRUE(contains(error("[1]"), "feature 1: is no Feature"));
  EXPECT_TRUE(contains(error(R"({"type":"Circle"})"), "the type 'Circle' is unknown"));
  EXPECT_TRUE(contains(error(collection(feature(R"({"type":"Polygon"})", ""))),
                       "feature 1: a Polygon has no list 'coordinates'"));
  EXPECT_TRUE(contains(error(polygon_of("[[0,0],[1]]")), "position 2 of a ring is no list of two numbers"));
  EXPECT_TRUE(contains(error(polygon_of("3")), "a ring is no list"));
  EXPECT_TRUE(contains(error(R"({"type":"MultiPolygon","coordinates":[1]})"), "a polygon is no list of rings"));
  EXPECT_TRUE(
      contains(error(R"({"type":"Point","coordinates":[1,2]})"), "no area in it (1 geometry without area left out"));
  EXPECT_TRUE(contains(error(polygon_of("[[0,0],[1,1]]")), "what is drawn has no area"));
  EXPECT_TRUE(contains(error(polygon_of(outer_ring), ":a"), "its areas have no names: leave out the colon"));
  std::string deep = polygon_of(outer_ring);
  for (int k = 0; k < 200; ++k) deep = R"({"type":"GeometryCollection","geometries":[)" + deep + "]}";
  EXPECT_TRUE(contains(error(deep), "nested more than 100 deep"));
  EXPECT_TRUE(contains(error(polygon_of("[[0,0],[1e999,1],[2,2]]")), "no JSON"));
}

}  // namespace
}  // namespace shellmatch::testing
