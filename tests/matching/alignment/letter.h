#pragma once
/// \file
/// An outline with a gap.

#include "geometry/repair/make_shape.h"

#include <utility>

namespace shellmatch::testing {

/// A letter U of height 1, whose arms have the thickness 0.3 and a gap of `gap` between them.
inline Shape<2> letter(double gap) {
  const double arm = 0.3, width = 2 * arm + gap, bottom = 0.3;
  const Vec<2> corners[] = {{0, 0},        {width, 0}, {width, 1}, {width - arm, 1}, {width - arm, bottom},
                            {arm, bottom}, {arm, 1},   {0, 1}};
  OriginalShape<2> outline;
  outline.polygons.emplace_back();
  for (int c = 0; c < 8; ++c)
    for (int i = 0; i < 50; ++i) {
      outline.polygons[0].push_back(static_cast<Index>(outline.vertices.size()));
      outline.vertices.push_back(corners[c] + (corners[(c + 1) % 8] - corners[c]) * (i / 50.0));
    }
  return make_shape(std::move(outline), "letter");
}

}  // namespace shellmatch::testing
