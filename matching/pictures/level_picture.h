#pragma once
/// \file
/// The pictures of a run: reference, template and deformed reference, and how far one is from the other.

#include "geometry/surface/surface.h"
#include "grid/octree/octree.h"

#include <string>
#include <vector>

namespace shellmatch {

/// What a picture shows; the unit domain or the user's coordinates, but one of them for all.
/// Holds no copies: everything pointed to must outlive the call.
template <int Dim>
struct LevelPicture {
  const Surface<Dim>* reference = nullptr;
  const Surface<Dim>* template_shape = nullptr;
  const Surface<Dim>* deformed = nullptr;  ///< vertex by vertex the image of `reference`
  std::string title = {};                  ///< "level 5", or empty
  std::vector<double> distance = {};  ///< of each deformed vertex to the template, or empty: no such panel
  std::string distance_label = "distance to template";
  double distance_max = 0;              ///< end of the colour bar; 0 takes the 98 % quantile
  std::vector<double> area_ratio = {};  ///< at each vertex, deformed over reference, or empty: no such panel
  const Octree<Dim>* grid = nullptr;    ///< in the plane only, in the unit domain: drawn with the shapes ...
  const std::vector<Vec<Dim>>* phi = nullptr;  ///< ... undeformed, and deformed by its nodes' positions
  int panel_size = 0;                          ///< pixels of a panel's side; 0 chooses
  bool draft = false;  ///< in space: coarser samples and no soft shade, a sixth of the time
};

/// A row of panels with a pattern that the deformation carries along. \pre reference, template_shape and
/// deformed are set and not empty. \throws EnvironmentError if the file cannot be written
template <int Dim>
void write_level_picture(const LevelPicture<Dim>& picture, const std::string& path);

/// "pictures/level_05.png"
std::string level_picture_name(int level);

}  // namespace shellmatch
