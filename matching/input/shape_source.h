#pragma once
/// \file
/// Opens a shape: a file, a part of a volume, or a built-in shape.

#include "geometry/io/read_shape.h"
#include "geometry/surface/space.h"

#include <string>
#include <vector>

namespace shellmatch {

/// The shape named by `source`, a file, "VOLUME:LABELS" (geometry/volume/volume_name.h) or "generate:NAME/VARIANT"
/// (matching/experiment/generated_source.h), repaired for matching. \param closing of a mesh that is not closed
/// \param space the frame of shapes out of volumes \throws InputError where it cannot be used
AnyShape open_shape(const std::string& source, Closing closing = Closing::never, Space space = default_space);

/// The files that `source` names, without what is chosen of a volume; of a volume whose values lie in a file of their own also that one.
/// \throws InputError where a volume's header cannot be read
std::vector<std::string> files_of_shape(const std::string& source);

}  // namespace shellmatch
