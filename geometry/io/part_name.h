#pragma once
/// \file
/// Names of shapes that are parts of pictures or drawings: "cells.png:3", "cells.tif:>100", "rois.zip:NAME",
/// "cells.geojson:NAME".

#include <string>

namespace shellmatch {

struct PartName {
  std::string file;
  std::string part;  ///< empty: none is chosen
};

/// Splits a name at the first colon after the ending of a picture or a drawing; a colon elsewhere belongs to the file's
/// name.
PartName split_part(const std::string& source);

}  // namespace shellmatch
