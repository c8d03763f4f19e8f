#pragma once
/// \file
/// The shapes of an output folder, ready to be drawn.

#include "geometry/surface/surface.h"

#include <string>
#include <vector>

namespace shellmatch {

/// All in the coordinates of the template; the reference as alignment has turned it.
template <int Dim>
struct ResultShapes {
  Surface<Dim> reference;  ///< with the vertices and facets of `deformed`
  Surface<Dim> deformed, template_shape;
  std::vector<double> distance_to_template, measure_ratio;  ///< at the vertices of `deformed`
  std::vector<double> distance_to_deformed;                 ///< at those of the template
  std::string unit;                                         ///< of lengths; empty where nobody has said
};

/// Reads deformed.ply, template.ply (.csv), deformation.vtu, config.yaml and the reference that this names.
/// \throws InputError where one of them is missing, damaged, or the reference is not that of the result
template <int Dim>
ResultShapes<Dim> read_result_shapes(const std::string& folder);

}  // namespace shellmatch
