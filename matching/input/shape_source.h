#pragma once
/// \file
/// Opens a shape: a file, a part of a volume, or a built-in shape.

#include "geometry/io/read_shape.h"
#include "geometry/surface/space.h"

#include <string>

namespace shellmatch {

/// The shape named by `source`, a file, "VOLUME:LABELS" (geometry/volume/volume_name.h) or "generate:NAME/VARIANT"
/// (matching/experiment/generated_source.h), repaired for matching. \param closing of a mesh that is not closed
/// \param space the frame of shapes out of volumes \throws InputError where it cannot be used
AnyShape open_shape(const std::string& source, Closing closing = Closing::never, Space space = default_space);

/// The file that `source` names, without what is chosen of a volume.
std::string file_of_shape(const std::string& source);

}  // namespace shellmatch
