#pragma once
/// \file
/// Masks: images whose bright part is the shape.

#include "geometry/picture/picture.h"
#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// PNG with 1 to 16 bits, grey or colour; transparent is dark. Of a colour the luminance counts, as libpng has it: full
/// red is 0.5, green 0.86 and blue 0.3. Where all is black the opacity counts. \throws InputError where the file is cut
/// off or damaged.
Picture read_png(const std::string& path, std::string_view bytes);
/// PGM, text (P2) or binary (P5). \throws as above.
Picture read_pgm(const std::string& path, std::string_view bytes);

/// The border lines of what is brighter than 1/2 or, in an image of two tones, of the brighter one, as closed
/// smooth rings: marching squares with linear interpolation on a slightly smoothed image (Gaussian, standard
/// deviation 1 pixel for images of two tones, half a pixel where grey pixels already tell where the border runs).
/// Pixel units, y upward: the centre of the pixel in column i of row j (from the top) is (i + 1/2, height - j -
/// 1/2). Bright parts lie to the left of the direction of a ring. Rings shorter than 8 pixels are left out, with a
/// note. \throws InputError where nothing is bright, or where the bright part touches the rim of the image.
OriginalShape<2> mask_rings(const GreyImage& image, const std::string& source, std::vector<std::string>& notes);

}  // namespace shellmatch
