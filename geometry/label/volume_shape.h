#pragma once
/// \file
/// A shape out of a volume: the surface of a label.

#include "geometry/surface/surface.h"
#include "geometry/volume/make_volume.h"
#include "geometry/volume/volume.h"
#include "geometry/volume/volume_name.h"

#include <string>

namespace shellmatch {

/// The surface of the chosen voxels, smoothed as geometry/label/smoothed_label.h says, with triangles of about two
/// thirds of a voxel's side, in the user's coordinates. Its notes state what was chosen, dropped and closed, and the
/// distance of the surface to the voxels' boundary. Files that differ in the order and the direction of their voxels,
/// or in their own frame, give the same surface. \param space the frame of the result \throws InputError as read_volume
/// and label_region, and where the label is too small or too thin for a surface
Shape<3> volume_shape(const VolumeName& name, const std::string& source, Space space);

/// The same of a volume that has been read. \param source for messages
Shape<3> volume_shape(VolumePart part, const std::string& source, Space space);

}  // namespace shellmatch
