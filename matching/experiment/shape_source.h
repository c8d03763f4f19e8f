#pragma once
/// \file
/// Where a shape comes from: a file, or one of the built-in shapes.

#include "geometry/io/read_shape.h"

#include <string>

namespace shellmatch {

/// The shape that `source` names, a file or "generate:NAME/VARIANT" (matching/experiment/generated_source.h), ready for matching.
/// \throws InputError where it cannot be used
AnyShape open_shape(const std::string& source);

}  // namespace shellmatch
