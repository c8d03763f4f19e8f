#pragma once
/// \file
/// Meshes of a scene, each at its place in it, as one shape: in millimetres, z upward.

#include "geometry/mesh_text/read_mesh_formats.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// x -> linear x + offset.
struct Affine {
  Mat<3> linear = Mat<3>::Identity();
  Vec<3> offset = Vec<3>::Zero();
  Vec<3> operator()(const Vec<3>& x) const { return linear * x + offset; }
  /// First `other`, then this one.
  Affine operator*(const Affine& other) const { return {linear * other.linear, (*this)(other.offset)}; }
};

enum class UpAxis { x, y, z };

/// What a format says of the coordinates of a scene.
struct SceneFrame {
  double millimetres = 1;  ///< that its unit has
  std::string unit = "millimetre";
  UpAxis up = UpAxis::z;
};

class SceneShape {
 public:
  explicit SceneShape(std::string path) : path_(std::move(path)) {}

  /// Adds a mesh at its place in the scene, its vertices in their order. \throws InputError where a coordinate is not
  /// finite, a corner is none of the vertices, or the scene grows beyond what can be counted.
  void add(const Affine& place, const std::vector<Vec<3>>& vertices, const std::vector<std::vector<Index>>& polygons);

  /// A remark, once.
  void note(std::string text);

  /// The whole of it, with notes that say what became of unit, axis and places. \throws InputError where nothing was
  /// added
  MeshFile finish(const SceneFrame& frame) &&;

 private:
  std::string path_;
  MeshFile mesh_;
  std::size_t n_meshes_ = 0, n_moved_ = 0, n_ignored_ = 0;
};

/// Depth of nodes within nodes that is followed; a node within itself is thereby an error.
inline constexpr int deepest_node = 100;

/// glTF 2.0, .glb or .gltf, with the files beside `path` that it names.
MeshFile read_gltf(const std::string& path, std::string_view bytes);
/// COLLADA 1.4 and 1.5.
MeshFile read_collada(const std::string& path, std::string_view bytes);
/// 3D Manufacturing Format, with components and parts in files of their own (production extension).
MeshFile read_three_mf(const std::string& path, std::string_view bytes);

}  // namespace shellmatch
