#pragma once
/// \file
/// The frame of outlines that come from pictures and drawings.

#include "geometry/surface/plane_frame.h"

#include <string>

namespace shellmatch {

/// The height in pixels of the picture that a shape's name stands for, "cells.png" or "cells.png:3", whose y runs
/// upward from 0 to it; 0 where the name is no picture's. \throws InputError where the picture cannot be read
double picture_height(const std::string& source);

/// What reading does to the coordinates of a drawing, "rois.zip:NAME"; nothing to those of other shapes. \throws
/// InputError where it cannot be read
PlaneFrame frame_of_drawing(const std::string& source);

}  // namespace shellmatch
