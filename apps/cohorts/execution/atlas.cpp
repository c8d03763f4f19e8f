#include "apps/cohorts/execution/atlas.h"

#include "apps/cohorts/subjects/point_file.h"
#include "base/error.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"

#include <cmath>
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

namespace {

// Mean square distance of corresponding points.
template <int Dim>
double square_distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights) {
  double sum = 0;
  for (Eigen::Index p = 0; p < weights.size(); ++p)
    sum += weights[p] * (a.segment<Dim>(Dim * p) - b.segment<Dim>(Dim * p)).squaredNorm();
  return sum;
}

// Root mean square over the surface.
template <int Dim>
double distance_from_surface(const std::vector<Vec<Dim>>& points, const Atlas<Dim>& atlas) {
  const std::vector<double> distances = distances_to(points, atlas.surface);
  double sum = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    sum += atlas.weights[static_cast<Eigen::Index>(v)] * distances[v] * distances[v];
  return std::sqrt(sum);
}

}  // namespace

template <int Dim>
MeanAtlas<Dim> mean_atlas(const Atlas<Dim>& atlas, const PointSets& images, ProcrustesKind kind) {
  const AlignedSets aligned = procrustes(images, atlas.weights, atlas.points, kind);
  MeanAtlas<Dim> mean;
  mean.shape = atlas.shape;
  mean.landmarks = atlas.landmarks;
  Eigen::Index p = 0;
  for (Vec<Dim>& x : mean.shape.vertices) x = aligned.mean.segment<Dim>(Dim * p++);
  for (NamedPoint<Dim>& landmark : mean.landmarks) landmark.point = aligned.mean.segment<Dim>(Dim * p++);
  mean.change = distance_from_surface(mean.shape.vertices, atlas) / atlas.diagonal;
  double sum = 0, least = 0;
  for (Eigen::Index k = 0; k < images.n_sets(); ++k) {
    const double square = square_distance<Dim>(aligned.sets.coordinates.col(k), aligned.mean, atlas.weights);
    sum += square;
    if (k == 0 || square < least) {
      least = square;
      mean.nearest = static_cast<std::size_t>(k);
    }
  }
  mean.spread = std::sqrt(sum / static_cast<double>(images.n_sets())) / atlas.diagonal;
  return mean;
}

SHELLMATCH_2D_3D(make_atlas);
SHELLMATCH_2D_3D(read_atlas);
SHELLMATCH_2D_3D(mean_atlas);

}  // namespace shellmatch
