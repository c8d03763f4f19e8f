#pragma once
/// \file
/// What the program thinks of a shape: measured on the surface that a matching would use.

#include "geometry/surface/surface.h"

#include <string>
#include <vector>

namespace shellmatch {

struct Inspection {
  std::string source;
  int dimension = 0;
  std::size_t n_original_vertices = 0, n_original_polygons = 0;  ///< as in the file
  std::vector<std::string> attributes;                           ///< names, of the file's vertices
  std::vector<std::string> notes;                                ///< what was mended

  std::size_t n_vertices = 0, n_facets = 0, n_components = 0;
  int genus = 0;                      ///< of all components together; 0 in the plane
  double measure = 0;                 ///< length or area
  double enclosed = 0;                ///< area or volume
  std::vector<double> box_min, box_max;
  double mean_edge = 0;
  double curvature_radius = 0;        ///< 95 % of the shape are bent less than this; infinity where all is flat

  // As it would lie in the unit domain, alone and with the default margin.
  double scale = 0;                   ///< factor on the lengths above
  int level_of_curvature = 0;         ///< coarsest level whose band, two cells to each side, fits that radius
  int level_of_edges = 0;             ///< coarsest level whose cells are no larger than the mean edge
};

template <int Dim>
Inspection inspect_shape(const Shape<Dim>& shape);

/// For people, in several lines.
std::string inspection_text(const Inspection& inspection);

/// For machines: one JSON object; the radius is null where it is infinite.
std::string inspection_json(const Inspection& inspection);

}  // namespace shellmatch
