#pragma once
/// \file
/// The frame that a mesh says it is in.

#include "geometry/volume/volume.h"

#include <optional>
#include <string>

namespace shellmatch {

/// 3D Slicer writes SPACE=LPS or SPACE=RAS into a comment or the title of its meshes. None where the first 4096 bytes of the file say
/// neither, or where it cannot be opened.
std::optional<Space> declared_space(const std::string& path);

}  // namespace shellmatch
