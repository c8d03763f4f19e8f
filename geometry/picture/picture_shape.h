#pragma once
/// \file
/// Which pixels of a picture are the shape.

#include "geometry/picture/label_choice.h"
#include "geometry/picture/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The shape in a picture, bright on dark: of 0 and 1 alone, where the picture says of each pixel whether it belongs to
/// the shape.
///
/// 1. What is chosen, if anything: pixels of these values of the file.
/// 2. Of two values the brighter one; where most of the rim has it, the other one: the rim shows the background.
/// 3. Of labels all that is not 0. Labels are whole numbers that fill areas: more than two values, each of which fills
/// 2 x 2 pixels
///    somewhere, with 0 along most of the rim. Grey pixels along the border of a shape and photographs are not like
///    that.
/// 4. Of any other picture what is brighter than half of white, or, where most of the rim is, what is darker.
/// \param notes says which rule it was, but for rule 2 as it is usual
/// \throws InputError where nothing or everything is chosen
GreyImage shape_of_picture(const Picture& picture, const std::optional<VoxelChoice>& choice, const std::string& source,
                           std::vector<std::string>& notes);

}  // namespace shellmatch
