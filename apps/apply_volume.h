#pragma once
/// \file
/// `apply` to volumes, and fields of the map on the voxels of one.

#include "apps/commands.h"

namespace shellmatch {

/// Whether the command has to do with volumes: it carries one, or writes fields of the map.
bool is_about_volumes(const ApplyCommand& command);

/// \throws InputError where the map is one of the plane, options are missing or in the wrong company, or a file cannot
/// be used
void apply_to_volumes(const ApplyCommand& command);

}  // namespace shellmatch
