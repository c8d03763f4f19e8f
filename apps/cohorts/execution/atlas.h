#pragma once
/// \file
/// The shape that is deformed onto every subject, and the mean of its images, the atlas of the next round.

#include "apps/cohorts/execution/stage.h"
#include "geometry/statistics/point_sets.h"
#include "geometry/statistics/procrustes.h"
#include "geometry/surface/surface.h"
#include "matching/pairs/landmark_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace shellmatch {

template <int Dim>
struct Atlas {
  AtlasFiles files;
  OriginalShape<Dim> shape;
  Surface<Dim> surface;                    ///< its polygons as triangles or segments, of all vertices in their order
  std::vector<NamedPoint<Dim>> landmarks;  ///< on it
  Eigen::VectorXd points;                  ///< vertices and then landmarks, Dim coordinates each
  Eigen::VectorXd weights;                 ///< of these: shares of the surface, and 0 for landmarks; sum 1
  double diagonal = 0;                     ///< of the box of its vertices
};

/// Writes shape and landmarks (where there are some) into the folder, as NAME.ply or NAME.csv and
/// NAME_landmarks.csv, and returns the atlas. \throws InputError for a shape without extent or without
/// polygons, EnvironmentError if nothing can be written
template <int Dim>
Atlas<Dim> make_atlas(OriginalShape<Dim> shape, std::vector<NamedPoint<Dim>> landmarks, const std::string& folder,
                      const std::string& name);

/// Reads an atlas that make_atlas() has written. \throws InputError
template <int Dim>
Atlas<Dim> read_atlas(const std::string& folder, const std::string& name);

/// Whether make_atlas() has written it.
bool has_atlas(const std::string& folder, const std::string& name, int dimension);

template <int Dim>
struct MeanAtlas {
  OriginalShape<Dim> shape;                ///< the atlas with its vertices at their means
  std::vector<NamedPoint<Dim>> landmarks;  ///< likewise
  /// Root mean square distance of the mean's points from the atlas' surface, over the atlas' diagonal. Points
  /// may slide along the surface, which does not change the shape.
  double change = 0;
  double spread = 0;        ///< of the images about the mean, root mean square over the surface and the atlas' diagonal
  std::size_t nearest = 0;  ///< the column of the image that is nearest to the mean
};

/// \param images of Atlas::points, one column for each subject, at least one
template <int Dim>
MeanAtlas<Dim> mean_atlas(const Atlas<Dim>& atlas, const PointSets& images, ProcrustesKind kind);

}  // namespace shellmatch
