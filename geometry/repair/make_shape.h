#pragma once
/// \file
/// From vertices and polygons, wherever they come from, to a shape that can be matched.

#include "geometry/repair/repair.h"
#include "geometry/surface/surface.h"

#include <string>
#include <vector>

namespace shellmatch {

/// The shape with the closed surface that mending (geometry/repair/repair.h) makes of it; `notes` says what was mended.
/// \param source the name that messages give it
/// \param notes what is known already, such as what was dropped while reading
/// \param closing of surfaces in space
/// \throws InputError where no closed surface can be made of it
template <int Dim>
Shape<Dim> make_shape(OriginalShape<Dim> original, std::string source, std::vector<std::string> notes = {},
                      Closing closing = Closing::never);

}  // namespace shellmatch
