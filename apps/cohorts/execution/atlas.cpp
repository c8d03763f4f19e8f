#include "apps/cohorts/execution/atlas.h"

#include "base/error.h"
#include "apps/cohorts/subjects/point_file.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"

#include <filesystem>

namespace shellmatch {

namespace {

namespace fs = std::filesystem;

std::string shape_file(const std::string& folder, const std::string& name, int dimension) {
  return folder + "/" + name + (dimension == 3 ? ".ply" : ".csv");
}

std::string landmark_file(const std::string& folder, const std::string& name) {
  return folder + "/" + name + "_landmarks.csv";
}

Surface<2> facets_of(const OriginalShape<2>& shape, const std::string&) {
  Surface<2> surface{shape.vertices, {}};
  for (const std::vector<Index>& ring : shape.polygons)
    for (std::size_t k = 0; k < ring.size(); ++k) surface.facets.push_back({ring[k], ring[(k + 1) % ring.size()]});
  return surface;
}

Surface<3> facets_of(const OriginalShape<3>&, const std::string& file) { return read_triangles(file); }

template <int Dim>
Atlas<Dim> complete(Atlas<Dim> atlas) {
  const std::string& file = atlas.files.shape;
  atlas.surface = facets_of(atlas.shape, file);
  atlas.diagonal = bounding_box(atlas.shape.vertices).diagonal();
  if (atlas.surface.facets.empty() || !(atlas.diagonal > 0))
    throw_input_error("{}: has no surface that could be carried onto subjects", file);
  const auto n = static_cast<Eigen::Index>(atlas.shape.vertices.size()),
             n_landmarks = static_cast<Eigen::Index>(atlas.landmarks.size());
  atlas.points.resize(Dim * (n + n_landmarks));
  for (Eigen::Index v = 0; v < n; ++v)
    atlas.points.template segment<Dim>(Dim * v) = atlas.shape.vertices[static_cast<std::size_t>(v)];
  for (Eigen::Index l = 0; l < n_landmarks; ++l)
    atlas.points.template segment<Dim>(Dim * (n + l)) = atlas.landmarks[static_cast<std::size_t>(l)].point;
  atlas.weights = Eigen::VectorXd::Zero(n + n_landmarks);
  atlas.weights.head(n) = area_weights<Dim>(atlas.points.head(Dim * n), atlas.surface.facets);
  return atlas;
}

}  // namespace

template <int Dim>
Atlas<Dim> make_atlas(OriginalShape<Dim> shape, std::vector<NamedPoint<Dim>> landmarks, const std::string& folder,
                      const std::string& name) {
  Atlas<Dim> atlas;
  fs::create_directories(folder);
  atlas.files.shape = shape_file(folder, name, Dim);
  if constexpr (Dim == 3) write_ply(atlas.files.shape, shape);
  else write_outline_csv(atlas.files.shape, shape);
  if (!landmarks.empty()) write_named_points(atlas.files.landmarks = landmark_file(folder, name), landmarks);
  atlas.shape = std::move(shape);
  atlas.landmarks = std::move(landmarks);
  return complete(std::move(atlas));
}

template <int Dim>
Atlas<Dim> read_atlas(const std::string& folder, const std::string& name) {
  Atlas<Dim> atlas;
  atlas.files.shape = shape_file(folder, name, Dim);
  if constexpr (Dim == 3) atlas.shape = read_points_or_mesh_3d(atlas.files.shape);
  else atlas.shape = read_points_or_outline_2d(atlas.files.shape);
  if (const std::string file = landmark_file(folder, name); fs::exists(file)) {
    std::vector<std::string> notes;
    atlas.files.landmarks = file;
    atlas.landmarks = read_named_points<Dim>(file, atlas.shape.vertices, atlas.shape.space, atlas.shape.space, notes);
  }
  return complete(std::move(atlas));
}

bool has_atlas(const std::string& folder, const std::string& name, int dimension) {
  return fs::exists(shape_file(folder, name, dimension));
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                         \
  template Atlas<Dim> make_atlas<Dim>(OriginalShape<Dim>, std::vector<NamedPoint<Dim>>, const std::string&, \
                                      const std::string&);                                                  \
  template Atlas<Dim> read_atlas<Dim>(const std::string&, const std::string&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
