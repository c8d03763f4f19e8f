#pragma once
/// \file
/// How a picture asks to be turned where it is shown, as cameras write it. Readers differ: OpenCV and browsers turn it,
/// Pillow turns TIFF alone, libtiff flips colours without turning them, and ImageJ takes all pixels as they are stored.
/// So does this program.

#include <string_view>

namespace shellmatch {

struct Picture;

/// EXIF's orientation (CIPA DC-008, tag 0x0112) of a JPEG or PNG: from 1, as it is stored, to 8. 1 where it says
/// nothing that can be read.
int exif_orientation(std::string_view bytes);

/// Adds a note where the orientation is not 1.
void note_orientation(int orientation, Picture& picture);

}  // namespace shellmatch
