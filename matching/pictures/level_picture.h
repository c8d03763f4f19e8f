#pragma once
/// \file
/// The pictures of a run: reference, template and deformed reference, with their distances.

#include "geometry/surface/surface.h"
#include "grid/octree/octree.h"
#include "matching/result/match_summary.h"

#include <string>
#include <vector>

namespace shellmatch {

/// The contents of a picture, all in the unit domain or all in the user's coordinates. Nothing is copied: all objects
/// pointed to must outlive the call.
template <int Dim>
struct LevelPicture {
  const Surface<Dim>* reference = nullptr;
  const Surface<Dim>* template_shape = nullptr;
  const Surface<Dim>* deformed = nullptr;  ///< vertex by vertex the image of `reference`
  std::string title = {};                  ///< for instance "level 5"; may be empty
  std::vector<double> distance = {};       ///< of each deformed vertex to the template; empty omits the panel
  std::string distance_label = "distance to template";
  double distance_max = 0;                     ///< end of the colour bar; 0 takes the 98 % quantile
  std::vector<double> area_ratio = {};         ///< at each vertex, deformed over reference; empty omits the panel
  const Octree<Dim>* grid = nullptr;           ///< drawn with the shapes; in the plane only, in the unit domain
  const std::vector<Vec<Dim>>* phi = nullptr;  ///< positions of the grid's nodes, for drawing it deformed
  int panel_size = 0;                          ///< side of a panel in pixels; 0 chooses one
  bool draft = false;  ///< in space: coarser samples without soft shadows, in a sixth of the time
};

/// Adds the panel of distances, in the unit of the files. \pre template_shape is set
/// \param distance of each deformed vertex to the template, in the unit of the surfaces
template <int Dim>
void add_distances(LevelPicture<Dim>& picture, std::vector<double> distance, const MatchSummary& summary);

/// Draws a row of panels with a pattern that the deformation carries along. \pre reference, template_shape and deformed
/// are set and not empty \throws EnvironmentError if the file cannot be written
template <int Dim>
void write_level_picture(const LevelPicture<Dim>& picture, const std::string& path);

/// The name of a level's picture: "pictures/level_05.png".
std::string level_picture_name(int level);

}  // namespace shellmatch
