#pragma once
/// \file
/// Opens a shape: a file, a part of a volume, or a built-in shape.

#include "geometry/io/read_shape.h"
#include "geometry/surface/space.h"
#include "geometry/volume/make_volume.h"

#include <string>
#include <variant>
#include <vector>

namespace shellmatch {

/// The shape named by `source`, a file, "VOLUME:LABELS" (geometry/volume/volume_name.h) or "generate:NAME/VARIANT"
/// (matching/experiment/generated_source.h), repaired for matching. \param closing of a mesh that is not closed
/// \param space the frame of shapes out of volumes \throws InputError where it cannot be used
AnyShape open_shape(const std::string& source, Closing closing = Closing::never, Space space = default_space);

/// A shape as a program hands it over: the name of a source, or what a file would hold, under a name for messages.
struct ShapeInput {
  std::string name;
  std::variant<std::monostate, OriginalShape<2>, OriginalShape<3>, VolumePart> contents =
      {};  ///< none: what `name` names is opened

  /// Whether the frame of its coordinates is chosen where it is opened.
  bool is_volume() const;
};

/// The same of such an input. \throws InputError
AnyShape open_shape(ShapeInput input, Closing closing = Closing::never, Space space = default_space);

/// The files that `source` names, without what is chosen of a volume; of a volume whose values lie in a file of their
/// own also that one. \throws InputError where a volume's header cannot be read
std::vector<std::string> files_of_shape(const std::string& source);

}  // namespace shellmatch
