#pragma once
/// \file
/// Reads an animation again, by libwebp.

#include "matching/render/canvas/image.h"

#include <string>
#include <vector>

namespace shellmatch::testing {

struct DecodedAnimation {
  std::vector<Image> pictures;
  std::vector<int> ends;  ///< of each picture, milliseconds from the begin
  int n_loops = -1;       ///< 0 is for ever
};

/// No pictures where the bytes are not an animation.
DecodedAnimation decoded_animation(const std::string& bytes);

}  // namespace shellmatch::testing
