#include "geometry/scene/scene_shape.h"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

// The turn that brings `up` to z: a right-handed frame remains one.
Mat<3> turn_from(UpAxis up) {
  Mat<3> turn = Mat<3>::Identity();
  if (up == UpAxis::y) turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == UpAxis::x) turn << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  return turn;
}

// A scene that names one mesh again and again may be far larger than its file.
constexpr std::size_t most_meshes = 1000000;

}  // namespace

void SceneShape::add(const Affine& place, const std::vector<Vec<3>>& vertices,
                     const std::vector<std::vector<Index>>& polygons) {
  if (++n_meshes_ > most_meshes)
    throw_input_error("{}: more than {} meshes in the scene; export a part of it", path_, most_meshes);
  const std::size_t first = mesh_.shape.vertices.size();
  if (first + vertices.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw_input_error("{}: more than {} vertices in the scene; export a part of it", path_,
                      std::numeric_limits<Index>::max());
  if (!place.linear.isIdentity(0) || !place.offset.isZero(0)) ++n_moved_;
  stop_if_wanted();
  for (const Vec<3>& x : vertices) add_vertex({path_, "mesh", n_meshes_}, place(x), mesh_.shape);
  const bool is_mirrored = place.linear.determinant() < 0;
  for (const std::vector<Index>& polygon : polygons) {
    std::vector<Index> corners;
    corners.reserve(polygon.size());
    for (const Index v : polygon) add_corner({path_, "mesh", n_meshes_}, v, vertices.size(), corners);
    if (is_mirrored) std::reverse(corners.begin(), corners.end());
    for (Index& v : corners) v += static_cast<Index>(first);
    add_polygon(std::move(corners), mesh_.shape, n_ignored_);
  }
}

void SceneShape::note(std::string text) {
  if (std::find(mesh_.notes.begin(), mesh_.notes.end(), text) == mesh_.notes.end())
    mesh_.notes.push_back(std::move(text));
}

MeshFile SceneShape::finish(const SceneFrame& frame) && {
  if (mesh_.shape.polygons.empty())
    throw_input_error("{}: no mesh with faces in its scene; export the shape as a mesh of triangles", path_);
  if (n_meshes_ > 1) mesh_.notes.push_back(fmt::format("{} meshes of the scene taken as one", n_meshes_));
  if (n_moved_ > 0)
    mesh_.notes.push_back(counted(n_moved_, "mesh", "meshes") + " put where the scene places " +
                          (n_moved_ == 1 ? "it" : "them"));
  if (frame.up != UpAxis::z)
    mesh_.notes.push_back(
        fmt::format("turned so that z points up: in the file {} does", frame.up == UpAxis::y ? "y" : "x"));
  if (frame.millimetres != 1)
    mesh_.notes.push_back(
        fmt::format("coordinates multiplied by {:g}: the file's unit is the {}, the result's the millimetre",
                    frame.millimetres, frame.unit));
  const Mat<3> change = frame.millimetres * turn_from(frame.up);
  if (!change.isIdentity(0))
    for (std::size_t i = 0; i < mesh_.shape.vertices.size(); ++i) {
      mesh_.shape.vertices[i] = change * mesh_.shape.vertices[i];
      if (!mesh_.shape.vertices[i].allFinite())
        throw_input_error("{}: vertex {} is too far away for the unit that the file names", path_, i);
    }
  note_ignored_polygons(n_ignored_, mesh_.notes);
  mesh_.unit = "mm";
  return std::move(mesh_);
}

}  // namespace shellmatch
