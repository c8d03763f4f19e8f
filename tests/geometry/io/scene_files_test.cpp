// Scenes: nodes are applied, units are millimetres, z points up, vertices keep their order. Written as the
// specifications say, and by assimp's own exporters.
#include "geometry/io/read_shape.h"
#include "tests/geometry/io/surface_files.h"

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

#include <memory>

namespace shellmatch::testing {
namespace {

// The corner (1, 0, 0) and (0, 1, 0) and so on of the cube, under the map that the test expects.
template <class Map>
void expect_cube(const std::vector<Vec<3>>& vertices, std::size_t first, Map&& map) {
  const std::vector<Vec<3>> corners = cube().vertices;
  ASSERT_GE(vertices.size(), first + 8);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR((vertices[first + i] - map(corners[i])).norm(), 0, 1e-4) << i;
}

std::string collada(const std::string& asset, const std::string& nodes, const std::string& faces) {
  std::string positions;
  for (const Vec<3>& x : cube().vertices) positions += fmt::format("{} {} {} ", x.x(), x.y(), x.z());
  return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\"><asset>" +
         asset +
         "</asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"24\">" +
         positions +
         "</float_array><technique_common><accessor source=\"#a\" count=\"8\" "
         "stride=\"3\"/></technique_common></source>"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>" +
         faces + "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">" + nodes +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

// Each corner with a normal, as most programs write it.
std::string polylist() {
  std::string counts, corners;
  for (const auto& q : cube().polygons) {
    counts += "4 ";
    for (const Index v : q) corners += fmt::format("{} 0 ", v);
  }
  return "<polylist count=\"6\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><input semantic=\"NORMAL\" "
         "source=\"#n\" offset=\"1\"/><vcount>" +
         counts + "</vcount><p>" + corners + "</p></polylist>";
}

TEST(Collada, NodesUnitAndAxisAreApplied) {
  const TempFolder folder;
  const std::string nodes =
      "<node><translate>1 0 0</translate><rotate>0 0 1 90</rotate><scale>2 2 2</scale><instance_geometry url=\"#g\"/>"
      "<node><matrix>1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url=\"#g\"/></node></node>";
  const Shape<3> shape = read_mesh(folder.write(
      "a.dae", collada("<unit name=\"inch\" meter=\"0.0254\"/><up_axis>Z_UP</up_axis>", nodes, polylist())));
  EXPECT_EQ(shape.original.vertices.size(), 16u);
  EXPECT_EQ(shape.original.polygons[0], cube().polygons[0]);
  expect_cube(shape.original.vertices, 0,
              [](const Vec<3>& x) { return Vec<3>(25.4 * Vec<3>(1 - 2 * x.y(), 2 * x.x(), 2 * x.z())); });
  expect_cube(shape.original.vertices, 8,
              [](const Vec<3>& x) { return Vec<3>(25.4 * Vec<3>(1 - 2 * x.y(), 2 * (x.x() + 10), 2 * x.z())); });
  EXPECT_TRUE(has_note(shape, "2 meshes of the scene taken as one"));
  EXPECT_TRUE(has_note(shape, "multiplied by 25.4: the file's unit is the inch"));
  EXPECT_EQ(shape.unit, "mm");

  const std::string plain = "<node><instance_geometry url=\"#g\"/></node>";
  const auto first = [&](const std::string& up) {
    return read_mesh(folder.write("a.dae", collada("<unit meter=\"0.001\"/>" + up, plain, polylist())));
  };
  expect_cube(first("").original.vertices, 0, [](const Vec<3>& x) { return Vec<3>(x.x(), -x.z(), x.y()); });
  expect_cube(first("<up_axis>X_UP</up_axis>").original.vertices, 0,
              [](const Vec<3>& x) { return Vec<3>(-x.y(), -x.z(), x.x()); });
  EXPECT_TRUE(first("<up_axis>Z_UP</up_axis>").notes.size() == 1);  // of polygons split
}

TEST(Collada, WhatIsWrongIsSaidOnce) {
  const TempFolder folder;
  const auto message = [&](const std::string& nodes, const std::string& faces) {
    return input_error_of([&] { read_mesh(folder.write("a.dae", collada("", nodes, faces))); });
  };
  const std::string node = "<node><instance_geometry url=\"#g\"/></node>";
  EXPECT_TRUE(contains(message("", polylist()), "no mesh with faces"));
  EXPECT_TRUE(contains(message("<node id=\"n\"><instance_node url=\"#n\"/></node>", polylist()), "deep"));
  EXPECT_TRUE(
      contains(message("<node><instance_geometry url=\"#h\"/></node>", polylist()), "'#h', which is not in it"));
  EXPECT_TRUE(contains(message("<node><instance_geometry url=\"b.dae#h\"/></node>", polylist()), "another file"));
  const auto triangles = [](const std::string& p) {
    return "<triangles><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" + p + "</p></triangles>";
  };
  EXPECT_TRUE(contains(message(node, triangles("0 1 8")), "names vertex 8"));
  EXPECT_TRUE(contains(message(node, triangles("0 1 2 3")), "have 4 corners"));
  EXPECT_TRUE(contains(message(node, triangles("0 1 a")), "'a' is no number"));
}

std::string three_mf(const std::string& unit, const std::string& build, const std::string& more = "",
                     ZipForm form = ZipForm::narrow) {
  std::string mesh = "<mesh><vertices>";
  const OriginalShape<3> shape = triangulated_cube();
  for (const Vec<3>& x : shape.vertices)
    mesh += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", x.x(), x.y(), x.z());
  mesh += "</vertices><triangles>";
  for (const auto& t : shape.polygons)
    mesh += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", t[0], t[1], t[2]);
  mesh += "</triangles></mesh>";
  const std::string model = "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" xmlns:p=\"p\" ";
  return zip_bytes({{"_rels/.rels",
                     "<Relationships><Relationship Target=\"/3D/a.model\" Id=\"r\" "
                     "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
                    {"3D/b.model", model + "><resources><object id=\"7\">" + mesh + "</object></resources></model>"},
                    {"3D/a.model", model + unit + "><resources><object id=\"1\" type=\"model\">" + mesh + "</object>" +
                                       more + "</resources><build>" + build + "</build></model>"}},
                   form);
}

TEST(ThreeMf, BuildComponentsPartsAndUnit) {
  const TempFolder folder;
  const Shape<3> shape = read_mesh(folder.write(
      "a.3mf", three_mf("unit=\"centimeter\"",
                        "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 5 6 7\"/><item objectid=\"3\"/>",
                        "<object id=\"2\"><components><component objectid=\"1\"/><component objectid=\"7\" "
                        "p:path=\"/3D/b.model\" transform=\"2 0 0 0 2 0 0 0 2 10 0 0\"/>"
                        "</components></object><object id=\"3\" type=\"support\"/>")));
  expect_cube(shape.original.vertices, 0,
              [](const Vec<3>& x) { return Vec<3>(10 * Vec<3>(5 - x.y(), 6 + x.x(), 7 + x.z())); });
  expect_cube(shape.original.vertices, 8,
              [](const Vec<3>& x) { return Vec<3>(10 * Vec<3>(5 - 2 * x.y(), 6 + 10 + 2 * x.x(), 7 + 2 * x.z())); });
  EXPECT_TRUE(has_note(shape, "multiplied by 10: the file's unit is the centimeter"));
  EXPECT_TRUE(has_note(shape, "1 support structure left out"));
  EXPECT_TRUE(read_mesh(folder.write("a.3mf", three_mf("", "<item objectid=\"1\"/>"))).notes.empty());
}

// Of lib3mf, by which OpenSCAD and others write, all archives are ZIP64.
TEST(ThreeMf, Zip64) {
  const TempFolder folder;
  const auto message = [&](const std::string& bytes) {
    return input_error_of([&] { read_mesh(folder.write("a.3mf", bytes)); });
  };
  const std::string wide = three_mf("", "<item objectid=\"1\"/>", "", ZipForm::wide);
  expect_cube(read_mesh(folder.write("a.3mf", wide)).original.vertices, 0, [](const Vec<3>& x) { return x; });
  std::string cut = wide;
  cut.erase(cut.find("PK\6\6"), 8);
  EXPECT_TRUE(contains(message(cut), "directory of the archive is damaged"));
  std::string huge = wide;
  huge.replace(huge.find("PK\1\2") + 46 + 11 + 9, 8, 8, '\x7f');
  EXPECT_TRUE(contains(message(huge), "is larger than 4 GB"));
  // Whatever is wrong in the directory, it is read or refused.
  for (std::size_t i = wide.find("PK\1\2"); i < wide.size(); ++i) {
    std::string damaged = wide;
    damaged[i] = static_cast<char>(damaged[i] ^ 0xff);
    try {
      read_mesh(folder.write("a.3mf", damaged));
    } catch (const InputError&) {
    }
  }
}

TEST(ThreeMf, WhatIsWrongIsSaidOnce) {
  const TempFolder folder;
  const auto message = [&](const std::string& bytes) {
    return input_error_of([&] { read_mesh(folder.write("a.3mf", bytes)); });
  };
  const std::string whole = three_mf("", "<item objectid=\"1\"/>");
  EXPECT_TRUE(contains(message(whole.substr(0, 900)), "its directory is missing"));
  EXPECT_TRUE(contains(message(three_mf("unit=\"mile\"", "<item objectid=\"1\"/>")), "the unit 'mile' is unknown"));
  EXPECT_TRUE(contains(message(three_mf("", "<item objectid=\"9\"/>")), "object '9'"));
  EXPECT_TRUE(
      contains(message(three_mf("", "<item objectid=\"2\"/>",
                                "<object id=\"2\"><components><component objectid=\"2\"/></components></object>")),
               "without end"));
  EXPECT_TRUE(contains(message(three_mf("", "")), "no mesh with faces"));
}

// Two nodes with the same cube: as it is, and moved, turned to its side and doubled.
std::unique_ptr<aiScene> exported_scene() {
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode("root");
  scene->mNumMeshes = scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
  scene->mMeshes = new aiMesh* [1] { new aiMesh };
  aiMesh& mesh = *scene->mMeshes[0];
  const OriginalShape<3> shape = triangulated_cube();
  mesh.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh.mNumVertices = static_cast<unsigned>(shape.vertices.size());
  mesh.mVertices = new aiVector3D[shape.vertices.size()];
  for (std::size_t i = 0; i < shape.vertices.size(); ++i)
    mesh.mVertices[i] = aiVector3D(static_cast<float>(shape.vertices[i].x()), static_cast<float>(shape.vertices[i].y()),
                                   static_cast<float>(shape.vertices[i].z()));
  mesh.mNumFaces = static_cast<unsigned>(shape.polygons.size());
  mesh.mFaces = new aiFace[shape.polygons.size()];
  for (std::size_t f = 0; f < shape.polygons.size(); ++f) {
    mesh.mFaces[f].mNumIndices = 3;
    mesh.mFaces[f].mIndices = new unsigned[3];
    for (std::size_t k = 0; k < 3; ++k) mesh.mFaces[f].mIndices[k] = static_cast<unsigned>(shape.polygons[f][k]);
  }
  for (int k = 0; k < 2; ++k) {
    auto* node = new aiNode("part" + std::to_string(k));
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{0};
    if (k == 1) node->mTransformation = aiMatrix4x4(0, -2, 0, 10, 2, 0, 0, 20, 0, 0, 2, 30, 0, 0, 0, 1);
    scene->mRootNode->addChildren(1, &node);
  }
  return scene;
}

TEST(Scenes, WhatAssimpExportsIsReadBack) {
  const TempFolder folder;
  const auto exported = [&](const char* format, const std::string& name) {
    Assimp::Exporter exporter;
    // Of 60 exports of 3MF assimp 5.4.3 refuses one, as a file exists that does not and cannot be removed.
    const std::string path = folder.write(name, "");
    EXPECT_EQ(exporter.Export(exported_scene().get(), format, path), AI_SUCCESS) << exporter.GetErrorString();
    return read_mesh(path);
  };
  const auto up = [](const Vec<3>& x) { return Vec<3>(1000 * Vec<3>(x.x(), -x.z(), x.y())); };
  const auto place = [](const Vec<3>& x) { return Vec<3>(10 - 2 * x.y(), 20 + 2 * x.x(), 30 + 2 * x.z()); };
  for (const auto& [format, name] : {std::pair{"glb2", "a.glb"}, std::pair{"gltf2", "a.gltf"}}) {
    const Shape<3> shape = exported(format, name);
    expect_cube(shape.original.vertices, 0, up);
    expect_cube(shape.original.vertices, 8, [&](const Vec<3>& x) { return up(place(x)); });
    EXPECT_EQ(shape.original.polygons[0], triangulated_cube().polygons[0]);
    EXPECT_TRUE(has_note(shape, "turned so that z points up"));
    EXPECT_TRUE(has_note(shape, "multiplied by 1000: the file's unit is the metre"));
    EXPECT_EQ(shape.surface.facets.size(), 24u);
  }
  const Shape<3> dae = exported("collada", "a.dae");
  EXPECT_NEAR(volume(dae.surface), 9e9, 1e5);
  expect_cube(exported("3mf", "a.3mf").original.vertices, 0, [](const Vec<3>& x) { return x; });
}

// A tetrahedron, edge length 1 metre along the axes; its bytes: positions of two bytes each, then corners of one.
std::string gltf(const std::string& primitive, const std::string& accessors, const std::string& more = "") {
  std::string bytes;
  for (const int value : {0, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0, 0, 0, 0, 127, 0}) bytes += static_cast<char>(value);
  for (const int v : {0, 2, 1, 3, 0, 2}) bytes += static_cast<char>(v);
  return "{\"asset\": {\"version\": \"2.0\"}, " + more +
         "\"nodes\": [{\"mesh\": 0}], \"meshes\": [{\"primitives\": [{" + primitive + "}]}], \"accessors\": [" +
         accessors +
         "], \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 16, \"byteStride\": 4}, "
         "{\"buffer\": 0, \"byteOffset\": 16, \"byteLength\": 6}, {\"buffer\": 0, \"byteOffset\": 4, \"byteLength\": "
         "12}, "
         "{\"buffer\": 0, \"byteOffset\": 18, \"byteLength\": 3}], "
         "\"buffers\": [{\"byteLength\": 22, \"uri\": \"data:application/octet-stream;base64," +
         base64(bytes) + "\"}]}";
}
const std::string quantized =
    R"({"bufferView": 0, "componentType": 5120, "normalized": true, "count": 4, "type": "VEC3"})";
const std::string strip = R"({"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"})";

TEST(Gltf, QuantizedPositionsAndStripsAreRead) {
  const TempFolder folder;
  const Shape<3> shape = read_mesh(folder.write(
      "a.gltf", gltf(R"("attributes": {"POSITION": 0}, "indices": 1, "mode": 5)", quantized + "," + strip)));
  ASSERT_EQ(shape.original.vertices.size(), 4u);
  EXPECT_NEAR((shape.original.vertices[1] - Vec<3>(1000, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((shape.original.vertices[2] - Vec<3>(0, 0, 1000)).norm(), 0, 1e-9);
  EXPECT_EQ(shape.original.polygons, (std::vector<std::vector<Index>>{{0, 2, 1}, {1, 2, 3}, {1, 3, 0}, {0, 3, 2}}));
  EXPECT_NEAR(std::abs(volume(shape.surface)), 1e9 / 6, 1);
}

TEST(Gltf, SparsePositionsReplaceZeros) {
  const TempFolder folder;
  const std::string sparse =
      R"({"componentType": 5120, "normalized": true, "count": 4, "type": "VEC3", "sparse": {"count": 3, "indices":
      {"bufferView": 3, "componentType": 5121}, "values": {"bufferView": 0, "byteOffset": 4}}})";
  const auto of = [&](const std::string& positions) {
    return read_mesh(folder.write(
        "a.gltf", gltf(R"("attributes": {"POSITION": 0}, "indices": 1, "mode": 5)", positions + "," + strip)));
  };
  const Shape<3> shape = of(sparse);  // positions 1, 3 and 0 are replaced, 2 stays
  EXPECT_NEAR((shape.original.vertices[1] - Vec<3>(1000, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR((shape.original.vertices[3] - Vec<3>(0, 0, 1000)).norm(), 0, 1e-9);
  EXPECT_EQ(shape.original.vertices[2], Vec<3>::Zero());
}

TEST(Gltf, WhatIsNotThereTakesNoMemory) {
  const TempFolder folder;
  const auto error_of = [&](const std::string& positions, const std::string& more = "") {
    return input_error_of([&] {
      read_mesh(folder.write("a.gltf",
                             gltf(R"("attributes": {"POSITION": 0}, "indices": 1)", positions + "," + strip, more)));
    });
  };
  EXPECT_TRUE(contains(error_of(R"({"bufferView": 0, "componentType": 5126, "count": 2000000000, "type": "VEC3"})"),
                       "2000000000 numbers are declared"));
  EXPECT_TRUE(contains(error_of(R"({"componentType": 5126, "count": 2000000000, "type": "VEC3"})"),
                       "2000000000 positions are declared"));
  EXPECT_TRUE(contains(error_of(R"({"bufferView": 9, "componentType": 5126, "count": 4, "type": "VEC3"})"),
                       "refers to buffer view 9"));
  const std::string beside = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4, "uri": "%"}]})";
  for (const std::string uri : {"%2e", "none.bin", "%2fdev%2fzero"})
    EXPECT_TRUE(contains(input_error_of([&] {
                           read_mesh(folder.write("a.gltf", std::string(beside).replace(beside.find('%'), 1, uri)));
                         }),
                         "not found : " + (uri == "none.bin" ? uri + ")" : "")))
        << uri;
  EXPECT_TRUE(contains(error_of(quantized, R"("extensionsRequired": ["KHR_draco_mesh_compression"], )"),
                       "export it without compression"));
}

TEST(Gltf, DamageIsSaidOnce) {
  const TempFolder folder;
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.write("a.glb", "glTF")); }), "cannot be read as glTF"));
  EXPECT_TRUE(contains(
      input_error_of([&] { read_mesh(folder.write("a.gltf", "{\"asset\": {\"version\": \"2.0\"}}")); }), "a.gltf"));
}

}  // namespace
}  // namespace shellmatch::testing
