#pragma once
/// \file
/// Shapes out of bytes, for the steps that mend what was read: closed bodies, and edits that damage them as files are
/// damaged. Of random triangles hardly any surface is closed, and the steps behind that check would never run.

#include "geometry/surface/surface.h"

#include <string_view>

namespace shellmatch::fuzz {

/// At most 60 edits and some 300 vertices.
OriginalShape<3> edited_mesh(std::string_view bytes);
OriginalShape<2> edited_outline(std::string_view bytes);

}  // namespace shellmatch::fuzz
