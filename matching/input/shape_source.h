#pragma once
/// \file
/// Opens a shape: a file, or a built-in shape.

#include "geometry/io/read_shape.h"

#include <string>

namespace shellmatch {

/// The shape named by `source`, a file or "generate:NAME/VARIANT" (matching/experiment/generated_source.h), repaired
/// for matching. \throws InputError where it cannot be used
/// \param closing of a mesh that is not closed
AnyShape open_shape(const std::string& source, Closing closing = Closing::never);

}  // namespace shellmatch
