// glTF by assimp, whose other readers are switched off: it goes by contents as well as by endings.
#include "base/printable.h"
#include "geometry/scene/scene_shape.h"

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <string>

namespace shellmatch {

namespace {

void keep_gltf_alone(Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
    if (std::string_view(importer.GetImporterInfo(i)->mFileExtensions).find("glb") == std::string_view::npos)
      importer.UnregisterLoader(importer.GetImporter(i));
}

Affine affine(const aiMatrix4x4& m) {
  Affine result;
  result.linear << m.a1, m.a2, m.a3, m.b1, m.b2, m.b3, m.c1, m.c2, m.c3;
  result.offset << m.a4, m.b4, m.c4;
  return result;
}

void add_mesh(const aiMesh& mesh, const Affine& place, SceneShape& shape) {
  std::vector<Vec<3>> vertices;
  std::vector<std::vector<Index>> polygons;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) vertices.emplace_back(mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z);
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    std::vector<Index> polygon;
    for (unsigned k = 0; k < face.mNumIndices; ++k)
      polygon.push_back(face.mIndices[k] < mesh.mNumVertices ? static_cast<Index>(face.mIndices[k]) : no_index);
    polygons.push_back(std::move(polygon));
  }
  shape.add(place, vertices, polygons);
  if (mesh.HasBones()) shape.note("taken in the pose of its mesh: that of its bones is not applied");
  if (mesh.mNumAnimMeshes > 0) shape.note("taken without its morph targets");
}

void add_node(const aiScene& scene, const aiNode& node, const Affine& parent, int depth, const std::string& path, SceneShape& shape) {
  if (depth > deepest_node) throw_input_error("{}: nodes within nodes more than {} deep; flatten the scene", path, deepest_node);
  const Affine place = parent * affine(node.mTransformation);
  for (unsigned k = 0; k < node.mNumMeshes; ++k)
    if (node.mMeshes[k] < scene.mNumMeshes) add_mesh(*scene.mMeshes[node.mMeshes[k]], place, shape);
  for (unsigned k = 0; k < node.mNumChildren; ++k) add_node(scene, *node.mChildren[k], place, depth + 1, path, shape);
}

}  // namespace

MeshFile read_gltf(const std::string& path) {
  Assimp::Importer importer;
  keep_gltf_alone(importer);
  const aiScene* scene = importer.ReadFile(path, 0);
  if (!scene || !scene->mRootNode)
    throw_input_error("{}: cannot be read as glTF ({}); export it again as .glb", path, printable(importer.GetErrorString(), 200));
  SceneShape shape(path);
  add_node(*scene, *scene->mRootNode, {}, 0, path, shape);
  return std::move(shape).finish({1000, "metre", UpAxis::y});
}

}  // namespace shellmatch
