#pragma once
/// \file
/// Surfaces of neuroimaging, in millimetres of scanner RAS.

#include "geometry/mesh_text/read_mesh_formats.h"

#include <string>
#include <string_view>

namespace shellmatch {

/// GIfTI, .gii: "GIFTI Surface Data Format" 1.0, Harwell et al. 2011. A transform that the file has to the scanner's frame is applied.
MeshFile read_gifti(const std::string& path, std::string_view bytes);

/// FreeSurfer's binary triangles, lh.white: from the frame of the volume's own axes (tkRegister) to that of the scanner, where the file
/// describes the volume.
MeshFile read_freesurfer(const std::string& path, std::string_view bytes);

/// What a file of the latter begins with, whatever its name.
inline constexpr std::string_view freesurfer_mark = "\xff\xff\xfe";

}  // namespace shellmatch
