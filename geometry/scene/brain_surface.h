#pragma once
/// \file
/// Surfaces of neuroimaging, in millimetres of scanner RAS.

#include "geometry/mesh_text/read_mesh_formats.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace shellmatch {

/// GIfTI, .gii: "GIFTI Surface Data Format" 1.0, Harwell et al. 2011. A transform that the file has to the scanner's
/// frame is applied.
MeshFile read_gifti(const std::string& path, std::string_view bytes);

/// FreeSurfer's binary triangles, lh.white, and quadrilaterals of before 2000: from the frame of the volume's own axes
/// (tkRegister) to that of the scanner, where the file describes the volume.
MeshFile read_freesurfer(const std::string& path, std::string_view bytes);

/// Is that such a file, whatever its name? \param head its first bytes, `freesurfer_head` of them where it has so many
/// \param size of the file in bytes
bool is_freesurfer(std::string_view head, std::uintmax_t size);
inline constexpr std::size_t freesurfer_head = 9;

}  // namespace shellmatch
