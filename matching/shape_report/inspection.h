#pragma once
/// \file
/// Properties of a shape, measured on the surface that a matching would use.

#include "geometry/surface/surface.h"

#include <string>
#include <vector>

namespace shellmatch {

struct Inspection {
  std::string source;
  int dimension = 0;
  std::string frame = {};  ///< "RAS" or "LPS" in space; empty where the file names none
  std::size_t n_original_vertices = 0, n_original_polygons = 0;  ///< as in the file
  std::vector<std::string> attributes;                           ///< names of the vertex attributes in the file
  std::vector<std::string> notes;                                ///< repairs

  std::size_t n_vertices = 0, n_facets = 0, n_components = 0;
  int genus = 0;                      ///< sum over the components; 0 in the plane
  std::size_t n_buried_vertices = 0;  ///< inside other parts of it (buried_parts())
  double buried_share = 0;            ///< of the area
  double burial_depth = 0;            ///< largest distance of what is buried from the rest
  double measure = 0;                 ///< length or area
  double enclosed = 0;                ///< area or volume
  std::vector<double> box_min, box_max;
  double mean_edge = 0;
  double curvature_radius = 0;  ///< of the curvature that 95 % of the shape do not exceed; infinity if flat

  // Properties after placement alone in the unit domain, with the default margin.
  double scale = 0;            ///< factor on the lengths above
  int level_of_curvature = 0;  ///< coarsest level whose band, two cells to each side, fits that radius
  int level_of_edges = 0;      ///< coarsest level whose cells are no larger than the mean edge
};

template <int Dim>
Inspection inspect_shape(const Shape<Dim>& shape);

/// A text of several lines.
std::string inspection_text(const Inspection& inspection);

/// One JSON object; the radius is null if it is infinite.
std::string inspection_json(const Inspection& inspection);

}  // namespace shellmatch
